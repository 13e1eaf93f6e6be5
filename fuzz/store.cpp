// The bytes of a campaign's store, reported as `isolaw report` does.
#include <fstream>
#include <nlohmann/json.hpp>

#include "harness.hpp"
#include "isolaw/campaign/store.hpp"
#include "isolaw/report/build_summary.hpp"
#include "isolaw/report/figures.hpp"
#include "isolaw/report/html.hpp"
#include "isolaw/report/latex_tables.hpp"
#include "isolaw/report/summary_json.hpp"
#include "isolaw/report/tables.hpp"
#include "isolaw/report/terminal.hpp"

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
    auto const summary = report::build_summary(campaign::Store::read(file));
    fuzz::require(nlohmann::json::accept(report::summary_json(summary)), "summary.json is JSON");
    fuzz::require(report::html(summary).find("</html>") != std::string::npos, "the page is whole");
    report::parameters_csv(summary);
    report::objective_csv(summary);
    report::robustness_csv(summary);
    report::cycles_csv(summary);
    report::tests_csv(summary);
    report::lot_csv(summary);
    report::lambda_csv(summary);
    report::table_a5_csv(summary);
    report::table_a5_tex(summary);
    report::robustness_tex(summary);
    report::front_csv(summary);
    report::front_tex(summary);
    report::for_each_figure(summary, report::FigureChoice::all, [](report::Figure const&) {});
    report::ranking(summary, 80);
  } catch (Error const& error) {
    fuzz::require_plain_message(error);
  }
  return 0;
}
