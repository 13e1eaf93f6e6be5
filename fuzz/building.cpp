// Reads the input as a building file. The motions in it can name "m.csv", a valid record that this fuzz target writes.
#include <cmath>

#include "harness.hpp"
#include "isolaw/base/write_file.hpp"
#include "isolaw/building/building_file.hpp"

extern "C" int LLVMFuzzerTestOneInput(std::uint8_t const* data, std::size_t size) {
  using namespace isolaw;
  static fuzz::Folder const folder;
  static auto const motion = [] {
    auto file = folder.path() / "m.csv";
    write_file(file, "t [s],a [g]\n0,0\n1,0\n2,0\n3,0\n4,0.1\n5,-0.1\n6,0\n7,0\n8,0\n9,0\n");
    return file;
  }();
  try {
    auto const file = building::read_building_text(fuzz::as_text(data, size), "building.toml", folder.path());
    fuzz::require(is_printable(file.settings.title), "the title is printable");
    fuzz::require(!file.bearings.empty() && !file.motions.empty(), "there are bearings and motions");
    for (auto const& bearing : file.bearings) fuzz::require(is_printable(bearing.device), "names are printable");
    for (auto const& each : file.motions) building::require_sound(each);
    fuzz::require(!file.plan().bearings.empty(), "the plan has its bearings");
  } catch (Error const& error) {
    fuzz::require_plain_message(error);
  }
  return 0;
}
