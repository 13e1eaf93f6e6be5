// Reads the input as an .xlsx workbook.
#include "isolaw/data/files/workbook.hpp"
#include "record.hpp"

extern "C" int LLVMFuzzerTestOneInput(std::uint8_t const* data, std::size_t size) {
  using namespace isolaw;
  using enum data::Channel;
  auto const bytes = fuzz::as_text(data, size);
  // isolaw reads any other input as text, which text.cpp tests. With -1 libFuzzer does not add the input to the corpus.
  if (!data::is_zip(bytes)) return -1;
  fuzz::read_record(bytes, "record.xlsx", {});
  data::ReadOptions told;
  told.columns = {{time, "none"}, {disp, "A"}, {force, "B"}};
  told.units = {{disp, "cm"}, {force, "tonf"}};
  told.sheet = "1";
  told.test = "all";
  fuzz::read_record(bytes, "record.xlsx", told);
  return 0;
}
