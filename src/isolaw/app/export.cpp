#include "isolaw/api/export.hpp"

#include <algorithm>
#include <cstdio>

#include "isolaw/app/commands.hpp"
#include "isolaw/app/output.hpp"
#include "isolaw/app/say.hpp"
#include "isolaw/campaign/store.hpp"

namespace isolaw::app {

int export_law(ExportArguments const& a) {
  auto const exported = isolaw::export_law(campaign::Store::read(a.directory / "campaign.sqlite"), a.options);
  for (auto const& sentence : exported.doubts) say("{}\n", sentence);
  std::vector<std::filesystem::path> inputs(a.options.motions.begin(), a.options.motions.end());
  for (auto const* key : {"layout", "ground-motion", "ground-motion-y"})
    if (auto const given = a.options.model.find(key); given != a.options.model.end())
      inputs.emplace_back(text_of(given->second));
  if (!a.out) {
    std::fwrite(exported.text.data(), 1, exported.text.size(), stdout);
    return exit_done;
  }
  write_output(*a.out, exported.text, inputs);
  say("{}\n", shown(*a.out));
  return exit_done;
}

}  // namespace isolaw::app
