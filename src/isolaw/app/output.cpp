#include "isolaw/app/output.hpp"

#include <algorithm>
#include <fstream>
#include <string>

#include "isolaw/base/error.hpp"
#include "isolaw/base/file.hpp"
#include "isolaw/base/write_file.hpp"

namespace isolaw::app {
namespace {

namespace fs = std::filesystem;

bool is_store(fs::path const& file) {
  constexpr std::string_view magic = "SQLite format 3";
  std::string head(magic.size(), '\0');
  std::ifstream in(file, std::ios::binary);
  return in.read(head.data(), static_cast<std::streamsize>(head.size())) && head == magic;
}

}  // namespace

void write_output(fs::path const& out, std::string_view text, std::vector<fs::path> const& inputs) {
  std::error_code none;
  auto const refuse = [&](std::string found) {
    throw Error({.where = out.string(),
                 .found = std::move(found),
                 .allowed = "a new file, or one that the command does not read",
                 .advice = "another name after --out"});
  };
  if (std::ranges::any_of(inputs, [&](auto const& input) { return fs::equivalent(out, input, none); }))
    refuse("is an input of this command and would be replaced");
  if (other_than_plain(out) && !fs::is_directory(out, none)) {
    std::ofstream file(out, std::ios::binary);
    file.write(text.data(), static_cast<std::streamsize>(text.size()));
    if (!file.flush()) refuse("cannot be written");
    return;
  }
  if (is_store(out)) refuse("is a campaign's store and would be replaced");
  write_file(out, text);
}

}  // namespace isolaw::app
