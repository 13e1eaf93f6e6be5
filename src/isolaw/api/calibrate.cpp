#include "isolaw/api/calibrate.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <string>
#include <string_view>
#include <utility>

#include "isolaw/api/campaign_directory.hpp"
#include "isolaw/base/error.hpp"
#include "isolaw/base/file.hpp"
#include "isolaw/base/words.hpp"
#include "isolaw/campaign/store.hpp"
#include "isolaw/fit/kernels.hpp"
#include "isolaw/render/write.hpp"
#include "isolaw/rules/measured.hpp"
#include "isolaw/rules/rule_set.hpp"
#include "isolaw/study/build_summary.hpp"

namespace isolaw {
namespace {

std::string base64(std::string_view bytes) {  // RFC 4648, with padding
  constexpr std::string_view signs = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    auto const byte = [&](std::size_t k) { return k < bytes.size() ? static_cast<unsigned char>(bytes[k]) : 0U; };
    unsigned const three = byte(i) << 16U | byte(i + 1) << 8U | byte(i + 2);
    for (unsigned k = 0; k < 4; ++k) text += i + k <= bytes.size() ? signs[three >> (18U - 6U * k) & 63U] : '=';
  }
  return text;
}

// Returns the letterhead's picture as a data: address, or its lines of text.
std::string load_letterhead(std::string const& file) {
  constexpr std::size_t largest_bytes = 1'000'000;
  constexpr std::string_view allowed = "a file .svg, .png, .jpg or .txt";
  constexpr std::pair<std::string_view, std::string_view> pictures[]{
      {".svg", "image/svg+xml"}, {".png", "image/png"}, {".jpg", "image/jpeg"}, {".jpeg", "image/jpeg"}};
  auto const ending = lower(std::filesystem::path(file).extension().string());
  auto const picture = std::ranges::find(pictures, ending, &std::pair<std::string_view, std::string_view>::first);
  bool const is_text = ending == ".txt";
  if (picture == std::end(pictures) && !is_text)
    throw Error({.where = "--letterhead", .found = in_quotes(file), .allowed = std::string(allowed)});
  auto const bytes =
      read_file(file, {.largest_bytes = largest_bytes, .allowed = allowed, .when_too_large = "a smaller file"});
  constexpr long most_lines = 12;
  bool const is_whole = is_text            ? std::ranges::count(bytes, '\n') <= most_lines
                        : ending == ".svg" ? bytes.find("<svg") != std::string::npos
                        : ending == ".png" ? bytes.starts_with("\x89PNG")
                                           : bytes.starts_with("\xFF\xD8");
  if (!is_whole)
    throw Error({.where = "--letterhead",
                 .found = in_quotes(file) + (is_text ? " has more than 12 lines" : " holds no such picture"),
                 .allowed = std::string(allowed) + ", text of at most 12 lines"});
  if (is_text) return bytes.substr(0, bytes.find_last_not_of(" \t\r\n") + 1);
  return fmt::format("data:{};base64,{}", picture->second, base64(bytes));
}

}  // namespace

void load_rules(campaign::Acceptance& acceptance) {
  auto& text = acceptance.rules;
  auto const& name = acceptance.rules_file;
  if (text.empty() && !name.empty()) text = rules::load_rule_text(name);
  if (!text.empty()) rules::read_rule_text(text, name);
  if (!acceptance.design.empty()) rules::parse_design(acceptance.design);
  if (acceptance.letterhead.empty() && !acceptance.letterhead_file.empty())
    acceptance.letterhead = load_letterhead(acceptance.letterhead_file);
}

campaign::Contents finish_campaign(campaign::Contents contents, std::filesystem::path const& store,
                                   campaign::RunOptions const& options) {
  if (!campaign::run(contents, store, options)) return contents;
  // Reads the campaign back from the store, so that callers get what another program would read.
  contents = campaign::Store::read(store);
  if (!contents.part) render::write_outputs(study::build_summary(contents), store.parent_path());
  return contents;
}

Calibrated calibrate(std::vector<campaign::NamedRecord> records, campaign::Settings const& settings,
                     CalibrateOptions const& options) {
  fit::instruction_set();  // throws, before anything is written, if the machine lacks the instruction set asked for
  if (options.part) {
    campaign::parse_part(campaign::text(*options.part));
    if (!options.directory)
      throw Error({.where = "part " + campaign::text(*options.part),
                   .found = "no directory",
                   .allowed = "a directory of its own for each part, from which they are merged",
                   .advice = "out=DIR"});
  }
  auto contents = campaign::prepare(std::move(records), settings, options.title);
  contents.acceptance = options.acceptance;
  contents.part = options.part;
  load_rules(contents.acceptance);
  // Throws before the long search if the rule set or the design values do not suit the lot.
  if (contents.acceptance != campaign::Acceptance{}) study::build_summary(contents);
  if (!options.directory) {
    TemporaryDirectory const directory;
    auto const file = directory.path() / store_name;
    campaign::Store::create(file, contents);
    campaign::run(contents, file, options.run);
    return {std::move(contents), {}};
  }
  make_directory(*options.directory);
  DirectoryLock const lock(*options.directory);
  auto const file = *options.directory / store_name;
  render::remove_leftovers(*options.directory);
  auto continued = open_or_create(file, contents, options.fresh);
  return {finish_campaign(std::move(contents), file, options.run), std::move(continued)};
}

}  // namespace isolaw
