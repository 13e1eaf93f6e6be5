// simulate, the exported C++ header and the exported table must give the same force at every step of one path.
#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "cli/run.hpp"
#include "isolaw/laws/catalogue.hpp"
#include "laws/single_laws.hpp"

namespace isolaw::cli_test {
namespace {

// Holds displacement, velocity and force from a table that isolaw wrote.
struct Walk {
  std::vector<double> disp_mm, vel_mm_s, force_kN;
};

Walk walk_of(std::string const& csv) {
  Walk walk;
  std::istringstream lines(csv);
  for (std::string line, cell; std::getline(lines, line);) {
    if (line.empty() || line.starts_with('#') || line.starts_with("time")) continue;
    std::vector<double> values;
    std::istringstream cells(line);
    while (std::getline(cells, cell, ',')) values.push_back(std::stod(cell));
    walk.disp_mm.push_back(values.at(1));
    walk.vel_mm_s.push_back(values.at(2));
    walk.force_kN.push_back(values.at(3));
  }
  return walk;
}

double largest(std::vector<double> const& force) {
  double peak = 0.0;
  for (double const f : force) peak = std::max(peak, std::abs(f));
  return peak;
}

void expect_alike(std::vector<double> const& a, std::vector<double> const& b, double tolerance,
                  std::string const& what) {
  ASSERT_EQ(a.size(), b.size()) << what;
  double const peak = largest(b);
  double worst = 0.0;
  std::size_t at = 0;
  for (std::size_t i = 0; i < a.size(); ++i)
    if (!(std::abs(a[i] - b[i]) <= worst)) {
      worst = std::abs(a[i] - b[i]);
      at = i;
    }
  EXPECT_GT(peak, 1.0) << what;
  EXPECT_LE(worst, tolerance * peak) << what << ", sample " << at + 1;
}

class Agreement : public InFreshDirectory {
 protected:
  // Writes the record of one device, a bilinear loop with a rounded corner: one cycle at 60 mm and two at 100 mm, 60
  // samples each.
  void SetUp() override {
    InFreshDirectory::SetUp();
    std::string text = "time [s],disp [mm],force [kN]\n";
    double z = 0.0, before = 0.0;
    for (int i = 0; i <= 180; ++i) {
      double const x = (i < 60 ? 60.0 : 100.0) * std::sin(2.0 * std::numbers::pi * i / 60.0);
      z += (1.0 - z / 20.0 * (x > before ? 1.0 : -1.0)) * 2.0 * (x - before) / (1.0 + std::abs(x - before) * 0.1);
      before = x;
      text += fmt::format("{:.4f},{:.5f},{:.5f}\n", i / 30.0, x, 0.4 * x + std::clamp(z, -20.0, 20.0));
    }
    write("a.csv", text);
    // Writes an irregular motion that starts from rest and turns at many amplitudes, unlike the record in a.csv.
    text = "time [s],disp [mm]\n";
    for (int i = 0; i <= 400; ++i) {
      double const t = 0.02 * i;
      text += fmt::format(
          "{:.3f},{:.12f}\n", t,
          std::min(1.0, t) * (55.0 * std::sin(2.9 * t) + 30.0 * std::sin(6.1 * t) + 10.0 * std::sin(17.0 * t)));
    }
    write("motion.csv", text);
  }
  Outcome finished(Words const& command) { return Process(command, path("."), path("out"), path("err")).wait(); }
};

TEST_F(Agreement, simulate_header_and_table_of_every_law_agree_at_every_step) {
  auto const o = isolaw({"calibrate", "a.csv", "--laws", "all", "--runs", "1", "--population", "20", "--generations",
                         "5", "--dead-band", "0", "--out", "C"});
  ASSERT_LE(o.code, 1) << o;
  struct Case {
    std::string law;
    Walk table, simulated;
  };
  std::vector<Case> cases;
  std::string includes = "#include <cstdio>\n#include <cstring>\n", drives;
  for (auto const& entry : laws::catalogue()) {
    std::string const law(entry.info.id);
    SCOPED_TRACE(law);
    std::string space = law;
    std::ranges::replace(space, '-', '_');
    auto const exported = [&](std::string const& to, std::string const& file, Words const& more = {}) {
      auto const output =
          isolaw(Words{"export", "C", "--law", law, "--device", "a", "--to", to, "--anyway", "--out", file} + more);
      EXPECT_EQ(output.code, 0) << output;
    };
    exported("cpp", law + ".hpp", {"--name", space});
    exported("csv", law + ".csv");
    auto const simulated = [&](std::string const& motion) {
      auto const output = isolaw({"simulate", law, "--from", "C", "--device", "a", "--motion", motion,
                                  "--turning-points", "sampled", "--anyway"});
      EXPECT_EQ(output.code, 0) << output;
      return walk_of(output.out);
    };
    cases.push_back({law, walk_of(read(law + ".csv")), simulated("motion.csv")});
    // simulate also runs along the path in the exported table. Laws that depend on velocity are left out: simulate
    // computes the velocities from the path, whereas the exported table has velocities of its own.
    if (entry.info.traits.rate_independent)
      expect_alike(simulated(law + ".csv").force_kN, cases.back().table.force_kN, 1e-8, "simulate against the table");
    includes += "#include \"" + law + ".hpp\"\n";
    drives += fmt::format("  if (!std::strcmp(law, \"{}\")) drive({}::Material());\n", law, space);
  }
  write("drive.cpp", includes + R"(
template <class Material>
void drive(Material m) {
  double x, v;
  while (std::scanf("%lf %lf", &x, &v) == 2) {
    m.trial(x + 3.0, v);  // a trial that is not committed: it must leave no trace
    std::printf("%.17g\n", m.trial(x, v));
    m.commit();
  }
}
int main(int, char** argv) {
  char const* law = argv[1];
)" + drives + "}\n");
  auto const built = finished({ISOLAW_COMPILER, "-std=c++17", "-O1", "drive.cpp", "-o", "drive"});
  ASSERT_EQ(built.code, 0) << built;
  for (auto const& c : cases) {
    SCOPED_TRACE(c.law);
    double const tolerance = law_tests::form_tolerance(laws::find_law(c.law));
    auto const header = [&](Walk const& walk) {
      std::string path_text;
      for (std::size_t i = 0; i < walk.disp_mm.size(); ++i)
        path_text += fmt::format("{} {}\n", walk.disp_mm[i], walk.vel_mm_s[i]);
      write("path", path_text);
      auto const driven = finished({"sh", "-c", "./drive " + c.law + " < path"});
      EXPECT_EQ(driven.code, 0) << driven;
      std::vector<double> force;
      std::istringstream values(driven.out);
      for (double f = 0.0; values >> f;) force.push_back(f);
      return force;
    };
    // The table gives displacement and force with ten digits, which limits the agreement.
    expect_alike(header(c.simulated), c.simulated.force_kN, tolerance, "header against simulate");
    expect_alike(header(c.table), c.table.force_kN, 1e-7 + tolerance, "header against the table");
  }
  EXPECT_EQ(cases.size(), laws::catalogue().size());
}

}  // namespace
}  // namespace isolaw::cli_test
