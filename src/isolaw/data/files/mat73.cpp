// Reads MATLAB files of version 7.3: HDF5 behind a block of 512 bytes, with dimensions in reverse order. A malicious
// file can break the HDF5 library, so isolaw runs it in a confined process and follows no links and no external data.
#include <fmt/format.h>
#include <hdf5.h>
#include <hdf5_hl.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <functional>
#include <stdexcept>
#include <utility>

#include "isolaw/base/printable.hpp"
#include "isolaw/base/words.hpp"
#include "isolaw/data/files/confined.hpp"
#include "isolaw/data/files/inflate_limit.hpp"
#include "isolaw/data/files/mat_file.hpp"
#include "isolaw/data/files/text.hpp"

namespace isolaw::data {
namespace {

using Write = std::function<void(std::string_view)>;

class Handle {
 public:
  Handle(hid_t id, herr_t (*close)(hid_t)) : id_(id), close_(close) {
    if (id_ < 0) throw std::runtime_error("is damaged, or no HDF5 as MATLAB writes it");
  }
  Handle(Handle const&) = delete;
  Handle& operator=(Handle const&) = delete;
  ~Handle() { close_(id_); }
  operator hid_t() const { return id_; }

 private:
  hid_t id_;
  herr_t (*close_)(hid_t);
};

Handle open_image(std::string_view bytes) {
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
  H5PLset_loading_state(0);  // loads no plugins
  // The cast is safe: with these flags HDF5 neither copies the image nor writes to it.
  auto* const image = const_cast<void*>(static_cast<void const*>(bytes.data()));
  return {H5LTopen_file_image(image, bytes.size(), H5LT_FILE_IMAGE_DONT_COPY | H5LT_FILE_IMAGE_DONT_RELEASE), H5Fclose};
}

std::string attribute(hid_t object, char const* name) {
  constexpr std::size_t longest = 64;
  if (H5Aexists(object, name) <= 0) return {};
  Handle const handle(H5Aopen(object, name, H5P_DEFAULT), H5Aclose);
  Handle const type(H5Aget_type(handle), H5Tclose);
  Handle const space(H5Aget_space(handle), H5Sclose);
  auto const size = H5Tget_size(type);
  if (H5Tget_class(type) != H5T_STRING || H5Tis_variable_str(type) > 0 || H5Sget_simple_extent_npoints(space) != 1 ||
      size == 0 || size > longest)
    return {};
  std::array<char, longest + 1> text{};
  if (H5Aread(handle, type, text.data()) < 0) return {};
  return {text.data()};
}

std::vector<std::string> links(hid_t group) {
  H5G_info_t info{};
  if (H5Gget_info(group, &info) < 0) throw std::runtime_error("is damaged");
  if (info.nlinks > MatFile::most_variables)
    throw std::runtime_error(fmt::format("holds more than {} variables", MatFile::most_variables));
  std::vector<std::string> names;
  for (hsize_t i = 0; i < info.nlinks; ++i) {
    std::array<char, MatFile::longest_name + 1> name{};
    auto const length =
        H5Lget_name_by_idx(group, ".", H5_INDEX_NAME, H5_ITER_INC, i, name.data(), name.size(), H5P_DEFAULT);
    if (length <= 0 || static_cast<std::size_t>(length) > MatFile::longest_name || name[0] == '#') continue;
    H5L_info_t link{};
    if (H5Lget_info(group, name.data(), &link, H5P_DEFAULT) < 0 || link.type != H5L_TYPE_HARD) continue;
    std::string text(name.data());
    if (is_printable(text)) names.push_back(std::move(text));
  }
  return names;
}

std::string kind_of(hid_t object, hid_t type) {
  auto kind = attribute(object, "MATLAB_class");
  auto const stored = H5Tget_class(type);
  if (kind.empty()) kind = stored == H5T_FLOAT ? "double" : stored == H5T_INTEGER ? "integer" : "unknown";
  if (H5Aexists(object, "MATLAB_sparse") > 0) return "sparse";
  if (stored == H5T_COMPOUND) return "complex " + kind;
  if (stored == H5T_REFERENCE && kind != "cell") return kind + " of several structs";
  return kind;
}

// Writes a line about a variable: whether it is numeric, its name, kind, unit and sizes, each followed by a tab.
void describe(hid_t data_set, std::string const& name, Write const& write) {
  Handle const type(H5Dget_type(data_set), H5Tclose);
  Handle const space(H5Dget_space(data_set), H5Sclose);
  auto const rank = H5Sget_simple_extent_ndims(space);
  if (rank < 0 || rank > H5S_MAX_RANK) return;
  std::array<hsize_t, H5S_MAX_RANK> sizes{};
  if (rank > 0 && H5Sget_simple_extent_dims(space, sizes.data(), nullptr) < 0) return;
  auto const kind = kind_of(data_set, type);
  auto const stored = H5Tget_class(type);
  bool const empty = H5Aexists(data_set, "MATLAB_empty") > 0;
  bool const object = H5Aexists(data_set, "MATLAB_object_decode") > 0;  // an object's numbers only point to its values
  bool const numeric =
      (stored == H5T_FLOAT || stored == H5T_INTEGER) && kind != "char" && kind != "cell" && !empty && !object;
  auto unit = attribute(data_set, "units");
  if (unit.empty()) unit = attribute(data_set, "unit");
  auto line = fmt::format("{}\t{}\t{}\t{}\t", numeric ? 1 : 0, name, printable(kind), is_printable(unit) ? unit : "");
  for (int i = rank; i > 0; --i) line += fmt::format("{}\t", empty ? 0 : sizes[static_cast<std::size_t>(i) - 1]);
  write(line + '\n');
}

void list(std::string_view bytes, Write const& write) {
  auto const file = open_image(bytes);
  auto const each = [&](hid_t group, auto const& data_set, auto const& other) {
    for (auto const& name : links(group)) {
      Handle const object(H5Oopen(group, name.c_str(), H5P_DEFAULT), H5Oclose);
      auto const type = H5Iget_type(object);
      if (type == H5I_DATASET)
        data_set(object, name);
      else if (type == H5I_GROUP)
        other(object, name);
    }
  };
  Handle const root(H5Gopen2(file, "/", H5P_DEFAULT), H5Gclose);
  each(
      root, [&](hid_t object, std::string const& name) { describe(object, name, write); },
      [&](hid_t group, std::string const& name) {
        bool const sparse = H5Aexists(group, "MATLAB_sparse") > 0;
        write(fmt::format("0\t{}\t{}\t\t1\t1\t\n", name, sparse ? "sparse" : "struct"));
        if (sparse) return;
        each(
            group, [&](hid_t object, std::string const& field) { describe(object, name + '.' + field, write); },
            [&](hid_t, std::string const& field) { write(fmt::format("0\t{}.{}\tstruct\t\t1\t1\t\n", name, field)); });
      });
}

void read(std::string_view bytes, MatVariable const& variable, MatSlice const& slice, Write const& write) {
  auto const file = open_image(bytes);
  auto path = variable.name;
  std::ranges::replace(path, '.', '/');
  Handle const data_set(H5Dopen2(file, path.c_str(), H5P_DEFAULT), H5Dclose);
  Handle const creation(H5Dget_create_plist(data_set), H5Pclose);
  if (H5Pget_layout(creation) == H5D_VIRTUAL || H5Pget_external_count(creation) != 0)
    throw std::runtime_error("keeps its values in another file");
  Handle const space(H5Dget_space(data_set), H5Sclose);
  std::array<hsize_t, 2> sizes{};
  if (H5Sget_simple_extent_ndims(space) != 2 || H5Sget_simple_extent_dims(space, sizes.data(), nullptr) < 0 ||
      sizes[0] != variable.size[1] || sizes[1] != variable.size[0])
    throw std::runtime_error("is damaged");
  // A column of the MATLAB matrix is a row in the HDF5 file, because the dimensions are in reverse order there.
  bool const whole = slice.stride == 1 && slice.count == sizes[0] * sizes[1];
  bool const column = slice.stride == 1;
  std::array<hsize_t, 2> const start{column && !whole ? slice.first / sizes[1] : 0, column ? 0 : slice.first};
  std::array<hsize_t, 2> const count{column && !whole ? 1 : sizes[0], column ? sizes[1] : 1};
  if (H5Sselect_hyperslab(space, H5S_SELECT_SET, start.data(), nullptr, count.data(), nullptr) < 0)
    throw std::runtime_error("is damaged");
  hsize_t const length = slice.count;
  Handle const memory(H5Screate_simple(1, &length, nullptr), H5Sclose);
  std::vector<double> values(length);
  if (H5Dread(data_set, H5T_NATIVE_DOUBLE, memory, space, H5P_DEFAULT, values.data()) < 0)
    throw std::runtime_error(fmt::format("holds values of {} that cannot be unpacked", in_quotes(variable.name)));
  write({static_cast<char const*>(static_cast<void const*>(values.data())), values.size() * sizeof(double)});
}

class Mat73File : public MatFile {
 public:
  Mat73File(std::string_view bytes, std::string const& file) : MatFile(bytes, file) {
    constexpr std::size_t longest_list = std::size_t{16} << 20;
    auto const text = confined([&](Write const& write) { list(bytes_, write); }, longest_list);
    for (std::string_view rest = text; !rest.empty() && variables_.size() < most_variables;) add(take_part(rest, '\n'));
  }

  std::vector<double> values(MatVariable const& variable, MatSlice const& slice) const override {
    auto const expected = slice.count * sizeof(double);
    if (expected > unpacked_limit(bytes_.size()))
      damaged(fmt::format("{} values of {} come to far more than the file", slice.count, in_quotes(variable.name)));
    auto const output = confined([&](Write const& write) { read(bytes_, variable, slice, write); }, expected);
    if (output.size() != expected) damaged("is damaged");
    std::vector<double> values(slice.count);
    std::memcpy(values.data(), output.data(), output.size());
    return values;
  }

  std::string_view version() const override { return "a MATLAB file of version 7.3"; }

 private:
  std::string confined(std::function<void(Write const&)> const& work, std::size_t output_bytes) const {
    auto const mebibytes = bytes_.size() >> 20;
    auto result = run_confined(work, {.memory_bytes = (std::uint64_t{128} << 20) + 2 * unpacked_limit(bytes_.size()),
                                      .seconds = static_cast<unsigned>(10 + mebibytes / 16),
                                      .output_bytes = output_bytes});
    if (!result.failure.empty()) damaged(result.failure);
    return std::move(result.output);
  }

  [[noreturn]] void damaged(std::string const& what) const { refuse("it " + what, "alone with -v7"); }

  void add(std::string_view line) {
    std::vector<std::string_view> fields;
    while (!line.empty()) fields.push_back(take_part(line, '\t'));
    if (fields.size() < 4 || !is_printable(fields[1]) || !is_printable(fields[2]) || !is_printable(fields[3])) return;
    MatVariable variable{.name = std::string(fields[1]),
                         .kind = std::string(fields[2]),
                         .size = {},
                         .numeric = fields[0] == "1",
                         .unit = std::string(fields[3])};
    for (std::size_t i = 4; i < fields.size(); ++i) {
      auto const size = number_in<std::uint64_t>(fields[i]);
      if (!size || *size > std::uint64_t{1} << 40) return;
      variable.size.push_back(*size);
    }
    variables_.push_back(std::move(variable));
  }
};

}  // namespace

std::unique_ptr<MatFile> open_mat73(std::string_view bytes, std::string const& file) {
  return std::make_unique<Mat73File>(bytes, file);
}

}  // namespace isolaw::data
