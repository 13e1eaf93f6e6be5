// Reads MATLAB files of level 4 (MathWorks, "MAT-File Format", 2017, Level 4): matrices one after another, each with a
// header of 20 bytes. Octave and old acquisition programs still write them.
#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <optional>

#include "isolaw/data/files/mat_file.hpp"

namespace isolaw::data {
namespace {

constexpr std::size_t header_bytes = 20;
constexpr std::array<std::size_t, 6> number_bytes{8, 4, 4, 2, 2, 1};  // double, single, int32, int16, uint16, uint8
constexpr std::array<std::string_view, 6> number_names{"double", "single", "int32", "int16", "uint16", "uint8"};

template <class T>
T number_at(std::string_view bytes, bool swapped) {
  std::array<char, sizeof(T)> raw;
  std::ranges::copy(bytes.substr(0, sizeof(T)), raw.begin());
  if (swapped) std::ranges::reverse(raw);
  return std::bit_cast<T>(raw);
}

struct Matrix {
  std::uint32_t form = 0;    // type of the numbers: a position in number_bytes
  std::uint32_t matrix = 0;  // 0: numbers, 1: text, 2: sparse
  std::uint64_t rows = 0, columns = 0;
  bool complex = false, swapped = false;
  std::string_view name, data;  // `data` holds the real parts
  std::size_t bytes = 0;        // size of header, name and all numbers together
};

// The matrix at the front of the bytes, or nullopt if they do not begin with a complete matrix of level 4.
std::optional<Matrix> matrix_at(std::string_view bytes) {
  if (bytes.size() < header_bytes) return std::nullopt;
  Matrix found;
  constexpr std::uint32_t big_endian = 1000;
  auto type = number_at<std::uint32_t>(bytes, false);
  if (type >= 2 * big_endian) {
    found.swapped = true;
    type = number_at<std::uint32_t>(bytes, true);
  }
  bool const says_big = type / big_endian == 1;
  bool const is_big = (std::endian::native == std::endian::big) != found.swapped;
  found.form = type / 10 % 10;
  found.matrix = type % 10;
  bool const is_known =
      type < 2 * big_endian && type / 100 % 10 == 0 && found.form < number_bytes.size() && found.matrix <= 2;
  if (!is_known || says_big != is_big) return std::nullopt;
  auto const field = [&](std::size_t i) { return number_at<std::uint32_t>(bytes.substr(4 * i), found.swapped); };
  found.rows = field(1);
  found.columns = field(2);
  auto const complex = field(3), name_bytes = field(4);
  found.complex = complex == 1;
  if (complex > 1 || name_bytes < 2 || name_bytes > MatFile::longest_name || name_bytes > bytes.size() - header_bytes)
    return std::nullopt;
  found.name = bytes.substr(header_bytes, name_bytes - 1);
  bool const ends = bytes[header_bytes + name_bytes - 1] == '\0';
  bool const is_name = std::ranges::all_of(found.name, [](char c) { return c > ' ' && c < '\x7F'; });
  // The numbers of rows and columns are below 2^32, so their product cannot overflow 64 bits.
  auto const count = found.rows * found.columns;
  auto const left = bytes.size() - header_bytes - name_bytes;
  if (!ends || !is_name || count > left) return std::nullopt;
  auto const size = static_cast<std::size_t>(count) * number_bytes[found.form];
  auto const whole = found.complex ? 2 * size : size;
  if (whole > left) return std::nullopt;
  found.data = bytes.substr(header_bytes + name_bytes, size);
  found.bytes = header_bytes + name_bytes + whole;
  return found;
}

double value_at(Matrix const& matrix, std::uint64_t index) {
  auto const bytes = matrix.data.substr(static_cast<std::size_t>(index) * number_bytes[matrix.form]);
  switch (matrix.form) {
    case 0:
      return number_at<double>(bytes, matrix.swapped);
    case 1:
      return static_cast<double>(number_at<float>(bytes, matrix.swapped));
    case 2:
      return number_at<std::int32_t>(bytes, matrix.swapped);
    case 3:
      return number_at<std::int16_t>(bytes, matrix.swapped);
    case 4:
      return number_at<std::uint16_t>(bytes, matrix.swapped);
    default:
      return static_cast<unsigned char>(bytes.front());
  }
}

class Mat4File : public MatFile {
 public:
  Mat4File(std::string_view bytes, std::string const& file) : MatFile(bytes, file) {
    for (auto rest = bytes; !rest.empty();) {
      auto const matrix = matrix_at(rest);
      if (!matrix)
        refuse(fmt::format("byte {} begins no matrix, or the matrix is cut off", bytes.size() - rest.size() + 1));
      if (matrices_.size() >= most_variables) refuse(fmt::format("more than {} variables", most_variables));
      auto const kind = matrix->matrix == 2 ? "sparse" : matrix->matrix == 1 ? "char" : number_names[matrix->form];
      variables_.push_back({.name = std::string(matrix->name),
                            .kind = matrix->complex ? "complex " + std::string(kind) : std::string(kind),
                            .size = {matrix->rows, matrix->columns},
                            .numeric = matrix->matrix == 0 && !matrix->complex});
      matrices_.push_back(*matrix);
      rest.remove_prefix(matrix->bytes);
    }
  }

  std::vector<double> values(MatVariable const& variable, MatSlice const& slice) const override {
    auto const at = std::ranges::find(variables_, variable.name, &MatVariable::name);
    auto const& matrix = matrices_[static_cast<std::size_t>(at - variables_.begin())];
    std::vector<double> values;
    for (std::uint64_t i = 0; i < slice.count; ++i) values.push_back(value_at(matrix, slice.first + i * slice.stride));
    return values;
  }

  std::string_view version() const override { return "a MATLAB file of level 4"; }

 private:
  std::vector<Matrix> matrices_;
};

}  // namespace

bool is_mat4(std::string_view bytes) {
  return matrix_at(bytes).has_value();
}

std::unique_ptr<MatFile> open_mat4(std::string_view bytes, std::string const& file) {
  return std::make_unique<Mat4File>(bytes, file);
}

}  // namespace isolaw::data
