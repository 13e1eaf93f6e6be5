// Tests the reading of records in MATLAB files of level 4 and of versions 5, 7 and 7.3: arrays, structs, how a
// variable is chosen, and what is refused.
#include <hdf5.h>
#include <zlib.h>

#include <cstring>

#include "data_writers.hpp"

namespace isolaw::data::testing {
namespace {

enum class Form { v5, v7, v73, v73_packed };

class Matlab : public Files, public ::testing::WithParamInterface<Form> {
 protected:
  template <class Fill>
  std::string mat_of(Fill&& fill) {
    auto const file = write("", "made.mat");
    {
      bool const packed = GetParam() == Form::v7 || GetParam() == Form::v73_packed;
      bool const newest = GetParam() == Form::v73 || GetParam() == Form::v73_packed;
      MatWriter writer(file, newest ? MAT_FT_MAT73 : MAT_FT_MAT5, packed ? MAT_COMPRESSION_ZLIB : MAT_COMPRESSION_NONE);
      fill(writer);
    }
    return bytes_of(file);
  }
};

std::vector const time_s{0.0, 0.1, 0.2, 0.3};
std::vector const four_disp{0.0, 2.5, 5.0, -1.0};
std::vector const four_force{1.5, -2.0, 3.0, 0.25};
Named const named{{"time_s", time_s}, {"disp_mm", four_disp}, {"force_kN", four_force}};
auto const units = [] { return with("", "time=s,disp=mm,force=kN"); }();

std::vector<double> matrix() {
  auto values = time_s;
  values.insert(values.end(), four_disp.begin(), four_disp.end());
  values.insert(values.end(), four_force.begin(), four_force.end());
  return values;
}

void expect_values(TestRecord const& record) {
  EXPECT_EQ(record.time_s, time_s);
  EXPECT_EQ(record.disp_mm, four_disp);
  EXPECT_EQ(record.force_kN, four_force);
}

TEST_P(Matlab, VectorsByTheirNames) {
  auto const record = read(mat_of([](MatWriter& w) { w.all(named).array("Kx", {3.0}).text("note", "first test"); }));
  expect_values(record);
  EXPECT_EQ(record.layout.columns,
            (std::map<Channel, std::string>{
                {Channel::time, "time_s"}, {Channel::disp, "disp_mm"}, {Channel::force, "force_kN"}}));
  EXPECT_TRUE(says(record.recognised, "disp: variable 'disp_mm', by its name; unit mm from its name"));
  EXPECT_TRUE(says(record.recognised, "4 samples, elements 1 to 4"));
}

// The times start at 2024-05-02 09:00:00 and go on in steps of half a second. A datenum is a spreadsheet's day number
// plus 693960.
TEST_P(Matlab, DatenumIsReadAsSeconds) {
  double const start = 45414.0 + 693960.0 + 9.0 / 24.0;
  auto const record = read(mat_of([&](MatWriter& w) {
    w.array("datenum", {start, start + 0.5 / 86400.0, start + 1.0 / 86400.0, start + 1.5 / 86400.0})
        .array("disp_mm", four_disp)
        .array("force_kN", four_force);
  }));
  ASSERT_EQ(record.time_s.size(), 4u);
  EXPECT_NEAR(record.time_s[3], 1.5, 1e-4);
  EXPECT_TRUE(says(record.recognised, "2024-05-02 at 09:00:00")) << text_of(record.recognised.back());
  auto const odd = mat_of(
      [&](MatWriter& w) { w.array("datenum", time_s).array("disp_mm", four_disp).array("force_kN", four_force); });
  EXPECT_NE(refusal(odd).find("0 is no day of a test; allowed: days of MATLAB's datenum, 1954 to 2119"),
            std::string::npos)
      << refusal(odd);
}

TEST_P(Matlab, CharactersThatAreTimeStampsAreRead) {
  auto const record = read(mat_of([](MatWriter& w) {
    w.texts("t", {"2024-05-02T10:00:00.0", "2024-05-02T10:00:00.1", "2024-05-02T10:00:00.2", "2024-05-02T10:00:00.4"})
        .array("disp_mm", four_disp)
        .array("force_kN", four_force);
  }));
  ASSERT_EQ(record.time_s.size(), 4u);
  EXPECT_NEAR(record.time_s[3], 0.4, 1e-9);
  EXPECT_TRUE(says(record.recognised, "time: variable 't', by its name; time stamps, read in s"));
}

TEST_P(Matlab, TimesThatAreNoNumbersAreAskedFor) {
  auto const file = mat_of([](MatWriter& w) {
    w.texts("t", {"first ", "second", "third ", "fourth"}).array("disp_mm", four_disp).array("force_kN", four_force);
  });
  auto const said = refusal(file);
  EXPECT_NE(
      said.find("'t' holds dates or times, but no numbers; allowed: seconds, or days of datenum; try: save seconds(t "
                "- t(1)), or datenum(t) under that name; --columns time=none, or --dt SECONDS"),
      std::string::npos)
      << said;
  auto options = with("time=none");
  EXPECT_FALSE(read(file, options).has_time());
  options = {};
  options.dt_s = 0.1;
  EXPECT_NEAR(read(file, options).time_s[3], 0.3, 1e-12);
}

TEST_P(Matlab, VariablesAskedFor) {
  auto const text = mat_of([](MatWriter& w) {
    w.array("Tout", time_s)
        .array("dist", four_disp)
        .array("forc", four_force)
        .array("x_F", matrix(), 3)
        .array("Kx", {3.0})
        .text("note", "first test");
  });
  EXPECT_EQ(
      refusal(text),
      "FILE: no variable is recognised as the horizontal displacement, none as the horizontal force; allowed: variables " +
          std::string(
              GetParam() == Form::v73 || GetParam() == Form::v73_packed
                  ? "Kx (1 x 1 double, no channel), Tout (4 x 1 double), dist (4 x 1 double), forc (4 x 1 double), note (1 x 10 char), x_F:1 to x_F:3 (4 x 3 double)"
                  : "Tout (4 x 1 double), dist (4 x 1 double), forc (4 x 1 double), x_F:1 to x_F:3 (4 x 3 double), Kx (1 x 1 double, no channel), note (1 x 10 char)") +
          "; try: --columns time=NAME,disp=NAME,force=NAME --units time=s,disp=mm,force=kN, with your names and units");
  auto options = units;
  for (auto const* columns : {"time=Tout,disp=dist,force=forc", "time=x_F:1,disp=x_F:2,force=x_F:3"}) {
    options.columns = parse_columns(columns);
    expect_values(read(text, options));
  }
  options.columns = parse_columns("time=Tout,disp=x_F,force=forc");
  EXPECT_NE(refusal(text, options).find("no column 'x_F' for disp; allowed: variables "), std::string::npos);
}

TEST_P(Matlab, ColumnsOfAMatrixAndLongRows) {
  std::vector<double> wide;
  for (std::size_t i = 0; i < time_s.size(); ++i) wide.insert(wide.end(), {time_s[i], four_disp[i], four_force[i]});
  auto options = units;
  options.columns = parse_columns("time=m:1,disp=m:2,force=m:3");
  expect_values(read(mat_of([](MatWriter& w) { w.array("m", matrix(), 3); }), options));
  // The 12 values are a matrix of 3 rows and 4 columns, so the channels are rows.
  expect_values(read(mat_of([&](MatWriter& w) { w.array("m", wide, 4); }), options));
}

TEST_P(Matlab, StructsOneLevelDeep) {
  auto const text = mat_of([](MatWriter& w) { w.structure("test", {named}).array("Kx", {3.0}); });
  auto const record = read(text);
  expect_values(record);
  EXPECT_EQ(record.layout.columns.at(Channel::disp), "test.disp_mm");
  EXPECT_EQ(record.layout.sheet, std::nullopt);
  expect_values(read(text, with("disp=test.disp_mm,force=test.force_kN")));
  ReadOptions options;
  options.sheet = "test";
  auto const inside = read(text, options);
  expect_values(inside);
  EXPECT_EQ(inside.layout.columns.at(Channel::disp), "disp_mm");
}

TEST_P(Matlab, SeveralStructsAreSeveralTests) {
  auto shorter = named;
  for (auto& [name, values] : shorter) values.pop_back();
  auto const text = mat_of([&](MatWriter& w) { w.structure("first", {named}).structure("second", {shorter}); });
  EXPECT_EQ(
      refusal(text),
      "FILE: tables 'first', 'second' may each be the test; allowed: one of them; try: --sheet first, or isolaw init, which makes a device of each");
  ReadOptions options;
  options.sheet = "second";
  auto const record = read(text, options);
  EXPECT_EQ(record.size(), 3u);
  EXPECT_EQ(record.layout.sheet, "second");
  auto const tests = list_tests(write(text, "two.mat"));
  ASSERT_EQ(tests.size(), 2u);
  EXPECT_EQ(tests[1].sheet, "second");
  expect_values(read(text, with("time=first.time_s,disp=first.disp_mm,force=first.force_kN")));
}

TEST_P(Matlab, OtherTypesOfNumbers) {
  auto const record = read(mat_of([](MatWriter& w) {
    w.integers("disp_mm", {0, 300, -300, 7}).array("force_kN", {1.0, 2.0, 3.0, 200.0});
  }));
  EXPECT_EQ(record.disp_mm, (std::vector{0.0, 300.0, -300.0, 7.0}));
  EXPECT_EQ(record.force_kN, (std::vector{1.0, 2.0, 3.0, 200.0}));
}

TEST_P(Matlab, FaultsAreAtTheirVariableAndElement) {
  auto bad = named;
  bad[1].second[2] = std::nan("");
  EXPECT_EQ(
      refusal(mat_of([&](MatWriter& w) { w.all(bad); })),
      "FILE:disp_mm:3: 'nan' in variable 'disp_mm' is not a finite number; allowed: a finite number; try: export the record again; --missing leave-out or --missing interpolate");
  bad = named;
  bad[0].second[3] = 0.1;
  EXPECT_EQ(
      refusal(mat_of([&](MatWriter& w) { w.structure("s", {bad}); })),
      "FILE:s.time_s:4: time goes back from 0.2 to 0.1 s; allowed: time that increases from row to row; try: --rows A:B for one test of several, or leave time out with --columns time=none and give --dt");
  bad = named;
  bad[2].second.pop_back();
  EXPECT_EQ(
      refusal(mat_of([&](MatWriter& w) { w.all(bad); })),
      "FILE: the channels differ in length: variable 'time_s' has 4 values, variable 'disp_mm' has 4 values, variable 'force_kN' has 3 values; allowed: columns of equal length; try: --columns time=...,disp=...,force=... with columns that belong together");
}

TEST_P(Matlab, AUnitIsNeverAssumed) {
  EXPECT_EQ(
      refusal(mat_of([](MatWriter& w) { w.array("disp", four_disp).array("force_kN", four_force); })),
      "FILE: variable 'disp' (disp) has no unit; allowed: mm, cm, m, in, ft, dm, um; try: --units disp=mm, with the column's unit");
}

TEST_P(Matlab, AChannelThatIsNotThere) {
  EXPECT_EQ(
      refusal(mat_of([](MatWriter& w) { w.array("disp_mm", four_disp); })),
      "FILE: no variable is recognised as the horizontal force; allowed: variables disp_mm (4 x 1 double); try: --columns force=NAME");
}

TEST_P(Matlab, NoArrays) {
  EXPECT_EQ(
      refusal(mat_of([](MatWriter& w) { w.array("Kx", {3.0}).text("note", "first test"); })),
      "FILE: no arrays of numbers; variables Kx (1 x 1 double, no channel), note (1 x 10 char); allowed: real vectors or matrices of 3 rows or more, at the top or in structs one level deep; try: save time, displacement and force as vectors, or export them as CSV");
}

// If a file is cut off, isolaw reads its complete part or refuses the file. A wrong byte must not end the program.
TEST_P(Matlab, DamagedFilesEndInAMessage) {
  auto const sound = mat_of([](MatWriter& w) { w.all(named).structure("test", {named}); });
  auto const step =
      std::max<std::size_t>(1, sound.size() / (GetParam() == Form::v5 || GetParam() == Form::v7 ? 500 : 40));
  for (std::size_t i = 0; i < sound.size(); i += step) {
    auto bytes = sound;
    bytes[i] = static_cast<char>(bytes[i] ^ 0xFF);
    for (auto const& text : {sound.substr(0, i), bytes}) try {
        read_record_text(text, "test.mat");
      } catch (Error const& error) {
        EXPECT_FALSE(error.complaints().empty());
      }
  }
}

std::string form_name(::testing::TestParamInfo<Form> const& tested) {
  constexpr char const* form_names[] = {"V5", "V7", "V73", "V73Packed"};
  return form_names[static_cast<int>(tested.param)];
}
INSTANTIATE_TEST_SUITE_P(Versions, Matlab, ::testing::Values(Form::v5, Form::v7, Form::v73, Form::v73_packed),
                         form_name);

// --- files of level 4 ---

class Mat4 : public Files {
 protected:
  std::string made() {
    auto const file = write("", "made.mat");
    {
      MatWriter writer(file, MAT_FT_MAT4);
      writer.all(named).array("Kx", {3.0}).text("note", "first test");
    }
    return bytes_of(file);
  }
};

TEST_F(Mat4, IsReadAsAnotherLibraryWritesIt) {
  auto const record = read(made());
  expect_values(record);
  EXPECT_TRUE(says(record.recognised, "a MATLAB file of level 4"));
}

TEST_F(Mat4, DamagedFilesEndInAMessage) {
  auto const sound = made();
  for (std::size_t i = 0; i < sound.size(); ++i) {
    auto bytes = sound;
    bytes[i] = static_cast<char>(bytes[i] ^ 0xFF);
    for (auto const& text : {sound.substr(0, i), bytes}) try {
        read_record_text(text, "test.mat");
      } catch (Error const& error) {
        EXPECT_FALSE(error.complaints().empty());
      }
  }
}

// The file holds two-byte integers of a big-endian machine. Its header has the type 1030, the numbers of rows and
// columns, 0 for no imaginary part, and the length of the name.
TEST_F(Mat4, IntegersOfABigEndianMachine) {
  auto const big = [](std::uint32_t value) {
    std::string bytes;
    for (int shift = 24; shift >= 0; shift -= 8) bytes += static_cast<char>(value >> shift & 0xFFu);
    return bytes;
  };
  auto const matrix = [&](std::string const& name, std::vector<int> const& values) {
    auto bytes = big(1030) + big(static_cast<std::uint32_t>(values.size())) + big(1) + big(0) +
                 big(static_cast<std::uint32_t>(name.size() + 1)) + name + std::string(1, '\0');
    for (int const value : values) bytes += big(static_cast<std::uint32_t>(value)).substr(2);
    return bytes;
  };
  auto const record = read(matrix("disp_mm", {0, 2, 5, -1}) + matrix("force_kN", {1, -2, 3, 0}));
  EXPECT_EQ(record.disp_mm, (std::vector<double>{0.0, 2.0, 5.0, -1.0}));
  EXPECT_EQ(record.force_kN, (std::vector<double>{1.0, -2.0, 3.0, 0.0}));
}

// --- files of version 5, which these tests write byte by byte ---

std::string word(std::uint32_t value) {
  std::string bytes(4, '\0');
  std::memcpy(bytes.data(), &value, 4);
  return bytes;
}
std::string element(std::uint32_t type, std::string data) {
  auto const size = static_cast<std::uint32_t>(data.size());
  data.resize((data.size() + 7) / 8 * 8);
  return word(type) + word(size) + data;
}
std::string doubles(std::vector<double> const& values) {
  return {static_cast<char const*>(static_cast<void const*>(values.data())), values.size() * sizeof(double)};
}
std::string array(std::string const& name, std::vector<double> const& values, std::uint32_t rows, std::uint32_t columns,
                  std::uint32_t flags = 6) {
  return element(14, element(6, word(flags) + word(0)) + element(5, word(rows) + word(columns)) + element(1, name) +
                         element(9, doubles(values)));
}
std::string file_of(std::string const& elements) {
  std::string head = "MATLAB 5.0 MAT-file, made by hand";
  head.resize(124, ' ');
  return head + std::string("\0\1IM", 4) + elements;
}
std::string packed(std::string const& data) {
  std::string out(compressBound(data.size()), '\0');
  auto size = static_cast<uLongf>(out.size());
  compress2(static_cast<Bytef*>(static_cast<void*>(out.data())), &size,
            static_cast<Bytef const*>(static_cast<void const*>(data.data())), data.size(), 9);
  return word(15) + word(static_cast<std::uint32_t>(size)) + out.substr(0, size);
}

class Mat5 : public Files {
 protected:
  // Returns the message about a file that holds these data elements and a sound force.
  std::string found(std::string const& elements) {
    auto const text = refusal(file_of(elements + array("force_kN", four_force, 4, 1)));
    std::string const start = "FILE: the .mat file cannot be read: ";
    return text.starts_with(start) ? text.substr(start.size(), text.find(';') - start.size()) : text;
  }
};

TEST_F(Mat5, IsReadByHandToo) {
  auto const record = read(file_of(array("disp_mm", four_disp, 1, 4) + packed(array("force_kN", four_force, 4, 1))));
  EXPECT_EQ(record.disp_mm, four_disp);
  EXPECT_EQ(record.force_kN, four_force);
}

TEST_F(Mat5, SizesThatLie) {
  EXPECT_EQ(found(array("disp_mm", four_disp, 5, 1)), "5 values stated for 'disp_mm', 32 bytes stored");
  EXPECT_EQ(found(array("disp_mm", four_disp, 1000000000, 1)),
            "1000000000 values stated for 'disp_mm', 32 bytes stored");
  EXPECT_EQ(found(array("disp_mm", four_disp, 2147483647, 2147483647)), "a size larger than any file");
  EXPECT_EQ(found(array("disp_mm", four_disp, 4294967295u, 1)), "a negative size");
  auto beyond = array("disp_mm", four_disp, 4, 1);
  beyond.replace(4, 4, word(0xFFFFFFF0));
  EXPECT_EQ(found(beyond), "a variable beyond the end of the file");
  auto inner = array("disp_mm", four_disp, 4, 1);
  inner.replace(8 + 16 + 16 + 4, 4, word(100000));  // states a name of 100000 bytes
  EXPECT_EQ(found(inner), "a name of 100000 bytes");
  EXPECT_EQ(found(element(14, element(6, word(6) + word(0)) + element(5, std::string(400, '\1')))),
            "a list of sizes of 400 bytes");
}

TEST_F(Mat5, WhatIsPackedIsBounded) {
  // These compressed files have a few kB and hold millions of zeros.
  auto const zeros = [](char const* name, std::uint32_t count, std::uint32_t type, std::size_t size) {
    return packed(element(14, element(6, word(6) + word(0)) + element(5, word(count) + word(1)) + element(1, name) +
                                  element(type, std::string(count * size, '\0'))));
  };
  auto const bomb = [&](std::uint32_t count, std::uint32_t type, std::size_t size) {
    auto const text = refusal(file_of(zeros("disp_mm", count, type, size) + zeros("force_kN", count, type, size)));
    return text.substr(0, text.find(';'));
  };
  EXPECT_EQ(bomb(9'000'000, 2, 1), "FILE:disp_mm: 9000000 values, far more than a file of this size can hold");
  EXPECT_EQ(bomb(10'000'001, 2, 1), "FILE: 10000001 values");
  // A file of any size may hold two million values, so this one is unpacked and then refused for constant displacement.
  EXPECT_EQ(bomb(2'000'000, 9, 8).substr(0, 30), "FILE:disp_mm: disp is constant");
  auto cut = packed(array("disp_mm", four_disp, 4, 1));
  cut.replace(4, 4, word(20));
  cut.resize(28);
  EXPECT_EQ(found(cut), "a compressed variable cannot be unpacked");
}

TEST_F(Mat5, ComplexAndDeepVariablesAreNoChannels) {
  auto const text = found(array("disp_mm", four_disp, 4, 1, 0x806));
  EXPECT_NE(text.find("disp_mm (4 x 1 complex double)"), std::string::npos) << text;
  auto const file = file_of(array("disp_mm", four_disp, 4, 1, 0x806) + array("force_kN", four_disp, 4, 1));
  auto const said =
      "FILE: variable 'disp_mm' is complex; allowed: real numbers; variables disp_mm (4 x 1 complex double)";
  EXPECT_TRUE(refusal(file).starts_with(said)) << refusal(file);
  EXPECT_TRUE(refusal(file, with("disp=disp_mm")).starts_with(said)) << refusal(file, with("disp=disp_mm"));
  EXPECT_TRUE(refusal(file).ends_with("try: save real(disp_mm), or the part that was measured")) << refusal(file);
}

TEST_F(Mat5, BigEndian) {
  auto const swap = [](std::string bytes, std::size_t width) {
    for (std::size_t i = 0; i < bytes.size(); i += width)
      std::reverse(bytes.begin() + static_cast<std::ptrdiff_t>(i),
                   bytes.begin() + static_cast<std::ptrdiff_t>(i + width));
    return bytes;
  };
  auto const big = [&](std::string const& name, std::vector<double> const& values) {
    auto const element_of = [&](std::uint32_t type, std::string data) {
      auto const size = swap(word(static_cast<std::uint32_t>(data.size())), 4);
      data.resize((data.size() + 7) / 8 * 8);
      return swap(word(type), 4) + size + data;
    };
    return element_of(14, element_of(6, swap(word(6) + word(0), 4)) +
                              element_of(5, swap(word(static_cast<std::uint32_t>(values.size())) + word(1), 4)) +
                              element_of(1, name) + element_of(9, swap(doubles(values), 8)));
  };
  auto text = file_of(big("disp_mm", four_disp) + big("force_kN", four_force));
  text.replace(124, 4, std::string("\1\0MI", 4));
  EXPECT_EQ(read(text).disp_mm, four_disp);
}

// --- version 7.3 ---

class Mat73 : public Files {
 protected:
  // Returns a file written by the HDF5 library, with space for MATLAB's text block at its start.
  template <class Fill>
  std::string mat_of(Fill&& fill) {
    auto const file = write("", "made.h5");
    auto const creation = H5Pcreate(H5P_FILE_CREATE);
    H5Pset_userblock(creation, 512);
    auto const handle = H5Fcreate(file.c_str(), H5F_ACC_TRUNC, creation, H5P_DEFAULT);
    fill(handle);
    H5Fclose(handle);
    H5Pclose(creation);
    auto bytes = bytes_of(file);
    std::string head = "MATLAB 7.3 MAT-file, made by hand";
    head.resize(128, ' ');
    return bytes.replace(0, head.size(), head);
  }
  static void add(hid_t file, char const* name, std::vector<double> const& values, hid_t creation = H5P_DEFAULT) {
    hsize_t const sizes[2] = {1, values.size()};
    auto const space = H5Screate_simple(2, sizes, nullptr);
    auto const set = H5Dcreate2(file, name, H5T_NATIVE_DOUBLE, space, H5P_DEFAULT, creation, H5P_DEFAULT);
    H5Dwrite(set, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data());
    H5Dclose(set);
    H5Sclose(space);
  }
};

TEST_F(Mat73, LinksAndDataElsewhereLeadNowhere) {
  auto const secret = write(std::string(4 * 8, 'x'), "secret.bin");
  auto const outside = mat_of([&](hid_t file) { add(file, "force_kN", four_force); });
  auto const target = write(outside, "target.h5");
  auto const text = mat_of([&](hid_t file) {
    add(file, "force_kN", four_force);
    H5Lcreate_external(target.c_str(), "/force_kN", file, "disp_mm", H5P_DEFAULT, H5P_DEFAULT);
    H5Lcreate_soft("/force_kN", file, "disp_cm", H5P_DEFAULT, H5P_DEFAULT);
  });
  EXPECT_NE(
      refusal(text).find(
          "no variable is recognised as the horizontal displacement; allowed: variables force_kN (4 x 1 double); try"),
      std::string::npos)
      << refusal(text);
  auto const kept_elsewhere = mat_of([&](hid_t file) {
    add(file, "force_kN", four_force);
    auto const creation = H5Pcreate(H5P_DATASET_CREATE);
    H5Pset_external(creation, secret.c_str(), 0, 4 * 8);
    hsize_t const sizes[2] = {1, 4};
    auto const space = H5Screate_simple(2, sizes, nullptr);
    H5Dclose(H5Dcreate2(file, "disp_mm", H5T_NATIVE_DOUBLE, space, H5P_DEFAULT, creation, H5P_DEFAULT));
    H5Sclose(space);
    H5Pclose(creation);
  });
  EXPECT_NE(refusal(kept_elsewhere).find("it keeps its values in another file"), std::string::npos)
      << refusal(kept_elsewhere);
}

// A data set of a thousand million values that were never written takes no space in an HDF5 file. isolaw must refuse
// the file.
TEST_F(Mat73, ValuesThatAreNotThere) {
  auto const text = mat_of([&](hid_t file) {
    add(file, "force_kN", four_force);
    hsize_t const sizes[2] = {1, 1'000'000'000};
    auto const space = H5Screate_simple(2, sizes, nullptr);
    H5Dclose(H5Dcreate2(file, "disp_mm", H5T_NATIVE_DOUBLE, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT));
    H5Sclose(space);
  });
  EXPECT_NE(refusal(text).find("the channels differ in length"), std::string::npos);
  EXPECT_NE(refusal(text, with("disp=disp_mm,force=disp_mm")).find("1000000000"), std::string::npos);
}

// A datetime is stored as six numbers that only say where in the file its value is. isolaw cannot read it and asks for
// another time.
TEST_F(Mat73, ADatetimeIsAskedFor) {
  auto const text = mat_of([&](hid_t file) {
    add(file, "disp_mm", four_disp);
    add(file, "force_kN", four_force);
    add(file, "t", {3707764736.0, 2.0, 1.0, 1.0, 1.0, 1.0});
    auto const type = H5Tcopy(H5T_C_S1);
    H5Tset_size(type, 8);
    auto const space = H5Screate(H5S_SCALAR);
    auto const set = H5Dopen2(file, "t", H5P_DEFAULT);
    auto const kind = H5Acreate2(set, "MATLAB_class", type, space, H5P_DEFAULT, H5P_DEFAULT);
    H5Awrite(kind, type, "datetime");
    int const decode = 3;
    auto const object = H5Acreate2(set, "MATLAB_object_decode", H5T_NATIVE_INT, space, H5P_DEFAULT, H5P_DEFAULT);
    H5Awrite(object, H5T_NATIVE_INT, &decode);
    H5Aclose(object);
    H5Aclose(kind);
    H5Dclose(set);
    H5Sclose(space);
    H5Tclose(type);
  });
  EXPECT_NE(refusal(text).find("'t' holds dates or times, but no numbers; allowed: seconds, or days of datenum"),
            std::string::npos)
      << refusal(text);
}

TEST_F(Mat73, UnitsInAttributes) {
  auto const text = mat_of([&](hid_t file) {
    add(file, "force_kN", four_force);
    add(file, "disp", four_disp);
    auto const type = H5Tcopy(H5T_C_S1);
    H5Tset_size(type, 2);
    auto const space = H5Screate(H5S_SCALAR);
    auto const set = H5Dopen2(file, "disp", H5P_DEFAULT);
    auto const attribute = H5Acreate2(set, "units", type, space, H5P_DEFAULT, H5P_DEFAULT);
    H5Awrite(attribute, type, "cm");
    H5Aclose(attribute);
    H5Dclose(set);
    H5Sclose(space);
    H5Tclose(type);
  });
  EXPECT_EQ(read(text).disp_mm, (std::vector{0.0, 25.0, 50.0, -10.0}));
}

}  // namespace
}  // namespace isolaw::data::testing
