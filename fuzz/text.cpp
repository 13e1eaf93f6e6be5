// Reads the input as a record in delimited text, for example CSV.
#include "record.hpp"

extern "C" int LLVMFuzzerTestOneInput(std::uint8_t const* data, std::size_t size) {
  using namespace isolaw;
  using enum data::Channel;
  auto const bytes = fuzz::as_text(data, size);
  fuzz::read_record(bytes, "record.csv", {});
  data::ReadOptions told;
  told.columns = {{time, "none"}, {disp, "1"}, {force, "2"}};
  told.units = {{disp, "cm"}, {force, "tonf"}};
  told.dt_s = 0.01;
  told.flip_force = true;
  told.test = "all";
  told.rows = data::RowRange{.first = 2, .last = std::nullopt};
  told.from_s = 0.02;
  told.to_s = 1e5;
  told.thousands = ',';
  told.skip_footer = true;
  told.date_order = data::DateOrder::month_first;
  told.corrections.repair_spikes = true;
  fuzz::read_record(bytes, "record.csv", told);
  return 0;
}
