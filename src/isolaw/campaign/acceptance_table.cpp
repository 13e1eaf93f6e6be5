#include "isolaw/campaign/acceptance_table.hpp"

#include <fmt/format.h>

#include "isolaw/base/printable.hpp"

namespace isolaw::campaign {
namespace {

Limits lot_sizes() {
  return {.least = 1, .most = 10'000'000, .words = "a whole number of devices, 1 to 10000000"};
}

Json or_null(std::string const& text) {
  return text.empty() ? Json() : Json(text);
}

void set_rules(Acceptance& to, Json const& value) {
  if (text_in(value).empty()) refuse(value, "a built-in rule set, or a file");
  to.rules_file = text_in(value);
  to.rules.clear();
}

// {"K_eff": 1.2, "damping": 15} adds to what is there; text takes its place.
void set_design(Acceptance& to, Json const& value) {
  if (!value.is_object()) {
    to.design = text_in(value);
    return;
  }
  for (auto const& [key, item] : value.items()) {
    if (!item.is_number())
      throw Error(
          {.where = {}, .found = fmt::format("design.{} is no number", key), .allowed = "K_eff = 1.2, damping = 15.0"});
    to.design += fmt::format("{}{}={}", to.design.empty() ? "" : ",", key, item.get<double>());
  }
}

std::vector<Option<Acceptance>> make_table() {
  return {
      text<Acceptance>(
          "rules", Kind::text, "rule set the tests are held to: a name (isolaw rules) or a file",
          [](Acceptance const& a) { return or_null(a.rules_file); }, set_rules),
      text<Acceptance>(
          "design", Kind::assignments, "design values: K_eff=1.2,damping=15,disp=150,frequency=0.5,...",
          [](Acceptance const& a) { return or_null(a.design); }, set_design),
      number<Acceptance>(
          "lot-size", "devices of the production lot, tested or not", [](auto& a) -> auto& { return a.lot_size; },
          lot_sizes()),
  };
}

}  // namespace

std::span<Option<Acceptance> const> acceptance_table() {
  static std::vector<Option<Acceptance>> const table = make_table();
  return table;
}

int parse_lot_size(std::string_view text) {
  return whole_of(value_of(Kind::whole, {std::string(text)}), lot_sizes());
}

}  // namespace isolaw::campaign
