// Tests with measured records. Their files are not part of the project, and a test is skipped if its file is absent.
#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <random>

#include "data_fixture.hpp"
#include "isolaw/data/clean.hpp"
#include "isolaw/data/properties/properties.hpp"
#include "isolaw/data/signals/signal_faults.hpp"

#ifndef ISOLAW_DATA_DIR
#define ISOLAW_DATA_DIR "absent"
#endif

namespace isolaw::data::testing {
namespace {

std::filesystem::path const folder = ISOLAW_DATA_DIR;

struct Row {
  double start, end, amplitude_mm, K_eff_kN_per_mm, energy_kN_mm, damping_percent;
};

// Values of each cycle from an independent program, which cuts the same file at interpolated zero crossings once the
// displacement has exceeded 5 mm.
constexpr Row gallardo[] = {
    {0.0, 1180.8, 38.14, 2.8448, 6161, 23.7},         {1180.8, 2111.5, 38.03, 2.7546, 4896, 19.56},
    {2111.5, 3042.5, 38.07, 2.7574, 4590, 18.28},     {3042.5, 3973.4, 38.06, 2.7259, 4439, 17.89},
    {3973.4, 4904.3, 38.05, 2.7108, 4347, 17.63},     {4904.3, 5835.2, 38.06, 2.676, 4285, 17.59},
    {5835.2, 6714.5, 38.06, 2.6867, 4255, 17.4},      {6714.5, 7695.6, 76.14, 2.0989, 14210, 18.59},
    {7695.6, 8626.5, 76.1, 1.9925, 12600, 17.38},     {8626.5, 9557.4, 76.12, 1.9506, 12123, 17.07},
    {9557.4, 10488.3, 76.12, 1.9229, 11866, 16.95},   {10488.3, 11419.2, 76.09, 1.9055, 11688, 16.86},
    {11419.2, 12350.1, 76.11, 1.8873, 11563, 16.83},  {12350.1, 13229.2, 76.09, 1.8743, 11516, 16.89},
    {13229.2, 14210.6, 152.27, 1.6798, 41121, 16.8},  {14210.6, 15141.4, 152.19, 1.5557, 35339, 15.61},
    {15141.4, 16072.3, 152.19, 1.5015, 33874, 15.5},  {16072.3, 17003.2, 152.22, 1.4674, 32996, 15.45},
    {17003.2, 17934.1, 152.22, 1.4423, 32415, 15.44}, {17934.1, 18865.0, 152.22, 1.4202, 31997, 15.47},
    {18865.0, 19765.7, 152.38, 1.4016, 31547, 15.43},
};

TEST(Measured, FullScaleBearingIsRecognisedAndCutIntoItsCycles) {
  auto const file = folder / "hdrb-gallardo-device/cyclic-24-49-98pct.csv";
  if (!std::filesystem::exists(file)) GTEST_SKIP() << file << " is not here";
  auto const record = read_record(file);
  EXPECT_EQ(record.size(), 19767u);
  EXPECT_FALSE(record.has_time());
  EXPECT_EQ(record.layout.columns,
            (std::map<Channel, std::string>{{Channel::disp, "displacement_cm"}, {Channel::force, "force_tonf"}}));
  EXPECT_EQ(record.layout.units, (std::map<Channel, std::string>{{Channel::disp, "cm"}, {Channel::force, "tonf"}}));
  EXPECT_TRUE(says(record.recognised, "column 1 'sample' counts samples"));
  EXPECT_DOUBLE_EQ(record.disp_mm[1], -0.26163459111111117);
  EXPECT_DOUBLE_EQ(record.force_kN[1], -0.25866338999999999 * 9.80665);

  auto const properties = cyclic_properties(record);
  ASSERT_EQ(properties.blocks.size(), 3u);
  ASSERT_EQ(properties.counted().size(), std::size(gallardo));
  // Even the first cycle agrees, because the independent program also includes the slow start and a first sample that
  // is set to (0, 0).
  for (std::size_t i = 0; i < std::size(gallardo); ++i) {
    auto const& cycle = *properties.counted()[i];
    auto const& row = gallardo[i];
    EXPECT_EQ(cycle.block, static_cast<int>(i / 7) + 1);
    EXPECT_EQ(cycle.number, static_cast<int>(i % 7) + 1);
    SCOPED_TRACE(fmt::format("cycle {}", i + 1));
    EXPECT_NEAR(cycle.first, row.start, 0.051);  // the reference values are rounded to one decimal
    EXPECT_NEAR(cycle.last, row.end, 0.051);
    EXPECT_NEAR(cycle.amplitude_mm, row.amplitude_mm, 0.003 * row.amplitude_mm);
    EXPECT_NEAR(cycle.K_eff_kN_per_mm, row.K_eff_kN_per_mm, 0.003 * row.K_eff_kN_per_mm);
    EXPECT_NEAR(cycle.energy_kN_mm, row.energy_kN_mm, 0.005 * row.energy_kN_mm);
    EXPECT_NEAR(cycle.damping_percent, row.damping_percent, 0.1);
  }
  EXPECT_EQ(properties.reported->number, 3);
  EXPECT_EQ(properties.reported->block, 3);
  for (auto const& block : properties.blocks) EXPECT_EQ(block.cycles.size(), 7u);  // no block ends with a partial cycle
  EXPECT_NEAR(*properties.samples_per_cycle, 930.9, 0.1);
  EXPECT_EQ(clean(record, {}).size(), 4942u);  // every fourth sample
}

// Counts the rises of displacement by more than 3 mm from one turning point to the next.
int rises(std::vector<double> const& disp_mm) {
  int count = 0, direction = 0;
  double low = disp_mm.front(), high = disp_mm.front();
  for (double const x : disp_mm) {
    low = std::min(low, x);
    high = std::max(high, x);
    if (direction <= 0 && x > low + 3.0) {
      ++count;
      direction = 1;
      high = x;
    } else if (direction >= 0 && x < high - 3.0) {
      direction = -1;
      low = x;
    }
  }
  return count;
}

// The force is clipped as by a saturated amplifier, and noise is added as by the converter behind it. The clipping must
// be found in spite of the noise.
TEST(Measured, FullScaleBearingWhoseForceIsClippedIsNamed) {
  auto const file = folder / "hdrb-gallardo-device/cyclic-24-49-98pct.csv";
  if (!std::filesystem::exists(file)) GTEST_SKIP() << file << " is not here";
  auto const record = read_record(file);
  EXPECT_TRUE(record.faults.empty()) << text_of(record.faults.front().finding);
  for (double const noise_kN : {0.002, 0.2}) {
    std::mt19937 generator(1);
    std::normal_distribution<double> noise(0.0, noise_kN);
    auto force = record.force_kN;
    for (double& value : force) value = std::clamp(value, -180.0, 180.0) + noise(generator);
    auto const faults = signal_faults(record.disp_mm, force);
    EXPECT_TRUE(std::ranges::any_of(faults, [](auto const& fault) {
      return fault.kind == FaultKind::clipped && fault.channel == "force";
    })) << noise_kN;
  }
}

// The motions are sines of 0.84 to 0.97 Hz that last 15 s. Their centre drifts by up to half the amplitude.
TEST(Measured, MrDampersAreReadAndCutIntoTheirCycles) {
  struct Damper {
    int number;
    // `frequency_Hz` is the peak of the spectrum, `amplitude_mm` half the third rise (in test 3, half the third fall).
    double frequency_Hz, amplitude_mm;
    std::size_t complete, counted;  // one cycle of test 1 is not counted: it is 5.1 % larger than the others
  };
  // These numbers were counted by turning points in the files, which Octave had read.
  constexpr Damper tests[] = {{1, 0.84, 8.65, 10, 9},
                              {2, 0.87, 8.14, 12, 12},
                              {3, 0.90, 7.15, 12, 12},
                              {4, 0.935, 6.74, 12, 12},
                              {5, 0.97, 6.26, 13, 13}};
  for (auto const& test : tests) {
    auto const file = folder / fmt::format("mr-damper/ensaio.A.{}.mat", test.number);
    if (!std::filesystem::exists(file)) GTEST_SKIP() << file << " is not here";
    SCOPED_TRACE(file.filename().string());
    ReadOptions options;
    options.columns = {{Channel::time, "Tout"}, {Channel::disp, "dist"}, {Channel::force, "forc"}};
    options.units = {{Channel::time, "s"}, {Channel::disp, "mm"}, {Channel::force, "N"}};
    auto const record = read_record(file, options);
    EXPECT_EQ(record.size(), 1501u);
    EXPECT_DOUBLE_EQ(record.time_s.back(), 15.0);
    EXPECT_TRUE(record.faults.empty()) << text_of(record.faults.front().finding);
    auto const cut = segment(record.disp_mm, record.time_s);
    EXPECT_TRUE(cut.cyclic) << text_of(cut.refusal);
    auto const complete = std::ranges::count(cut.cycles, false, &CycleCut::partial);
    EXPECT_TRUE(std::cmp_equal(complete, test.complete)) << complete;
    auto turned = record.disp_mm;
    for (double& x : turned) x = -x;
    bool const falls_first = test.number == 3;
    // A cycle lasts from the middle of a rise to that of the next. Test 3 starts downwards, so its falls are counted.
    EXPECT_EQ(complete, rises(falls_first ? turned : record.disp_mm) - 1);
    auto const properties = cyclic_properties(record);
    ASSERT_EQ(properties.blocks.size(), 1u);
    auto const& block = properties.blocks.front();
    EXPECT_EQ(block.counted().size(), test.counted);
    EXPECT_NEAR(*block.frequency_Hz, test.frequency_Hz, 0.015);
    EXPECT_NEAR(block.amplitude_mm, test.amplitude_mm, 0.1);
    // The matrix x_F repeats the force in its third column.
    options.columns[Channel::force] = "x_F:3";
    EXPECT_EQ(read_record(file, options).force_kN, record.force_kN);
  }
}

TEST(Measured, BiaxialOrbitsWithoutNamesAreNotGuessed) {
  auto const file = folder / "hdrb-gallardo-device/biaxial_input_Fig10.txt";
  if (!std::filesystem::exists(file)) GTEST_SKIP() << file << " is not here";
  EXPECT_THROW(read_record(file), Error);
}

class Quakes : public Files {
 protected:
  // Returns the numbers, separated by blanks, that `command` prints, or none if the command fails.
  std::vector<double> numbers(std::string const& command) {
    auto const file = write("");
    if (std::system(fmt::format("{} > '{}' 2>/dev/null", command, file.string()).c_str()) != 0) return {};
    std::ifstream stream(file);
    return {std::istream_iterator<double>(stream), {}};
  }
};

TEST_F(Quakes, OfABuildingOnIsolatorsAreNotCyclic) {
  for (std::string_view const run : {"CNP100", "ICA50", "ICA100", "SP100"}) {
    auto const packed = folder / fmt::format("hdrb-bncs-building/BI-BNCS_{}.tar.xz", run);
    if (!std::filesystem::exists(packed)) GTEST_SKIP() << packed << " is not here";
    auto disp = numbers(fmt::format("tar -xJOf '{}' BI-BNCS_{}/d1.txt", packed.string(), run));
    if (disp.empty()) GTEST_SKIP() << "no tar to unpack " << packed;
    for (double& x : disp) x *= 1000.0;
    auto const cut = segment(disp);
    EXPECT_FALSE(cut.cyclic) << run;
    EXPECT_LT(cut.regular_share, 0.5) << run;
    EXPECT_TRUE(text_of(cut.refusal).starts_with("the motion is not cyclic: ")) << text_of(cut.refusal);
    EXPECT_GT(std::ranges::count(cut.cycles, false, &CycleCut::partial), 8) << "the swings are shown nevertheless";
  }
}

TEST_F(Quakes, ElCentroThroughAnyIsolationIsNotCyclic) {
  auto const file = folder / "ground-motion-elcentro1940/IELC180.AT2";
  if (!std::filesystem::exists(file)) GTEST_SKIP() << file << " is not here";
  auto const ground_g = numbers(fmt::format("tail -n +5 '{}'", file.string()));
  ASSERT_EQ(ground_g.size(), 4000u);
  for (double const period : {0.5, 1.0, 1.5, 2.0, 2.5, 3.0})
    for (double const damping : {0.05, 0.10, 0.20}) {
      double const omega = 2.0 * std::numbers::pi / period;
      std::vector<double> disp{0.0};
      double x = 0.0, v = 0.0;
      for (double const a : ground_g) {
        for (int step = 0; step < 10; ++step) {
          v += 0.001 * (-9810.0 * a - 2.0 * damping * omega * v - omega * omega * x);
          x += 0.001 * v;
        }
        disp.push_back(x);
      }
      auto const cut = segment(disp);
      EXPECT_FALSE(cut.cyclic) << period << " s, " << damping;
      EXPECT_LT(cut.regular_share, 0.7) << period << " s, " << damping;
    }
}

class FrictionDamper : public Files {};

// Returns the rows of a JSON file, "[[1, 2], [3, 4]]", as text separated by commas.
std::string rows_of(std::string_view json) {
  auto const begin = json.find("[[") + 2;
  auto const end = json.find("]]", begin);
  std::string text;
  for (char const c : json.substr(begin, end - begin)) {
    if (c == ']') text += '\n';
    if ((c >= '0' && c <= '9') || c == '.' || c == '-' || c == 'e' || c == '+') text += c;
    if (c == ',' && !text.ends_with('\n')) text += ',';
  }
  return text + '\n';
}

TEST_F(FrictionDamper, InInchesAndKips) {
  auto const packed = folder / "friction-damper-arts/ds2_1Hz_36lb_1in.json.xz";
  if (!std::filesystem::exists(packed)) GTEST_SKIP() << packed << " is not here";
  auto const unpacked = write("");
  auto const command = fmt::format("xz -dc '{}' > '{}' 2>/dev/null", packed.string(), unpacked.string());
  if (std::system(command.c_str()) != 0) GTEST_SKIP() << "no xz to unpack " << packed;
  std::string json(std::filesystem::file_size(unpacked), ' ');
  std::FILE* handle = std::fopen(unpacked.string().c_str(), "rb");
  ASSERT_EQ(std::fread(json.data(), 1, json.size(), handle), json.size());
  std::fclose(handle);
  auto const table =
      "time [s],displacement [in],friction force [kip],velocity [in/s],actuator force 1 [lb],actuator force 2 [lb]\n" +
      rows_of(json);

  EXPECT_NE(
      refusal(table).find(
          "column 3 'friction force [kip]', column 5 'actuator force 1 [lb]', column 6 'actuator force 2 [lb]' may each be the horizontal force"),
      std::string::npos);
  auto const record = read(table, with("force=3"));
  ASSERT_EQ(record.size(), 7169u);
  EXPECT_DOUBLE_EQ(record.time_s[1], 0.0009765625);
  EXPECT_DOUBLE_EQ(record.disp_mm[0], -0.00011792778968811035 * 25.4);
  EXPECT_DOUBLE_EQ(record.force_kN[0], -0.04164576064795256 * 4.4482216152605);
  auto const properties = cyclic_properties(record);
  ASSERT_EQ(properties.complete().size(), 7u);  // the test has 7 cycles of 1 inch at 1 Hz, with 1024 samples per second
  ASSERT_EQ(properties.counted().size(), 3u);   // the first two and the last two cycles are ramps
  ASSERT_EQ(properties.blocks.size(), 1u);
  EXPECT_NEAR(*properties.blocks[0].frequency_Hz, 1.0, 0.01);
  EXPECT_EQ(properties.blocks[0].waveform, "sine");
  EXPECT_NE(properties.complete()[1]->not_counted.find("below the block's 25.6"), std::string::npos);
  EXPECT_NEAR(*properties.samples_per_cycle, 1024.0, 1.5);
  for (auto const* cycle : properties.counted()) {
    EXPECT_NEAR(cycle->amplitude_mm, 25.4, 0.3);
    EXPECT_GT(cycle->damping_percent, 50.0);  // nearly a friction loop; a rectangle has 64 %
    EXPECT_LT(cycle->damping_percent, 64.0);
  }
  EXPECT_TRUE(says(record.warnings, "force is off centre"));  // the force extends from -5.1 to +3.8 kip
}

}  // namespace
}  // namespace isolaw::data::testing
