// Reads the input as a JSON record.
#include "isolaw/data/files/json_table.hpp"
#include "record.hpp"

extern "C" int LLVMFuzzerTestOneInput(std::uint8_t const* data, std::size_t size) {
  using namespace isolaw;
  using enum data::Channel;
  auto const bytes = fuzz::as_text(data, size);
  // isolaw reads any other input as text, which text.cpp tests. With -1 libFuzzer does not add the input to the corpus.
  if (!data::is_json(bytes)) return -1;
  fuzz::read_record(bytes, "record.json", {});
  data::ReadOptions told;
  told.columns = {{time, "none"}, {disp, "1"}, {force, "2"}};
  told.units = {{disp, "cm"}, {force, "tonf"}};
  told.sheet = "1";
  fuzz::read_record(bytes, "record.json", told);
  return 0;
}
