#include <fmt/format.h>

#include <cstdio>

#include "isolaw/app/commands.hpp"
#include "isolaw/app/say.hpp"
#include "isolaw/base/error.hpp"
#include "isolaw/campaign/setting_table.hpp"
#include "isolaw/campaign/store.hpp"
#include "isolaw/render/tables/tables.hpp"
#include "isolaw/study/build_summary.hpp"
#include "isolaw/study/draws.hpp"

namespace isolaw::app {

int sample(SampleArguments const& a) {
  study::require_draws(a.count);
  laws::find_law(a.law);
  auto const contents = campaign::Store::read(a.directory / "campaign.sqlite");
  auto const summary = study::build_summary(contents);
  auto settings = contents.settings;
  campaign::apply(a.seed, settings);
  auto const drawn = study::draw_devices(contents, summary, a.law, static_cast<std::size_t>(a.count), settings.seed,
                                         a.directory.string());
  std::string text = "device";
  for (auto const& p : *drawn.parameters) text += "," + render::csv_cell(fmt::format("{} [{}]", p.name, p.unit));
  text += '\n';
  for (std::size_t i = 0; i < drawn.values.size(); ++i) {
    text += fmt::format("{}", i + 1);
    for (double const value : drawn.values[i]) text += fmt::format(",{}", value);
    text += '\n';
  }
  std::fwrite(text.data(), 1, text.size(), stdout);
  for (auto const& sentence : study::sentences(drawn)) say("{}\n", sentence);
  return exit_done;
}

}  // namespace isolaw::app
