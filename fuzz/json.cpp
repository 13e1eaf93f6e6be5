// Reads the input as a JSON record.
#include "isolaw/data/files/json_table.hpp"
#include "record.hpp"

extern "C" int LLVMFuzzerTestOneInput(std::uint8_t const* data, std::size_t size) {
  using namespace isolaw;
  using enum data::Channel;
  auto const bytes = fuzz::as_text(data, size);
  if (!data::is_json(bytes)) return -1;  // isolaw reads it as text, and text.cpp tries texts; -1: not for the corpus
  fuzz::read_record(bytes, "record.json", {});
  data::ReadOptions told;
  told.columns = {{time, "none"}, {disp, "1"}, {force, "2"}};
  told.units = {{disp, "cm"}, {force, "tonf"}};
  told.sheet = "1";
  fuzz::read_record(bytes, "record.json", told);
  return 0;
}
