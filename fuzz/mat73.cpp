// Reads the input as a MATLAB file of version 7.3. isolaw reads such a file in a separate process. If that process
// crashes, isolaw throws an isolaw::Error.
#include "record.hpp"

extern "C" int LLVMFuzzerTestOneInput(std::uint8_t const* data, std::size_t size) {
  using namespace isolaw;
  using enum data::Channel;
  std::string bytes(fuzz::as_text(data, size));
  std::string_view const mark = "MATLAB 7.3 MAT-file";
  if (bytes.size() < mark.size()) return 0;
  bytes.replace(0, mark.size(), mark);
  data::ReadOptions told;
  told.columns = {{time, "none"}, {disp, "1"}, {force, "2"}};
  told.units = {{disp, "cm"}, {force, "tonf"}};
  fuzz::read_record(bytes, "record.mat", told);
  return 0;
}
