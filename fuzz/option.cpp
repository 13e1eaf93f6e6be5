// Reads the input as the text of each option, header or key that has a syntax of its own. A text that is accepted must
// be written back as a text with the same meaning.
#include "harness.hpp"
#include "isolaw/api/parameters.hpp"
#include "isolaw/campaign/contents.hpp"
#include "isolaw/campaign/stated_quantity.hpp"
#include "isolaw/data/channels/ground_motion.hpp"
#include "isolaw/data/channels/read_options.hpp"
#include "isolaw/data/cycles/selection.hpp"
#include "isolaw/data/files/row_range.hpp"
#include "isolaw/data/files/time_stamp.hpp"
#include "isolaw/data/files/unit_text.hpp"
#include "isolaw/data/properties/vertical.hpp"
#include "isolaw/fit/box.hpp"
#include "isolaw/programs/layout.hpp"
#include "isolaw/rules/measured.hpp"

extern "C" int LLVMFuzzerTestOneInput(std::uint8_t const* bytes, std::size_t size) {
  using namespace isolaw;
  auto const text = fuzz::as_text(bytes, size);
  fuzz::attempt([&] { data::parse_columns(text); });
  fuzz::attempt([&] { data::parse_units(text); });
  fuzz::attempt([&] { data::parse_scales(text); });
  fuzz::attempt([&] { data::parse_test(text); });
  fuzz::attempt([&] { campaign::parse_laws(text); });
  fuzz::attempt([&] { campaign::parse_lot_size(text); });
  fuzz::attempt([&] { rules::parse_design(text); });
  fuzz::attempt([&] { parse_named_value(text, "--set"); });
  fuzz::attempt([&] {
    auto const rows = data::parse_rows(text);
    fuzz::require(data::parse_rows(data::rows_text(rows)) == rows, "rows read back the same");
  });
  fuzz::attempt([&] {
    auto const numbers = data::parse_numbers("--fit-cycles", text);
    fuzz::require(data::parse_numbers("--fit-cycles", numbers.text()) == numbers, "numbers read back the same");
  });
  fuzz::attempt([&] {
    auto const loads = data::parse_loads(text);
    fuzz::require(data::parse_loads(data::loads_text(loads)) == loads, "loads read back the same");
  });
  fuzz::attempt([&] {
    auto const part = campaign::parse_part(text);
    fuzz::require(campaign::parse_part(campaign::text(part)) == part, "a part reads back the same");
  });
  fuzz::attempt([&] {
    auto const written = fit::parse_override(text).text();
    fuzz::require(fit::parse_override(written).text() == written, "an override reads back the same");
  });
  for (auto const measure : {campaign::Measure::temperature_C, campaign::Measure::length_mm})
    campaign::stated(text, measure);
  data::parse_unit_text(text);
  data::sensitivity_in(text, "V");
  data::without_sensitivity(std::string(text));
  data::scale_hint(text, Dimension::force);
  data::parse_acceleration(text);
  data::may_be_date(text);
  if (auto const stamp = data::parse_stamp(text)) data::kind_of(*stamp);
  if (auto const found = programs::number_and_unit(text)) programs::parse_stiffness(found->second);
  return 0;
}
