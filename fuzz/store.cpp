// Reads the input as the SQLite file of a campaign and makes its report, as `isolaw report` does.
#include <fstream>
#include <nlohmann/json.hpp>

#include "harness.hpp"
#include "isolaw/campaign/store.hpp"
#include "isolaw/render/figures/figures.hpp"
#include "isolaw/render/terminal/terminal.hpp"
#include "isolaw/render/write.hpp"
#include "isolaw/study/build_summary.hpp"

extern "C" int LLVMFuzzerTestOneInput(std::uint8_t const* data, std::size_t size) {
  using namespace isolaw;
  static fuzz::Folder const folder;
  auto const file = folder.path() / "campaign.sqlite";
  {
    std::ofstream stream(file, std::ios::binary | std::ios::trunc);
    auto const bytes = fuzz::as_text(data, size);
    stream.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  }
  for (auto const* suffix : {"-wal", "-shm", "-journal"}) {
    std::error_code ignored;
    std::filesystem::remove(file.string() + suffix, ignored);
  }
  try {
    auto const summary = study::build_summary(campaign::Store::read(file));
    for (auto const& [name, text] : render::output_texts(summary)) {
      if (name.ends_with(".json")) fuzz::require(nlohmann::json::accept(text), name.c_str());
      if (name.ends_with(".html")) fuzz::require(text.find("</html>") != std::string::npos, "the page is whole");
    }
    render::for_each_figure(summary, render::FigureChoice::all, [](render::Figure const&) {});
    render::ranking(summary, 80);
  } catch (Error const& error) {
    fuzz::require_plain_message(error);
  }
  return 0;
}
