// Gives every file of the named folders to the fuzz target that is linked with this main(). The inputs of fuzz/corpus
// thus become an ordinary test, which needs no libFuzzer. The test fails if the folders have no files.
#include <algorithm>
#include <fstream>
#include <iterator>
#include <vector>

#include "harness.hpp"

int main(int argc, char** argv) {
  std::size_t count = 0;
  for (int i = 1; i < argc; ++i) {
    std::vector<std::filesystem::path> files;
    for (auto const& entry : std::filesystem::recursive_directory_iterator(argv[i]))
      if (entry.is_regular_file()) files.push_back(entry.path());
    std::ranges::sort(files);
    for (auto const& file : files) {
      std::ifstream stream(file, std::ios::binary);
      std::vector<char> const bytes((std::istreambuf_iterator<char>(stream)), std::istreambuf_iterator<char>());
      std::vector<std::uint8_t> const data(bytes.begin(), bytes.end());
      std::fprintf(stderr, "%s\n",
                   file.filename().c_str());  // if the target crashes, the last name shows the file
      LLVMFuzzerTestOneInput(data.data(), data.size());
      ++count;
    }
  }
  std::printf("%zu inputs\n", count);
  return count > 0 ? 0 : 1;
}
