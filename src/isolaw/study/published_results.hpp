// The comparison with the published study as rows of `published`, for summary.json and the page's data. A test compares
// docs/summary-json.md with them.
#pragma once

#include "isolaw/study/published.hpp"
#include "isolaw/study/results.hpp"

namespace isolaw::study {

template <auto side, auto member>
Value of_side(PublishedLaw const& law) {
  return get<side, member>(law);
}

inline constexpr Result<PublishedLaw> published_law_results[]{
    {"number", "", "law of the study", "number in the study, 1 to 6", get<&PublishedLaw::number>},
    {"law", "", "law", "id; `abe` and `abe-y0` are two readings of law 5", get<&PublishedLaw::law>},
    {"compared", "", "", "the campaign has this law and judges the statements by it; of two readings, the closer one",
     get<&PublishedLaw::compared>},
    {"objective", "-", "OF", "mean over the devices", of_side<&PublishedLaw::here, &PublishedNumbers::objective>},
    {"published_objective", "-", "OF, published", "the same from Table A.5",
     of_side<&PublishedLaw::printed, &PublishedNumbers::objective>},
    {"std_over_runs", "-", "std over runs", "standard deviation of the objective over the runs, mean over the devices",
     of_side<&PublishedLaw::here, &PublishedNumbers::std_over_runs>},
    {"published_std_over_runs", "-", "std over runs, published", "the same from Table A.5",
     of_side<&PublishedLaw::printed, &PublishedNumbers::std_over_runs>},
    {"std_over_devices", "-", "std over devices", "standard deviation of the devices' mean objectives",
     of_side<&PublishedLaw::here, &PublishedNumbers::std_over_devices>},
    {"published_std_over_devices", "-", "std over devices, published", "the same from Table A.5",
     of_side<&PublishedLaw::printed, &PublishedNumbers::std_over_devices>},
    {"beta", "-", "beta", "as for the law", of_side<&PublishedLaw::here, &PublishedNumbers::beta>},
    {"published_beta", "-", "beta, published", "the same from Table A.5",
     of_side<&PublishedLaw::printed, &PublishedNumbers::beta>},
    {"on_front", "", "on front", "on the front of `objective` against `beta`, among the laws compared",
     of_side<&PublishedLaw::here, &PublishedNumbers::on_front>},
    {"published_on_front", "", "on front, published", "the same from Table A.5, among all six",
     of_side<&PublishedLaw::printed, &PublishedNumbers::on_front>},
};

inline constexpr Result<PublishedStatement> published_statement_results[]{
    {"where", "", "where", "place in the study", get<&PublishedStatement::where>},
    {"text", "", "statement", "the statement in our words", get<&PublishedStatement::text>},
    {"here", "", "here", "whether it holds in this campaign", get<&PublishedStatement::here>},
    {"in_table", "", "in Table A.5", "whether it holds in the study's own table", get<&PublishedStatement::in_table>},
    {"found", "", "found here", "the numbers of this campaign, or what is missing", get<&PublishedStatement::found>},
};

}  // namespace isolaw::study
