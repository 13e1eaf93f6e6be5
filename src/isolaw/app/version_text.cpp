#include <fmt/format.h>

#include "isolaw/app/app.hpp"
#include "isolaw/campaign/maker.hpp"

namespace isolaw::app {

extern char const* const source_commit;  // cmake/commit.cmake defines it at every build

namespace {

std::string compiler_text() {
#if defined(__EMSCRIPTEN__)
  return fmt::format("emscripten's clang++ {}.{}.{}", __clang_major__, __clang_minor__, __clang_patchlevel__);
#elif defined(__clang__)
  return fmt::format("clang++ {}.{}.{}", __clang_major__, __clang_minor__, __clang_patchlevel__);
#elif defined(__GNUC__)
  return fmt::format("g++ {}.{}.{}", __GNUC__, __GNUC_MINOR__, __GNUC_PATCHLEVEL__);
#else
  return "unknown compiler";
#endif
}

}  // namespace

std::string version_text() {
  auto const maker = campaign::this_maker();
  return fmt::format("isolaw {} ({})\n{}, {}\nbuild {}", maker.version, source_commit, compiler_text(),
                     maker.instruction_set, maker.build);
}

}  // namespace isolaw::app
