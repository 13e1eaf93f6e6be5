// A MATLAB file of any version: arrays of numbers, as variables or as fields of structs (one level deep).
#pragma once

#include <fmt/format.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "isolaw/base/error.hpp"

namespace isolaw::data {

struct MatVariable {
  std::string name;                 // "dist", "test.disp", "test(2).disp"
  std::string kind;                 // "double", "char", "struct", ...
  std::vector<std::uint64_t> size;  // as MATLAB's size() gives it
  bool numeric = false;             // holds real numbers
  std::string unit = {};            // from an attribute of the array; may be empty
};

// Selects `count` values of an array: every `stride`-th from `first` on. The first index runs fastest, as in MATLAB.
struct MatSlice {
  std::uint64_t first = 0;
  std::uint64_t stride = 1;
  std::uint64_t count = 0;
};

class MatFile {
 public:
  static constexpr std::size_t most_variables = 10'000;
  static constexpr std::size_t longest_name = 200;

  MatFile(std::string_view bytes, std::string const& file) : bytes_(bytes), file_(file) {}
  virtual ~MatFile() = default;
  MatFile(MatFile const&) = delete;
  MatFile& operator=(MatFile const&) = delete;

  std::vector<MatVariable> const& variables() const { return variables_; }
  // Returns the values of a slice; for text, the codes of the characters. Throws Error if the file is damaged or grows
  // beyond its limit when unpacked.
  virtual std::vector<double> values(MatVariable const& variable, MatSlice const& slice) const = 0;
  virtual std::string_view version() const = 0;

 protected:
  [[noreturn]] void refuse(std::string_view found, std::string_view how = "alone") const {
    throw Error({.where = file_,
                 .found = fmt::format("the .mat file cannot be read: {}", found),
                 .allowed = "a file as MATLAB's save writes it",
                 .advice = fmt::format("save time, displacement and force {}, or export them as CSV", how)});
  }

  std::string_view bytes_;
  std::string file_;
  std::vector<MatVariable> variables_;
};

// Whether the bytes begin with a matrix of level 4. Files of this level have no signature by which to recognise them.
bool is_mat4(std::string_view bytes);

// `bytes` must outlive the MatFile. Throws Error if the file is damaged or has more than most_variables.
std::unique_ptr<MatFile> open_mat4(std::string_view bytes, std::string const& file);
std::unique_ptr<MatFile> open_mat5(std::string_view bytes, std::string const& file);
std::unique_ptr<MatFile> open_mat73(std::string_view bytes, std::string const& file);

}  // namespace isolaw::data
