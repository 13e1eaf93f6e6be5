// Reads the input as a MATLAB file of version 5 or 7. Files of version 7.3 have a fuzz target of their own, mat73.cpp,
// because reading them is slow.
#include "isolaw/data/files/mat_table.hpp"
#include "record.hpp"

extern "C" int LLVMFuzzerTestOneInput(std::uint8_t const* data, std::size_t size) {
  using namespace isolaw;
  using enum data::Channel;
  auto const bytes = fuzz::as_text(data, size);
  if (bytes.starts_with("MATLAB 7.3")) return 0;
  // isolaw reads any other input as text, which text.cpp tests. With -1 libFuzzer does not add the input to the corpus.
  if (!data::is_mat(bytes)) return -1;
  fuzz::read_record(bytes, "record.mat", {});
  data::ReadOptions told;
  told.columns = {{time, "none"}, {disp, "1"}, {force, "2"}};
  told.units = {{disp, "cm"}, {force, "tonf"}};
  fuzz::read_record(bytes, "record.mat", told);
  told.sheet = "1";
  fuzz::read_record(bytes, "record.mat", told);
  return 0;
}
