// The bytes of a campaign's store, reported as `isolaw report` does.
#include <fstream>
#include <nlohmann/json.hpp>

#include "harness.hpp"
#include "isolaw/campaign/store.hpp"
#include "isolaw/render/figures/figures.hpp"
#include "isolaw/render/json/summary_json.hpp"
#include "isolaw/render/page/html.hpp"
#include "isolaw/render/tables/latex_tables.hpp"
#include "isolaw/render/tables/tables.hpp"
#include "isolaw/render/terminal/terminal.hpp"
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
    fuzz::require(nlohmann::json::accept(render::summary_json(summary)), "summary.json is JSON");
    fuzz::require(render::html(summary).find("</html>") != std::string::npos, "the page is whole");
    render::parameters_csv(summary);
    render::objective_csv(summary);
    render::robustness_csv(summary);
    render::cycles_csv(summary);
    render::tests_csv(summary);
    render::lot_csv(summary);
    render::lambda_csv(summary);
    render::table_a5_csv(summary);
    render::table_a5_tex(summary);
    render::robustness_tex(summary);
    render::front_csv(summary);
    render::front_tex(summary);
    render::for_each_figure(summary, render::FigureChoice::all, [](render::Figure const&) {});
    render::ranking(summary, 80);
  } catch (Error const& error) {
    fuzz::require_plain_message(error);
  }
  return 0;
}
