// The answer of a campaign in words: which law to take and why, how sure that is, how the laws compare.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cstddef>

#include "isolaw/base/number_text.hpp"
#include "isolaw/base/words.hpp"
#include "isolaw/laws/catalogue.hpp"
#include "isolaw/wording/sentences.hpp"
#include "isolaw/wording/words.hpp"

namespace isolaw::wording {
namespace {

std::string names_of(std::vector<std::string> const& laws, std::size_t most = 5) {
  std::vector<std::string> names;
  for (auto const& id : laws) names.emplace_back(laws::called(id));
  return enumerate(names, most);
}

// Errors differ in their third digit, so they keep one decimal.
std::string error_text(double fraction) {
  return with_decimals(100.0 * fraction, 1) + " %";
}

// " of those that describe the devices", where some do not; "the least of all" is what a comparison ends with.
std::string among(Finding const& f) {
  return f.word("among") == "adequate" ? " of those that describe the devices" : "";
}
std::string least_of(Finding const& f) {
  return f.word("among") == "adequate"  ? "the least of those that describe the devices"
         : f.word("among") == "unboxed" ? "the least that no search box decides"
                                        : "the least of all";
}

std::string misfit(Finding const& f) {
  return fmt::format("misses the measured force by {} of its standard deviation on average",
                     error_text(f.number("misfit")));
}

std::string scatter(Finding const& f) {
  return fmt::format("its parameters lie up to {} from the lot's mean, averaged over the parameters",
                     percent(f.number("beta")));
}

std::string_view purpose(Finding const& f) {
  if (f.word("purpose") == "these-tests") return "these tests";
  return f.word("purpose") == "simplest" ? "the simplest choice" : "devices and amplitudes that were not tested";
}

}  // namespace

std::string law_recommended(Group group) {
  auto const& f = group.front();
  bool const tests_only = f.word("elsewhere") == "no";
  auto text = fmt::format("{} {}{}: it is {} off {}.", tests_only ? "For these tests take" : "Take", law_name(f),
                          f.word("sure") == "weak" ? ", with care" : "", percent(f.number("error")), f.word("measure"));
  if (!f.other_laws.empty())
    text += fmt::format(" {} {} as good.", names_of(f.other_laws), f.other_laws.size() == 1 ? "is" : "are");
  if (tests_only) text += " For other devices or amplitudes no law can be recommended.";
  return text;
}

std::string no_law_recommended(Group group) {
  return fmt::format("No law can be recommended for {}.", purpose(group.front()));
}

std::string why_error(Group group) {
  auto const& f = group.front();
  auto const count = static_cast<std::size_t>(f.number("parameters"));
  return fmt::format("{} is {} off {}{}.", law_name(f), percent(f.number("error")), f.word("measure"),
                     count > 0 ? ", with " + counted(count, "parameter") : "");
}

std::string why_simpler(Group group) {
  auto const& f = group.front();
  return fmt::format("The most accurate law, {}, is {} off and has {} parameters.", law_name(f),
                     percent(f.number("error")), f.number("parameters"));
}

std::string why_ties(Group group) {
  auto const& f = group.front();
  return fmt::format("{} {} from it by less than {}.", names_of(f.other_laws),
                     f.other_laws.size() == 1 ? "differs" : "differ",
                     f.number("devices") > 1.0 ? "the scatter over the devices" : "one device can tell");
}

std::string why_next(Group group) {
  auto const& f = group.front();
  return fmt::format("The next best, {}, is {} off.", law_name(f), percent(f.number("error")));
}

std::string why_closer_refused(Group group) {
  auto const& f = group.front();
  return fmt::format("{} is nearer to the tests ({}), but its prediction is {}.", law_name(f),
                     percent(f.number("error")), f.word("grade"));
}

std::string none_identified(Group) {
  return "No law could be identified.";
}
std::string none_describes(Group group) {
  auto const& laws = group.front().other_laws;
  return fmt::format("{} {} not describe the devices.", names_of(laws), laws.size() == 1 ? "does" : "do");
}
std::string none_predicts(Group group) {
  auto const& laws = group.front().other_laws;
  return fmt::format("{} {} not predict the blocks that {} not fitted to.", names_of(laws),
                     laws.size() == 1 ? "does" : "do", laws.size() == 1 ? "it was" : "they were");
}
std::string none_on_every_device(Group group) {
  auto const& laws = group.front().other_laws;
  return fmt::format("{} {} not identified on every device.", names_of(laws), laws.size() == 1 ? "was" : "were");
}
std::string none_has_error(Group) {
  return "No law has an error that could be compared.";
}
std::string none_left_out(Group) {
  return "Every block was fitted and no device was left out of the lot's law; --analysis full leaves devices out.";
}
std::string none_beside_one_device(Group) {
  return "One device was tested and every block was fitted, so nothing shows how a law holds elsewhere.";
}

std::string weak_prediction_fair(Group) {
  return "its prediction of blocks that it was not fitted to is only fair";
}
std::string weak_error(Group group) {
  auto const& f = group.front();
  return fmt::format("an error of {} is only {}", percent(f.number("error")), f.word("grade"));
}
std::string weak_only_law(Group) {
  return "no other law was identified to compare it with";
}
std::string weak_incomplete(Group) {
  return "the campaign is not complete";
}
std::string weak_search(Group group) {
  double const share = group.front().number("share");
  return share == 0.0 ? "none of its searches reached the best fit found"
                      : fmt::format("only {} of its searches reached the best fit found", percent(share));
}
std::string weak_bounds(Group group) {
  auto const& f = group.front();
  return fmt::format("{} of its {} parameters lie at a bound on half of the devices or more", f.number("count"),
                     f.number("calibrated"));
}
std::string weak_open(Group group) {
  return fmt::format("the tests cannot fix {} of its parameters", percent(group.front().number("share")));
}

std::string surer_finish(Group) {
  return "finish the campaign with the same command";
}
std::string surer_other_laws(Group) {
  return "identify other laws to compare it with (--laws)";
}
std::string surer_fit_blocks(Group) {
  return "keep an amplitude or rate from the fit (--fit-blocks)";
}
std::string surer_other_amplitude(Group) {
  return "test another amplitude or rate and keep it from the fit";
}
std::string surer_further_test(Group) {
  return "make a further test and keep it from a fit to every block";
}
std::string surer_more_devices(Group group) {
  auto const devices = group.front().number("devices");
  return devices > 1.0 ? fmt::format("test more than these {} devices", devices) : "test more devices";
}
std::string surer_amplitude_between(Group) {
  return "test an amplitude between those there";
}

std::string out_not_identified(Group) {
  return "was not identified";
}
std::string out_inadequate(Group) {
  return "does not describe the devices";
}
std::string out_prediction(Group group) {
  return fmt::format("its prediction is {}", group.front().word("grade"));
}
std::string out_partial(Group) {
  return "was not identified on every device";
}
std::string out_unknown(Group) {
  return "nothing shows how it holds elsewhere";
}
std::string out_error(Group group) {
  return fmt::format("its error is {}", group.front().word("grade"));
}

std::string not_in_opensees(Group) {
  return "OpenSees has no such material. isolaw writes one to compile: export --to opensees-cpp";
}

std::string headline_only_law(Group group) {
  return fmt::format("{} is the only law that was identified.", law_name(group.front()));
}
std::string headline_best_of_both(Group group) {
  auto const& f = group.front();
  return fmt::format("{} is both the most accurate and the most robust law{}.", law_name(f), among(f));
}
std::string headline_most_accurate(Group group) {
  auto const& f = group.front();
  return fmt::format("{} is the most accurate law{}; how robust it is cannot be said.", law_name(f), among(f));
}
std::string headline_scatter_by_box(Group group) {
  auto const& f = group.front();
  return fmt::format("{} is the most accurate law{}; the laws that scatter less are held together by their search box.",
                     law_name(f), among(f));
}
std::string headline_choice(Group group) {
  auto const& f = group.front();
  auto text = fmt::format("{} of {} laws are worth considering: choose between accuracy ({}) and robustness ({}).",
                          f.number("considered"), f.number("laws"), law_name(f), laws::called(f.other_laws.front()));
  if (f.other_laws.size() > 1)
    text += fmt::format(" The best compromise is {}.", laws::called(f.other_laws[1]));
  else if (f.word("none_between") == "yes")
    text +=
        " No law between them holds up: each leaves the front when the optimiser's noise is taken out, is held by its search box, or does not predict.";
  return text;
}
std::string headline_nearest(Group group) {
  auto const& f = group.front();
  return fmt::format("No law describes these devices. The nearest is {}.", law_name(f));
}

std::string role_best_of_both(Group group) {
  auto const& f = group.front();
  return fmt::format("No law{} is more accurate and none is more robust: it {}, and {}.", among(f), misfit(f),
                     scatter(f));
}
std::string role_alone(Group group) {
  auto const& f = group.front();
  return fmt::format("It {}; {}.", misfit(f), scatter(f));
}
std::string role_most_robust(Group group) {
  auto const& f = group.front();
  return fmt::format("{}, {}. The price is an error of {} against {} for {}.", capitalised(scatter(f)), least_of(f),
                     error_text(f.number("misfit")), error_text(f.number("other_misfit")), names_of(f.other_laws));
}
std::string role_between(Group group) {
  auto const& f = group.front();
  return fmt::format("It scatters less than {} ({} against {}) and errs less than {} ({} against {}).",
                     laws::called(f.other_laws[0]), percent(f.number("beta")), percent(f.number("accurate_beta")),
                     laws::called(f.other_laws[1]), error_text(f.number("misfit")),
                     error_text(f.number("robust_misfit")));
}
std::string role_dominated(Group group) {
  auto const& f = group.front();
  return fmt::format("{} {} at least as accurate and as robust (this law: error {}, scatter {}).",
                     names_of(f.other_laws), f.other_laws.size() == 1 ? "is" : "are", error_text(f.number("misfit")),
                     percent(f.number("beta")));
}
std::string role_not_on_front(Group group) {
  auto const& f = group.front();
  return fmt::format("It is not on the front (error {}, scatter {}).", error_text(f.number("misfit")),
                     percent(f.number("beta")));
}
std::string role_not_identified(Group) {
  return "It was not identified on any device.";
}
std::string role_least_error(Group group) {
  auto const& f = group.front();
  return f.word("among") == "only" ? fmt::format("It {}.", misfit(f))
                                   : fmt::format("It {}, {}.", misfit(f), least_of(f));
}
std::string role_behind(Group group) {
  auto const& f = group.front();
  return fmt::format("Its mean error is {}, {} times that of {}.", error_text(f.number("misfit")),
                     with_decimals(f.number("misfit") / f.number("other_misfit"), 2), names_of(f.other_laws));
}
std::string role_no_beta(Group group) {
  return fmt::format("It has no beta: {}.", group.front().word("note"));
}

std::string converged_front(Group group) {
  auto const& f = group.front();
  auto const front = names_of(f.other_laws, f.other_laws.size());
  if (f.word("same") == "yes") return fmt::format("Without the optimiser's noise the front is the same: {}.", front);
  auto const of_runs = f.word("of_runs");
  return fmt::format("Without the optimiser's noise the front is {}{}.", front,
                     of_runs.empty() ? "" : fmt::format("; of the mean of the runs it is {}", of_runs));
}
std::string converged_beta(Group group) {
  std::vector<std::string> changes;
  for (auto const& f : group) {
    std::vector<std::string> reasons;
    if (f.word("reduced") == "yes") reasons.emplace_back("in its reduced form");
    if (!f.parameters.empty()) reasons.push_back("without " + enumerate(f.parameters, 4));
    changes.push_back(fmt::format("{} {} instead of {}{}", law_name(f), percent(f.number("beta_converged")),
                                  percent(f.number("beta")),
                                  reasons.empty() ? "" : fmt::format(" ({})", fmt::join(reasons, ", "))));
  }
  return fmt::format(
      "From the best fits, without the parameters that the tests cannot fix or the search box decides, beta changes: {}.",
      fmt::join(changes, ", "));
}
std::string converged_untested(Group group) {
  auto const& f = group.front();
  auto text = fmt::format(
      "Taken for a device that was not tested, the one law of the lot is {} wrong on average with {}, {}, and {} at worst ({})",
      error_text(f.number("error")), law_name(f),
      f.word("among") == "all" ? "the least of all" : "the least of those that describe the devices and predict",
      error_text(f.number("worst")), enumerate(f.devices));
  if (f.has_number("fitted"))
    text += fmt::format("; fitted to each device it would be {}", error_text(f.number("fitted")));
  return text + ".";
}
std::string converged_prediction(Group group) {
  auto const& f = group.front();
  auto text = fmt::format(
      "{} predicts the blocks that the laws were not fitted to best: {} (objective {}, against {} where it was fitted)",
      law_name(f), f.word("grade"), number_text(f.number("predicted"), 3), number_text(f.number("fitted"), 3));
  if (!f.other_laws.empty()) text += fmt::format("; the prediction of {} is unusable", names_of(f.other_laws));
  return text + ".";
}
std::string converged_no_prediction(Group group) {
  return fmt::format("No law that was fitted to some blocks predicts the others: {}.",
                     names_of(group.front().other_laws));
}
std::string converged_determined(Group group) {
  std::vector<std::string> parts;
  for (auto const& f : group)
    parts.push_back(fmt::format("{} {} (and {} weakly)", law_name(f), percent(f.number("determined")),
                                percent(f.number("weakly"))));
  return fmt::format("Share of the parameters that the tests fix: {}.", fmt::join(parts, ", "));
}

}  // namespace isolaw::wording
