#include "isolaw/data/files/mat_table.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <utility>

#include "isolaw/base/printable.hpp"
#include "isolaw/data/files/column_names.hpp"
#include "isolaw/data/files/inflate_limit.hpp"
#include "isolaw/data/files/mat_file.hpp"
#include "isolaw/data/files/number_table.hpp"
#include "isolaw/data/files/sheet_choice.hpp"
#include "isolaw/data/files/text.hpp"

namespace isolaw::data {
namespace {

constexpr std::uint64_t fewest_values = 3;
constexpr std::uint64_t most_rows_across = 20;  // the rows of a wide matrix are channels if there are at most this many
constexpr std::uint64_t bytes_per_sample = 32;  // doubles of four channels; limits how many samples a file may have
constexpr std::size_t most_listed = 30;

struct Origin {
  MatVariable const* variable;
  MatSlice slice;
  std::string name;  // full name of the column: "test.disp", "x_F:3"
};

struct MatColumns {
  std::vector<NumberColumn> columns;
  std::vector<Origin> origins;

  void add(std::string name, MatVariable const& variable, MatSlice slice) {
    columns.push_back({.name = name, .unit = variable.unit, .length = static_cast<std::size_t>(slice.count)});
    columns.back().datenum = lower(name).find("datenum") != std::string::npos;
    origins.push_back({&variable, slice, std::move(name)});
  }
};

// The struct or matrix that a column belongs to. Empty for a vector that is a variable.
std::string owner_of(std::string_view name) {
  return std::string(name.substr(0, name.find_last_of(".:") == std::string_view::npos ? 0 : name.find_last_of(".:")));
}

bool is_vector(MatVariable const& v) {
  return v.size.size() == 2 && (v.size[0] == 1 || v.size[1] == 1) && v.size[0] * v.size[1] >= fewest_values;
}

MatColumns columns_of(std::vector<MatVariable> const& variables) {
  MatColumns found;
  for (auto const& v : variables) {
    if (!v.numeric || v.size.size() != 2) continue;
    auto const rows = v.size[0], columns = v.size[1];
    if (is_vector(v)) {
      found.add(v.name, v, {.first = 0, .stride = 1, .count = rows * columns});
    } else if (rows >= columns && rows >= fewest_values && columns <= most_columns) {
      for (std::uint64_t k = 0; k < columns; ++k)
        found.add(fmt::format("{}:{}", v.name, k + 1), v, {.first = k * rows, .stride = 1, .count = rows});
    } else if (columns > rows && rows >= 2 && rows <= most_rows_across) {
      for (std::uint64_t k = 0; k < rows; ++k)
        found.add(fmt::format("{}:{}", v.name, k + 1), v, {.first = k, .stride = rows, .count = columns});
    }
    if (found.columns.size() > MatFile::most_variables) break;
  }
  return found;
}

// Adds a column for each matrix of characters whose rows are time stamps.
void add_stamps(MatFile const& mat, std::uint64_t longest, MatColumns& found) {
  constexpr std::uint64_t widest = 48;
  std::size_t left = 4;  // at most this many matrices are examined: each takes a pass through the file
  for (auto const& v : mat.variables()) {
    if (v.kind != "char" || v.size.size() != 2) continue;
    auto const rows = v.size[0], width = v.size[1];
    if (rows < fewest_values || width > widest || rows > longest / widest) continue;
    if (left-- == 0) break;
    auto const codes = mat.values(v, {.first = 0, .stride = 1, .count = rows * width});
    if (codes.size() != rows * width) continue;
    NumberColumn column{.name = v.name, .length = static_cast<std::size_t>(rows)};
    for (std::size_t i = 0; i < rows; ++i) {
      std::string text;
      for (std::size_t k = 0; k < width; ++k) {
        double const code = codes[static_cast<std::size_t>(k * rows + i)];
        text += code > 0.0 && code < 128.0 ? static_cast<char>(code) : '?';
      }
      auto const stamp = parse_stamp(trimmed(text));
      if (!stamp) break;
      column.stamps.push_back(*stamp);
    }
    if (column.stamps.size() != rows) continue;
    column.values.assign(column.length, 0.0);
    found.columns.push_back(std::move(column));
    found.origins.push_back({&v, {.first = 0, .stride = 1, .count = rows}, v.name});
  }
}

std::string size_text(MatVariable const& v) {
  return v.size.empty() ? v.kind : fmt::format("{} {}", fmt::join(v.size, " x "), v.kind);
}

// Lists the file's contents for messages: "variables Tout (1501 x 1 double), x_F:1 to x_F:3 (1501 x 3 double)".
std::string listing(std::vector<MatVariable> const& variables, MatColumns const& found) {
  std::vector<std::string> texts;
  for (auto const& v : variables) {
    auto const columns = static_cast<std::size_t>(
        std::ranges::count_if(found.origins, [&](auto const& origin) { return origin.variable == &v; }));
    if (texts.size() == most_listed) {
      texts.push_back(fmt::format("and {} more", variables.size() - most_listed));
      break;
    }
    if (columns > 1)
      texts.push_back(fmt::format("{0}:1 to {0}:{1} ({2})", v.name, columns, size_text(v)));
    else if (v.kind != "struct" || columns == 1)
      texts.push_back(
          fmt::format("{} ({}{})", v.name, size_text(v), columns == 0 && !is_vector(v) ? ", no channel" : ""));
    else
      texts.push_back(fmt::format("{} (struct)", v.name));
  }
  return texts.empty() ? "no variables" : fmt::format("variables {}", fmt::join(texts, ", "));
}

std::vector<std::string> owners(MatColumns const& found, bool of_tests) {
  std::vector<std::string> names;
  std::vector<std::size_t> channels;
  for (auto const& column : found.columns) {
    auto const owner = owner_of(column.name);
    if (owner.empty()) continue;
    if (names.empty() || names.back() != owner) {
      names.push_back(owner);
      channels.push_back(0);
    }
    channels.back() += names_a_channel(column.name.substr(owner.size() + 1)) ? 1u : 0u;
  }
  if (!of_tests) return names;
  std::vector<std::string> tests;
  for (std::size_t i = 0; i < names.size(); ++i)
    if (channels[i] >= 2) tests.push_back(names[i]);
  return tests;
}

std::vector<std::string> complex_of(std::vector<MatVariable> const& variables, std::string const& owner) {
  std::vector<std::string> names;
  for (auto const& v : variables) {
    if (!v.kind.starts_with("complex ")) continue;
    if (owner.empty()) names.push_back(v.name);
    if (!owner.empty() && owner_of(v.name) == owner) names.push_back(v.name.substr(owner.size() + 1));
  }
  return names;
}

std::vector<std::string> objects_of(std::vector<MatVariable> const& variables, std::string const& owner) {
  std::vector<std::string> names;
  for (auto const& v : variables) {
    bool const of_text = v.kind == "cell" || (v.kind == "char" && !v.size.empty() && v.size[0] >= fewest_values);
    bool const of_class =
        v.kind == "table or object" || v.kind == "object" || v.kind == "datetime" || v.kind == "duration";
    if ((of_text || of_class) && owner_of(v.name) == owner)
      names.push_back(owner.empty() ? v.name : v.name.substr(owner.size() + 1));
  }
  return names;
}

class MatTable : public NumberTable {
 public:
  MatTable(std::string const& file, std::shared_ptr<MatFile const> mat, MatColumns found, std::string all,
           std::string const& owner, std::uint64_t longest)
      : NumberTable(owner.empty() ? file : fmt::format("{}:{}", file, owner), std::move(found.columns), "element",
                    fmt::format("{}{}", mat->version(), owner.empty() ? "" : fmt::format(", {}", in_quotes(owner)))),
        name_(file),
        file_(std::move(mat)),
        origins_(std::move(found.origins)),
        longest_(longest) {
    header_.by_name = true;
    header_.listing = std::move(all);
    header_.complex = complex_of(file_->variables(), owner);
    header_.objects = objects_of(file_->variables(), owner);
  }

  std::string place_of(std::size_t column) const override { return fmt::format("{}:{}", name_, origins_[column].name); }

 protected:
  std::vector<double> values(std::size_t column) const override {
    auto const& origin = origins_[column];
    if (origin.slice.count > longest_)
      throw Error(
          Complaint{.where = place_of(column),
                    .found = fmt::format("{} values, far more than a file of this size can hold", origin.slice.count),
                    .allowed = fmt::format("{} or fewer", longest_),
                    .advice = "save the channels without compression"});
    auto read = file_->values(*origin.variable, origin.slice);
    if (read.size() != origin.slice.count)
      throw Error(Complaint{.where = place_of(column),
                            .found = fmt::format("{} values, not {} as stated", read.size(), origin.slice.count)});
    return read;
  }

 private:
  std::string name_;
  std::shared_ptr<MatFile const> file_;
  std::vector<Origin> origins_;
  std::uint64_t longest_;
};

MatColumns part_of(MatColumns const& all, std::string const& owner) {
  MatColumns part;
  for (std::size_t i = 0; i < all.columns.size(); ++i) {
    if (owner_of(all.columns[i].name) != owner) continue;
    auto column = all.columns[i];
    if (column.name[owner.size()] == '.') column.name.erase(0, owner.size() + 1);
    part.columns.push_back(std::move(column));
    part.origins.push_back(all.origins[i]);
  }
  return part;
}

}  // namespace

bool is_mat(std::string_view bytes) {
  return bytes.starts_with("MATLAB 5.0 MAT-file") || bytes.starts_with("MATLAB 7.3 MAT-file") || is_mat4(bytes);
}

Tests mat_tests(std::string_view bytes, std::string const& file, std::optional<std::string> const& owner) {
  std::shared_ptr<MatFile const> mat = bytes.starts_with("MATLAB 7.3") ? open_mat73(bytes, file)
                                       : bytes.starts_with("MATLAB ")  ? open_mat5(bytes, file)
                                                                       : open_mat4(bytes, file);
  auto found = columns_of(mat->variables());
  if (!found.columns.empty()) add_stamps(*mat, unpacked_limit(bytes.size()) / bytes_per_sample, found);
  auto all = listing(mat->variables(), found);
  if (found.columns.empty())
    throw Error(Complaint{
        .where = file,
        .found = "no arrays of numbers; " + all,
        .allowed = fmt::format("real vectors or matrices of {} rows or more, at the top or in structs one level deep",
                               fewest_values),
        .advice = "save time, displacement and force as vectors, or export them as CSV"});
  Tests tests;
  std::string chosen;
  if (owner) {
    auto const names = owners(found, false);
    auto const index = choose_sheet(*owner, names, file, "struct or matrix");
    chosen = names[index];
    found = part_of(found, chosen);
    tests.sheet = sheet_key(names, index);
  } else {
    tests.sheets = owners(found, true);
    if (tests.sheets.size() < 2) tests.sheets.clear();
  }
  tests.tables.push_back(std::make_unique<MatTable>(file, mat, std::move(found), std::move(all), chosen,
                                                    unpacked_limit(bytes.size()) / bytes_per_sample));
  return tests;
}

}  // namespace isolaw::data
