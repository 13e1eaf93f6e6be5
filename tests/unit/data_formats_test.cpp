// Tests that one and the same test gives the same record from every format. Measured files of each format are read too.
#include <algorithm>
#include <cstdlib>

#include "data_writers.hpp"
#include "isolaw/data/properties/properties.hpp"

#ifndef ISOLAW_DATA_DIR
#define ISOLAW_DATA_DIR "absent"
#endif

namespace isolaw::data::testing {
namespace {

std::filesystem::path const folder = ISOLAW_DATA_DIR;

class Formats : public Files {
 protected:
  std::string json_of(Named const& columns) {
    std::string text = "{";
    for (auto const& [name, values] : columns) {
      text += fmt::format("{}\"{}\": [", text.size() > 1 ? ", " : "", name);
      for (std::size_t i = 0; i < values.size(); ++i) text += (i == 0 ? "" : ", ") + shortest(values[i]);
      text += "]";
    }
    return text + "}";
  }
  std::string mat_of(Named const& columns, mat_ft version, matio_compression compression) {
    auto const file = write("", "made.mat");
    { MatWriter(file, version, compression).all(columns); }
    return bytes_of(file);
  }
};

TEST_F(Formats, EqualDataGiveEqualRecords) {
  Ellipse const loop;
  auto const columns = columns_of(loop, "time_s", "disp_mm", "force_kN");
  auto const text = read(csv_of(columns));
  ASSERT_EQ(text.size(), 601u);
  std::vector<std::pair<std::string, std::string>> const others{
      {"json", json_of(columns)},
      {"mat 5", mat_of(columns, MAT_FT_MAT5, MAT_COMPRESSION_NONE)},
      {"mat 7", mat_of(columns, MAT_FT_MAT5, MAT_COMPRESSION_ZLIB)},
      {"mat 7.3", mat_of(columns, MAT_FT_MAT73, MAT_COMPRESSION_ZLIB)}};
  for (auto const& [format, bytes] : others) {
    SCOPED_TRACE(format);
    auto const record = read(bytes);
    EXPECT_EQ(record.time_s, text.time_s);
    EXPECT_EQ(record.disp_mm, text.disp_mm);
    EXPECT_EQ(record.force_kN, text.force_kN);
    EXPECT_EQ(record.warnings, text.warnings);
    EXPECT_EQ(record.layout.columns, text.layout.columns);
    EXPECT_EQ(record.layout.units, text.layout.units);
    EXPECT_NE(record.sha256, text.sha256);
  }
  // libxlsxwriter writes 16 digits, so values may differ in the last one.
  auto const record = read(workbook_of(write("", "made.xlsx"), {{"Test", columns}}));
  ASSERT_EQ(record.size(), text.size());
  for (std::size_t i = 0; i < text.size(); ++i) {
    EXPECT_NEAR(record.disp_mm[i], text.disp_mm[i], 1e-15 * 100.0);
    EXPECT_NEAR(record.force_kN[i], text.force_kN[i], 1e-15 * 100.0);
  }
  EXPECT_EQ(record.layout.columns, text.layout.columns);
  EXPECT_EQ(record.warnings, text.warnings);
}

TEST_F(Formats, ALayoutGivenBackReadsTheSame) {
  auto const columns = columns_of({}, "time_s", "disp_mm", "force_kN");
  auto const book = workbook_of(write("", "made.xlsx"), {{"A", columns}, {"B, 2", columns}});
  ReadOptions options;
  options.sheet = "2";
  auto const first = read(book, options);
  ReadOptions again;
  again.columns = first.layout.columns;
  again.units = first.layout.units;
  again.sheet = first.layout.sheet;
  again.test = first.layout.test;
  auto const second = read(book, again);
  EXPECT_EQ(second.disp_mm, first.disp_mm);
  EXPECT_EQ(second.layout.columns, first.layout.columns);
  EXPECT_EQ(second.layout.sheet, "B, 2");
}

TEST(MeasuredFormats, FilesOfADamperFromMatlab) {
  if (!std::filesystem::exists(folder / "mr-damper"))
    GTEST_SKIP() << folder / "mr-damper"
                 << " is not here";
  for (int i = 1; i <= 5; ++i) {
    auto const file = folder / fmt::format("mr-damper/ensaio.A.{}.mat", i);
    SCOPED_TRACE(file.string());
    auto const record = read_record(file, with("time=Tout,disp=dist,force=forc", "time=s,disp=mm,force=N"));
    EXPECT_EQ(record.size(), 1501u);
    EXPECT_NEAR(record.time_s.back(), 15.0, 1e-9);
    // In this MATLAB file the matrix x_F repeats the vectors of displacement, velocity and force.
    auto const matrix = read_record(file, with("time=Tout,disp=x_F:1,force=x_F:3", "time=s,disp=mm,force=N"));
    EXPECT_EQ(matrix.disp_mm, record.disp_mm);
    EXPECT_EQ(matrix.force_kN, record.force_kN);
    EXPECT_GE(cyclic_properties(record).counted().size(), 5u);
  }
}

TEST(MeasuredFormats, FilesOfAFrictionDamperInJson) {
  auto const source = folder / "friction-damper-arts";
  if (!std::filesystem::exists(source)) GTEST_SKIP() << source << " is not here";
  auto const unpacked = std::filesystem::temp_directory_path() / "isolaw-friction-damper.json";
  int files = 0;
  for (auto const& entry : std::filesystem::directory_iterator(source)) {
    if (entry.path().extension() != ".xz") continue;
    SCOPED_TRACE(entry.path().string());
    auto const command = fmt::format("xz -dc '{}' > '{}'", entry.path().string(), unpacked.string());
    if (std::system(command.c_str()) != 0) GTEST_SKIP() << "xz is not here";
    auto const record = read_record(unpacked, with("time=1,disp=2,force=3", "time=s,disp=in,force=kip"));
    EXPECT_NEAR((record.time_s.back() - record.time_s.front()) / static_cast<double>(record.size() - 1), 1.0 / 1024,
                1e-9);
    auto const name = entry.path().stem().stem().string();
    auto const inches = std::stod(name.substr(name.rfind('_') + 1));
    auto const [least, largest] = std::ranges::minmax(record.disp_mm);
    EXPECT_NEAR((largest - least) / 2.0, 25.4 * inches, 0.03 * 25.4 * inches);
    EXPECT_EQ(cyclic_properties(record).complete().size(), 7u);
    ++files;
  }
  std::filesystem::remove(unpacked);
  EXPECT_EQ(files, 5);
}

}  // namespace
}  // namespace isolaw::data::testing
