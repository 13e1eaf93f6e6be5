// Reads the input as a JSON record.
#include "record.hpp"

extern "C" int LLVMFuzzerTestOneInput(std::uint8_t const* data, std::size_t size) {
  using namespace isolaw;
  using enum data::Channel;
  auto const bytes = fuzz::as_text(data, size);
  fuzz::read_record(bytes, "record.json", {});
  data::ReadOptions told;
  told.columns = {{time, "none"}, {disp, "1"}, {force, "2"}};
  told.units = {{disp, "cm"}, {force, "tonf"}};
  told.sheet = "1";
  fuzz::read_record(bytes, "record.json", told);
  return 0;
}
