// Reads MATLAB files of version 5, and of version 7, whose elements are compressed (MathWorks, "MAT-File Format",
// 2017). A size stated in the file only says how many bytes to skip or where to stop while decompressing, never how
// much memory to allocate. docs/decisions/0001-dependencies.md says why isolaw uses no library for this.
#include <fmt/format.h>
#include <zlib.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <functional>
#include <optional>
#include <span>
#include <utility>

#include "isolaw/base/printable.hpp"
#include "isolaw/data/files/inflate_limit.hpp"
#include "isolaw/data/files/mat_file.hpp"
#include "isolaw/data/files/text.hpp"

namespace isolaw::data {
namespace {

// Types of data elements, from table 1-1 of the MathWorks document. Classes of arrays (table 1-3) are constants below.
enum Type : std::uint32_t {
  mi_int8 = 1,
  mi_uint8 = 2,
  mi_int16 = 3,
  mi_uint16 = 4,
  mi_int32 = 5,
  mi_uint32 = 6,
  mi_single = 7,
  mi_double = 9,
  mi_int64 = 12,
  mi_uint64 = 13,
  mi_matrix = 14,
  mi_compressed = 15,
  mi_utf8 = 16,
  mi_utf16 = 17
};
constexpr std::uint32_t struct_class = 2, char_class = 4, first_numeric_class = 6, last_numeric_class = 15;
constexpr std::array<std::string_view, 18> class_names{
    "unknown", "cell",  "struct", "object", "char",   "sparse", "double", "single",   "int8",
    "uint8",   "int16", "uint16", "int32",  "uint32", "int64",  "uint64", "function", "table or object"};

struct Damaged {
  std::string what;
};

[[noreturn]] void damaged(std::string what) {
  throw Damaged{std::move(what)};
}
class Source {
 public:
  virtual ~Source() = default;
  virtual void read(std::span<char> target) = 0;
  void skip(std::uint64_t count) {
    std::array<char, 1 << 14> waste;
    while (count > 0) {
      auto const part = std::min<std::uint64_t>(count, waste.size());
      read(std::span(waste).first(static_cast<std::size_t>(part)));
      count -= part;
    }
  }
};

class PlainSource : public Source {
 public:
  explicit PlainSource(std::string_view bytes) : bytes_(bytes) {}
  void read(std::span<char> target) override {
    if (target.size() > bytes_.size()) damaged("ends in the middle of a variable");
    std::memcpy(target.data(), bytes_.data(), target.size());
    bytes_.remove_prefix(target.size());
  }

 private:
  std::string_view bytes_;
};

class InflatedSource : public Source {
 public:
  // read() subtracts the number of decompressed bytes from `left`, and refuses the file if `left` is too small.
  InflatedSource(std::string_view bytes, std::uint64_t& left) : left_(left) {
    // The cast is safe: zlib does not write to its input.
    stream_.next_in = const_cast<Bytef*>(static_cast<Bytef const*>(static_cast<void const*>(bytes.data())));
    stream_.avail_in = static_cast<uInt>(bytes.size());
    if (inflateInit(&stream_) != Z_OK) throw std::bad_alloc();
  }
  InflatedSource(InflatedSource const&) = delete;
  InflatedSource& operator=(InflatedSource const&) = delete;
  ~InflatedSource() override { inflateEnd(&stream_); }

  void read(std::span<char> target) override {
    if (target.size() > left_) damaged("grows beyond what a test record comes to when unpacked");
    left_ -= target.size();
    stream_.next_out = static_cast<Bytef*>(static_cast<void*>(target.data()));
    stream_.avail_out = static_cast<uInt>(target.size());
    while (stream_.avail_out > 0) {
      auto const result = inflate(&stream_, Z_NO_FLUSH);
      if (result == Z_STREAM_END && stream_.avail_out > 0) damaged("a compressed variable ends too soon");
      if (result != Z_OK && result != Z_STREAM_END) damaged("a compressed variable cannot be unpacked");
    }
  }

 private:
  z_stream stream_{};
  std::uint64_t& left_;
};

struct Tag {
  std::uint32_t type = 0;
  std::uint32_t size = 0;
  bool small = false;  // the tag itself holds the data
  std::array<char, 4> data{};
};

// Reads one data element and counts how many of its bytes are left. Each byte read counts for the enclosing element
// too.
class Reader {
 public:
  Reader(Source& source, bool swapped, std::uint64_t available)
      : source_(source), swapped_(swapped), available_(available) {}

  std::uint64_t available() const { return available_; }

  void bytes(std::span<char> target) {
    take(target.size());
    source_.read(target);
  }
  void skip(std::uint64_t count) {
    take(count);
    source_.skip(count);
  }

  Tag tag() {
    std::array<char, 8> raw;
    bytes(raw);
    auto const first = number<std::uint32_t>(raw.data());
    Tag tag{.type = first, .size = number<std::uint32_t>(raw.data() + 4)};
    if (auto const size = first >> 16; size != 0) {
      if (size > 4) damaged("a small element of more than 4 bytes");
      tag = {.type = first & 0xFFFFu, .size = size, .small = true, .data = {raw[4], raw[5], raw[6], raw[7]}};
    }
    return tag;
  }

  std::string content(Tag const& tag, std::size_t longest, std::string_view what) {
    if (tag.size > longest) damaged(fmt::format("{} of {} bytes", what, tag.size));
    if (tag.small) return {tag.data.data(), tag.size};
    std::string data(tag.size, '\0');
    bytes(data);
    skip_padding(tag);
    return data;
  }

  void skip(Tag const& tag) {
    if (tag.small) return;
    skip(std::uint64_t{tag.size});
    skip_padding(tag);
  }
  void skip_padding(Tag const& tag) { skip(std::min<std::uint64_t>((8 - tag.size % 8) % 8, available_)); }

  Reader inside(Tag const& tag) {
    take(tag.size);
    return {source_, swapped_, tag.size};
  }

  template <class T>
  T number(char const* at) const {
    std::array<char, sizeof(T)> raw;
    std::memcpy(raw.data(), at, sizeof(T));
    if (swapped_) std::ranges::reverse(raw);
    return std::bit_cast<T>(raw);
  }

 private:
  void take(std::uint64_t count) {
    if (count > available_) damaged("a size beyond the variable that holds it");
    available_ -= count;
  }

  Source& source_;
  bool swapped_;
  std::uint64_t available_;
};

struct Stored {
  Type type;
  std::size_t bytes;
  double (*read)(Reader const& reader, char const* at);
};

template <class T>
constexpr Stored stored_as(Type type) {
  return {type, sizeof(T),
          [](Reader const& reader, char const* at) { return static_cast<double>(reader.number<T>(at)); }};
}
Stored const* stored(std::uint32_t type) {
  static constexpr std::array table{
      stored_as<std::int8_t>(mi_int8),     stored_as<std::uint8_t>(mi_uint8),   stored_as<std::int16_t>(mi_int16),
      stored_as<std::uint16_t>(mi_uint16), stored_as<std::int32_t>(mi_int32),   stored_as<std::uint32_t>(mi_uint32),
      stored_as<std::int64_t>(mi_int64),   stored_as<std::uint64_t>(mi_uint64), stored_as<float>(mi_single),
      stored_as<double>(mi_double),        stored_as<std::uint8_t>(mi_utf8),    stored_as<std::uint16_t>(mi_utf16)};
  auto const found = std::ranges::find(table, type, [](Stored const& row) { return std::uint32_t{row.type}; });
  return found == table.end() ? nullptr : &*found;
}

// Called for every array. Returns the slice of the array's values that is to be read, or nullopt to skip the array.
using Chooser = std::function<std::optional<MatSlice>(MatVariable const&)>;

class Walk {
 public:
  Walk(Chooser wanted, std::vector<double>& values) : wanted_(std::move(wanted)), values_(values) {}

  // `prefix` is the name of the field that holds the array. It is empty for a variable, which has its own name.
  void array(Reader& reader, std::string const& prefix) {
    auto const flags_tag = reader.tag();
    auto const flags_data = reader.content(flags_tag, 8, "array flags");
    if (flags_tag.type != mi_uint32 || flags_data.size() != 8) damaged("no array flags");
    auto const flags = reader.number<std::uint32_t>(flags_data.data());
    auto const kind = flags & 0xFFu;
    bool const complex = (flags & 0x800u) != 0;
    MatVariable variable{.name = prefix, .kind = std::string(class_names[std::min<std::size_t>(kind, 17)]), .size = {}};
    if (kind == 17) {  // an object states no size
      read_name(reader, variable);
      wanted_(variable);
      if (!prefix.empty()) reader.skip(reader.available());
      return;
    }
    read_size(reader, variable);
    read_name(reader, variable);
    if (kind == struct_class && prefix.empty()) return structure(reader, variable);
    if (complex) variable.kind = "complex " + variable.kind;
    variable.numeric = kind >= first_numeric_class && kind <= last_numeric_class && !complex;
    auto const slice = wanted_(variable);
    if ((variable.numeric || (kind == char_class && slice)) && elements(variable) > 0) {
      auto const [tag, form] = values_tag(reader, variable);
      if (slice) read_values(reader, tag, form, *slice, elements(variable));
    }
    if (!prefix.empty()) reader.skip(reader.available());  // the tag of the next variable says where it starts
  }

 private:
  static std::uint64_t elements(MatVariable const& variable) {
    std::uint64_t product = 1;
    for (auto const size : variable.size) {
      if (size != 0 && product > (std::uint64_t{1} << 40) / size) damaged("a size larger than any file");
      product *= size;
    }
    return product;
  }

  static void read_size(Reader& reader, MatVariable& variable) {
    constexpr std::size_t most_dimensions = 32;
    auto const tag = reader.tag();
    auto const data = reader.content(tag, 4 * most_dimensions, "a list of sizes");
    if (tag.type != mi_int32 || data.size() < 8 || data.size() % 4 != 0) damaged("no list of sizes");
    for (std::size_t i = 0; i < data.size(); i += 4) {
      auto const size = reader.number<std::int32_t>(data.data() + i);
      if (size < 0) damaged("a negative size");
      variable.size.push_back(static_cast<std::uint64_t>(size));
    }
    elements(variable);
  }

  static void read_name(Reader& reader, MatVariable& variable) {
    auto const tag = reader.tag();
    auto const name = reader.content(tag, MatFile::longest_name, "a name");
    if (tag.type != mi_int8 && tag.type != mi_uint8) damaged("no name");
    if (variable.name.empty()) variable.name = printable(to_utf8(name));
  }

  // Reads the field names, which are padded to one length, and then the values of one struct after the other.
  void structure(Reader& reader, MatVariable variable) {
    constexpr std::size_t longest_field = 128;
    constexpr std::size_t most_fields = 1000;
    wanted_(variable);
    auto const length_tag = reader.tag();
    auto const length_data = reader.content(length_tag, 4, "the length of field names");
    auto const length =
        length_data.size() == 4 ? static_cast<std::size_t>(reader.number<std::uint32_t>(length_data.data())) : 0;
    if (length_tag.type != mi_int32 || length == 0 || length > longest_field) damaged("no length of field names");
    auto const names_tag = reader.tag();
    auto const names = reader.content(names_tag, most_fields * length, "field names");
    auto const fields = names.size() / length;
    auto const structs = elements(variable);
    for (std::uint64_t i = 0; i < structs && fields > 0; ++i)
      for (std::size_t f = 0; f < fields; ++f) {
        auto field = names.substr(f * length, length);
        field = field.substr(0, field.find('\0'));
        auto const owner = structs == 1 ? variable.name : fmt::format("{}({})", variable.name, i + 1);
        auto const tag = reader.tag();
        if (tag.type != mi_matrix || tag.small) damaged("a field that is no array");
        auto inside = reader.inside(tag);
        if (tag.size > 0) array(inside, fmt::format("{}.{}", owner, printable(to_utf8(field))));
      }
  }

  static std::pair<Tag, Stored> values_tag(Reader& reader, MatVariable const& variable) {
    auto const tag = reader.tag();
    auto const* form = stored(tag.type);
    auto const stated = elements(variable);
    if (form == nullptr) damaged(fmt::format("values of {} in a form that is no number", in_quotes(variable.name)));
    if (tag.size != stated * form->bytes)
      damaged(fmt::format("{} values stated for {}, {} bytes stored", stated, in_quotes(variable.name), tag.size));
    return {tag, *form};
  }

  void read_values(Reader& reader, Tag const& tag, Stored const& form, MatSlice const& slice, std::uint64_t stated) {
    auto const [type, size, read] = form;
    values_.reserve(static_cast<std::size_t>(slice.count));  // MatTable has checked the count
    if (tag.small) {
      for (std::uint64_t i = 0; i < slice.count; ++i)
        values_.push_back(read(reader, tag.data.data() + (slice.first + i * slice.stride) * size));
      return;
    }
    std::array<char, 1 << 14> buffer;
    auto const per_read = buffer.size() / size;
    for (std::uint64_t at = 0; at < stated && values_.size() < slice.count; at += per_read) {
      auto const count = static_cast<std::size_t>(std::min<std::uint64_t>(per_read, stated - at));
      reader.bytes(std::span(buffer).first(count * size));
      auto next = slice.first + values_.size() * slice.stride;
      for (; next < at + count && values_.size() < slice.count; next += slice.stride)
        values_.push_back(read(reader, buffer.data() + static_cast<std::size_t>(next - at) * size));
    }
  }

  Chooser wanted_;
  std::vector<double>& values_;
};

class Mat5File : public MatFile {
 public:
  Mat5File(std::string_view bytes, std::string const& file) : MatFile(bytes, file) {
    guarded([&] {
      std::vector<double> none;
      walk(
          [&](MatVariable const& variable) {
            if (variable.name.empty()) return std::optional<MatSlice>();  // unnamed: MATLAB's own data for objects
            if (variables_.size() >= most_variables) damaged(fmt::format("more than {} variables", most_variables));
            variables_.push_back(variable);
            return std::optional<MatSlice>();
          },
          none);
    });
  }

  std::vector<double> values(MatVariable const& variable, MatSlice const& slice) const override {
    std::vector<double> values;
    guarded([&] {
      bool found = false;  // if two variables have one name, the first counts, as in the list of variables
      walk(
          [&](MatVariable const& other) {
            bool const same = other.name == variable.name && other.size == variable.size && other.kind == variable.kind;
            bool const wanted = !found && same;
            found = found || wanted;
            return wanted ? std::optional(slice) : std::nullopt;
          },
          values);
    });
    return values;
  }

  std::string_view version() const override { return "a MATLAB file of version 5 or 7"; }

 private:
  template <class Action>
  void guarded(Action&& action) const {
    try {
      action();
    } catch (Damaged const& reason) {
      refuse(reason.what);
    }
  }

  void walk(Chooser const& wanted, std::vector<double>& values) const {
    constexpr std::size_t header = 128;
    if (bytes_.size() < header) damaged("is shorter than its header");
    auto const mark = bytes_.substr(126, 2);
    if (mark != "IM" && mark != "MI") damaged("says nothing of its byte order");
    bool const swapped = (mark == "IM") != (std::endian::native == std::endian::little);
    auto left = unpacked_limit(bytes_.size());
    auto rest = bytes_.substr(header);
    Walk walk(wanted, values);
    while (rest.size() >= 8 && values.empty()) {
      PlainSource plain(rest);
      Reader reader(plain, swapped, rest.size());
      auto const tag = reader.tag();
      if (tag.small || tag.size > rest.size() - 8) damaged("a variable beyond the end of the file");
      auto const content = rest.substr(8, tag.size);
      if (tag.type == mi_compressed) {
        InflatedSource inflated(content, left);
        Reader outer(inflated, swapped, 8);
        auto const inner = outer.tag();
        Reader inside(inflated, swapped, inner.size);
        if (inner.type == mi_matrix && !inner.small && inner.size > 0) walk.array(inside, {});
      } else if (tag.type == mi_matrix && tag.size > 0) {
        auto inside = reader.inside(tag);
        walk.array(inside, {});
      }
      rest.remove_prefix(8 + tag.size);
      if (tag.type != mi_compressed) rest.remove_prefix(std::min<std::size_t>((8 - tag.size % 8) % 8, rest.size()));
    }
  }
};

}  // namespace

std::unique_ptr<MatFile> open_mat5(std::string_view bytes, std::string const& file) {
  return std::make_unique<Mat5File>(bytes, file);
}

}  // namespace isolaw::data
