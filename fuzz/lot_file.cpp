// Reads the input as a lot file. If this succeeds, the lot is written to a text again, and reading that text must give
// the same lot.
#include "isolaw/campaign/lot_file.hpp"
#include "harness.hpp"

extern "C" int LLVMFuzzerTestOneInput(std::uint8_t const* data, std::size_t size) {
  using namespace isolaw;
  std::filesystem::path const folder = "/nowhere/lot";
  try {
    auto const lot = campaign::read_lot_text(fuzz::as_text(data, size), folder / "lot.toml");
    fuzz::require(lot.devices.size() <= campaign::most_devices, "the number of devices is bounded");
    fuzz::require(is_printable(lot.title), "the title is printable");
    for (auto const& device : lot.devices) {
      fuzz::require(is_printable(device.name) && is_printable(device.shown_file()), "names are printable");
      for (auto const& file : campaign::files_of(device))
        fuzz::require(!file.lexically_normal().lexically_relative(folder).empty() &&
                          *file.lexically_normal().lexically_relative(folder).begin() != "..",
                      "files lie in the folder");
    }
    auto const text = campaign::lot_file_text(lot, folder);
    auto const again = campaign::lot_file_text(campaign::read_lot_text(text, folder / "lot.toml"), folder);
    fuzz::require(text == again, "a lot file written reads back the same");
  } catch (Error const& error) {
    fuzz::require_plain_message(error);
  }
  return 0;
}
