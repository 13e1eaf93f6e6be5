// Reads the input as an .xlsx workbook.
#include "isolaw/data/files/workbook.hpp"
#include "record.hpp"

extern "C" int LLVMFuzzerTestOneInput(std::uint8_t const* data, std::size_t size) {
  using namespace isolaw;
  using enum data::Channel;
  auto const bytes = fuzz::as_text(data, size);
  if (!data::is_zip(bytes)) return -1;  // isolaw reads it as text, and text.cpp tries texts; -1: not for the corpus
  fuzz::read_record(bytes, "record.xlsx", {});
  data::ReadOptions told;
  told.columns = {{time, "none"}, {disp, "A"}, {force, "B"}};
  told.units = {{disp, "cm"}, {force, "tonf"}};
  told.sheet = "1";
  told.test = "all";
  fuzz::read_record(bytes, "record.xlsx", told);
  return 0;
}
