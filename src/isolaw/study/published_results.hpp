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
    {"number", "", "law of the study", "number of the law in the study, 1 to 6", get<&PublishedLaw::number>},
    {"law", "", "law", "id of the law; `abe` and `abe-y0` are two readings of law 5", get<&PublishedLaw::law>},
    {"compared", "", "",
     "true: the campaign has this law, and `published.statements` are judged by it; if it has both readings of law 5, only `abe-y0` is compared",
     get<&PublishedLaw::compared>},
    {"objective", "-", "OF", "objective in this campaign, mean over the devices",
     of_side<&PublishedLaw::computed, &PublishedNumbers::objective>},
    {"published_objective", "-", "OF, published", "objective in Table A.5 of the study, mean over the devices",
     of_side<&PublishedLaw::printed, &PublishedNumbers::objective>},
    {"std_over_runs", "-", "std over runs",
     "standard deviation of the objective over the runs on a device, mean over the devices",
     of_side<&PublishedLaw::computed, &PublishedNumbers::std_over_runs>},
    {"published_std_over_runs", "-", "std over runs, published",
     "standard deviation of the objective over the runs in Table A.5, mean over the devices",
     of_side<&PublishedLaw::printed, &PublishedNumbers::std_over_runs>},
    {"std_over_devices", "-", "std over devices", "standard deviation of the devices' mean objectives",
     of_side<&PublishedLaw::computed, &PublishedNumbers::std_over_devices>},
    {"published_std_over_devices", "-", "std over devices, published",
     "standard deviation of the devices' mean objectives in Table A.5",
     of_side<&PublishedLaw::printed, &PublishedNumbers::std_over_devices>},
    {"beta", "-", "beta", "`beta` of `laws[]`", of_side<&PublishedLaw::computed, &PublishedNumbers::beta>},
    {"published_beta", "-", "beta, published", "beta from Table A.5",
     of_side<&PublishedLaw::printed, &PublishedNumbers::beta>},
    {"on_front", "", "on front",
     "true: of the laws compared, none is at least as good in both `objective` and `beta`, and better in one",
     of_side<&PublishedLaw::computed, &PublishedNumbers::on_front>},
    {"published_on_front", "", "on front, published",
     "true: by the values of Table A.5 no other of the six laws is at least as good in both objective and beta, and better in one",
     of_side<&PublishedLaw::printed, &PublishedNumbers::on_front>},
};

inline constexpr Result<PublishedStatement> published_statement_results[]{
    {"where", "", "where", "place of the statement in the study", get<&PublishedStatement::where>},
    {"text", "", "statement", "the statement in our words", get<&PublishedStatement::text>},
    {"here", "", "here", "whether the statement holds in this campaign", get<&PublishedStatement::holds_here>},
    {"in_table", "", "in Table A.5", "whether the statement holds in the study's own table",
     get<&PublishedStatement::holds_in_table>},
    {"found", "", "found here", "the numbers of this campaign, or what is missing", get<&PublishedStatement::found>},
};

}  // namespace isolaw::study
