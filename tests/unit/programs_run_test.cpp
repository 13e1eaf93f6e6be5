// Runs exported files as users do: compiles C++ headers and interprets Python and Tcl scripts. The scripts run without
// OpenSees, with stand-ins for its materials that this file writes in Python and Tcl.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "laws/single_laws.hpp"
#include "unit/programs_box.hpp"
#include "unit/programs_folder.hpp"

namespace isolaw::programs_test {
namespace {

constexpr double shares[] = {0.1, 0.35, 0.6};

// For every law, the forces of the exported header must equal those of the library, and its tangents must equal
// differences of its forces.
TEST_F(Folder, headers_are_the_laws) {
  UnitSystem const& units = unit_systems[1];
  // Set samples near zero to exactly zero. Laws assign zero to the side from which the motion comes, but a rounding
  // error would assign it to either side.
  auto history = cycles({40.0, 150.0, 90.0}, 120);
  for (double& x : history.disp_mm) x = std::abs(x) < 1e-9 ? 0.0 : x;
  std::string includes = "#include <cstdio>\n#include <initializer_list>\n", body;
  std::vector<std::vector<double>> expected;
  std::vector<double> tolerances;
  std::vector<std::string> names;
  std::vector<bool> is_rate_independent, remembers, masing;
  for (auto const& law : laws::catalogue()) {
    auto subject = subject_of(law.info.id, inside_box(law, 0.5));
    subject.refinement = law.info.id == "abe" ? 2 : 1;
    auto const file = std::string(law.info.id) + ".hpp", space = identifier(subject, units);
    write(file, cpp_header(subject, units));
    includes += "#include \"" + file + "\"\n";
    for (double const share : shares) {
      auto const parameters = inside_box(law, share);
      auto driven = history;
      driven.refinement = subject.refinement;
      auto const force = law_force(law, parameters, driven);
      if (!std::ranges::all_of(force, [](double f) { return std::isfinite(f); })) continue;
      std::string list;
      for (double const p : parameters) list += (list.empty() ? "" : ", ") + exact_text(p);
      body += fmt::format("  drive({0}::Material(1.5, {0}::Parameters{{{1}}}));\n", space, list);
      expected.push_back(force);
      tolerances.push_back(law_tests::form_tolerance(law));
      names.push_back(fmt::format("{} {}", law.info.id, share));
      is_rate_independent.push_back(law.info.traits.rate_independent);
      remembers.push_back(law.info.traits.remembers);
      masing.push_back(law.info.traits.masing);
    }
  }
  // At each point the compiled program first tries displacements and velocities on both sides, which must change no
  // state. Then it computes the point in the material and in a copy. Last it loads the committed state into another
  // material and makes trials with that material at rest. The next point is computed in the other material.
  std::string motion;
  for (std::size_t i = 0; i < history.disp_mm.size(); ++i)
    motion += fmt::format("  {{{}, {}}},\n", history.disp_mm[i] / 1e3, history.vel_mm_s[i] / 1e3);
  write("drive.cpp", includes + "struct Point { double x, v; };\nPoint const motion[] = {\n" + motion + R"(};
template <class Material>
void drive(Material m) {
  double const h = 1e-7;  // m
  Material fresh = m;
  for (auto const& p : motion) {
    double const above = m.trial(p.x + h, p.v), below = m.trial(p.x - h, p.v);
    double const faster = m.trial(p.x, p.v + h), slower = m.trial(p.x, p.v - h);
    m.trial(-3.0 * p.x, 2.0 * p.v);
    m.revert();
    Material copy = m;
    double const force = m.trial(p.x, p.v);
    if (copy.trial(p.x, p.v) != force) std::printf("copies differ\n");
    std::printf("%.17g %.17g %.17g %.17g %.17g %.17g %.17g ", force, m.tangent(), m.damping(), (above - force) / h,
                (force - below) / h, (faster - force) / h, (force - slower) / h);
    m.commit();
    // Saves the state as numbers and loads it into another material.
    std::vector<double> numbers(m.state_size());
    m.save(numbers.data());
    Material loaded = fresh;
    loaded.trial(0.1 + p.x, p.v);
    loaded.commit();
    bool const taken = loaded.load(numbers.data(), numbers.size());
    if (!taken || loaded.load(numbers.data(), numbers.size() - 1) || loaded.force() != m.force() ||
        loaded.tangent() != m.tangent() || loaded.damping() != m.damping())
      std::printf("a state is lost\n");
    m = loaded;
    // Makes trials at rest with the other material.
    double const on = m.trial(p.x + h, p.v), back = m.trial(p.x - h, p.v), held = m.trial(p.x, p.v);
    std::printf("%.17g %.17g %.17g\n", m.tangent(), (on - held) / h, (held - back) / h);
    m.revert();
  }
  m.revert_to_start();
  if (m.force() != 0.0 || m.trial(0.01, 0.1) != fresh.trial(0.01, 0.1)) std::printf("not at the start\n");
}
int main() {
)" + body + "}\n");
  ASSERT_EQ(run(ISOLAW_COMPILER " -std=c++17 -O1 -Wall -Wextra -Werror drive.cpp -o drive"), 0)
      << read("printed").substr(0, 3000);
  ASSERT_EQ(run("./drive"), 0);
  std::istringstream printed(read("printed"));
  ASSERT_EQ(expected.size(), names.size());
  ASSERT_GE(expected.size(), 2 * laws::catalogue().size());
  for (std::size_t c = 0; c < expected.size(); ++c) {
    SCOPED_TRACE(names[c]);
    double const peak = peak_of(expected[c]), stiffness = 1.5e3 * peak / 0.15;  // N/m
    std::string where;
    std::size_t off_tangents = 0, off_damping = 0, off_at_rest = 0;
    for (std::size_t i = 0; i < expected[c].size(); ++i) {
      double force, tangent, damping, ahead, behind, faster, slower, at_rest, on, back;
      ASSERT_TRUE(printed >> force >> tangent >> damping >> ahead >> behind >> faster >> slower >> at_rest >> on >>
                  back)
          << i;
      ASSERT_NEAR(force, 1.5e3 * expected[c][i], 1.5e3 * tolerances[c] * peak) << i;
      // The tangent must lie between the slopes to both sides, which differ at a corner and where the motion turns.
      auto const between = [&](double slope, double a, double b, double scale) {
        return slope >= std::min(a, b) - scale && slope <= std::max(a, b) + scale;
      };
      // The slope of abe contains |F2 / Yt|^n of its hysteretic force F2, which starts at 0. It has no derivative there
      // if n < 1, so a difference of forces gives the slope with a larger error.
      double const share = i == 0 ? 0.03 : 1e-3;
      // If a law remembers its peaks, its force may start like |x|^g with g < 1, whose slope is infinite. The tangent
      // is then limited to a finite value.
      bool const bounded = i == 0 && remembers[c] && tangent > 0.0 && tangent < std::min(ahead, behind);
      if (!bounded && !between(tangent, ahead, behind, 1e-4 * stiffness + share * std::abs(tangent)) &&
          ++off_tangents == 1)
        where += fmt::format("sample {}: {}, ahead {}, behind {}\n", i, tangent, ahead, behind);
      // At rest the motion has no direction. The tangent may then lie outside the slopes to both sides, more so for
      // laws that integrate along the travel or soften.
      if (masing[c] && i > 0 && !between(at_rest, on, back, 1e-4 * stiffness + 0.1 * std::abs(at_rest)) &&
          ++off_at_rest == 1)
        where += fmt::format("at rest, sample {}: {}, ahead {}, behind {}\n", i, at_rest, on, back);
      double const damping_scale = 1e-4 * stiffness * 0.3 + 1e-3 * std::abs(damping);
      if (!between(damping, faster, slower, damping_scale)) ++off_damping;
      if (is_rate_independent[c]) {
        ASSERT_EQ(damping, 0.0);
      }
    }
    EXPECT_EQ(off_tangents, 0U) << where;
    EXPECT_EQ(off_damping, 0U);
    // At rest, the tangent may lie outside the slopes to both sides at up to a tenth of the samples. Where the motion
    // first enters negative displacements, the true slope is infinite and the law limits its tangent. On the way back
    // from a peak, the tangent of power-masing-worn contains a term that is in the slope to neither side.
    EXPECT_LE(off_at_rest, expected[c].size() / 10) << where;
  }
  std::string rest;
  EXPECT_FALSE(printed >> rest) << rest;
}

TEST_F(Folder, headers_check_themselves) {
  for (auto const& law : laws::catalogue()) {
    auto const subject = subject_of(law.info.id, inside_box(law, 0.35));
    for (auto const& units : {unit_systems[law.index % 3]}) {
      auto text = cpp_header(subject, units);
      auto const build = [&] {
        write("h.hpp", text);
        return run(ISOLAW_COMPILER " -std=c++17 -O1 -Wall -Wextra -Werror -DISOLAW_SELF_CHECK -x c++ h.hpp -o check");
      };
      ASSERT_EQ(build(), 0) << read("printed").substr(0, 3000);
      EXPECT_EQ(run("./check"), 0) << law.info.id << read("printed");
      EXPECT_NE(read("printed").find("PASS"), std::string::npos);
    }
  }
  // The header's own check must fail if a parameter is changed.
  auto text = cpp_header(subject_of("bilinear", bilinear_parameters), unit_systems[0]);
  auto const at = text.find("double K2 = 0.4;");
  ASSERT_NE(at, std::string::npos);
  text.replace(at, 16, "double K2 = 0.5;");
  write("h.hpp", text);
  ASSERT_EQ(run(ISOLAW_COMPILER " -std=c++17 -DISOLAW_SELF_CHECK -x c++ h.hpp -o check"), 0);
  EXPECT_EQ(run("./check"), 1);
  EXPECT_NE(read("printed").find("FAIL"), std::string::npos);
}

// Stand-ins for materials of OpenSees in Python, written from the formulas. BoucWen takes gamma before beta.
constexpr char const* python_stub = R"text(
import math

materials = {}


def wipe():
    materials.clear()


def model(*arguments):
    pass


def euler(z, dx, A, beta, gamma, n):
    def gap(new):
        return new - z - dx * (A - abs(new) ** n * (gamma + beta * (-1.0 if dx * new < 0.0 else 1.0)))
    if dx == 0.0:
        return z
    low, high = z - abs(dx) * 10.0, z + abs(dx) * 10.0
    for _ in range(64):
        middle = 0.5 * (low + high)
        if gap(middle) > 0.0:
            high = middle
        else:
            low = middle
    return low


class Steel01:
    def __init__(self, Fy, E, b):
        self.Fy, self.E, self.b, self.x, self.f = Fy, E, b, 0.0, 0.0

    def set(self, x):
        middle, reach = self.b * self.E * x, self.Fy * (1.0 - self.b)
        self.f = min(max(self.f + self.E * (x - self.x), middle - reach), middle + reach)
        self.x = x
        return self.f


class BoucWen:
    def __init__(self, alpha, ko, n, gamma, beta, Ao, deltaA, deltaNu, deltaEta, tol=1e-8, maxIter=20):
        assert isinstance(maxIter, int)
        self.p = (Ao, beta, gamma, n)
        self.alpha, self.ko, self.x, self.z = alpha, ko, 0.0, 0.0

    def set(self, x):
        self.z = euler(self.z, x - self.x, *self.p)
        self.x = x
        return self.alpha * self.ko * x + (1.0 - self.alpha) * self.ko * self.z


class BoucWenOriginal:
    def __init__(self, E, fy, alphaL, alphaNL, mu, eta, beta, gamma, tol=1e-8, maxIter=20):
        self.uy = fy / E
        self.qd = fy - alphaL * E * self.uy - alphaNL * E * self.uy ** mu
        self.E, self.alphaL, self.p, self.x, self.z = E, alphaL, (1.0, beta, gamma, eta), 0.0, 0.0

    def set(self, x):
        self.z = euler(self.z, (x - self.x) / self.uy, *self.p)
        self.x = x
        return self.alphaL * self.E * x + self.qd * self.z


class HystereticAsym:
    def __init__(self, ka, kb, fo, b1, b2, gamma):
        self.p, self.u, self.f = (ka, kb, fo, b1, b2, gamma), 0.0, 0.0

    def set(self, u):
        ka, kb, fo, b1, b2, g = self.p
        if u == self.u:
            return self.f
        a, s = (ka - kb) / (2.0 * fo), 1.0 if u > self.u else -1.0

        def fe(x):
            return math.exp(b1 * x) - math.exp(-b2 * x) - (b1 + b2) * x
        d2 = (fe(self.u) - self.f) * math.exp(-g * self.u) + kb * self.u + s * fo
        uj = s * self.u + math.log(s * a * d2 / (ka - kb)) / a
        self.f = fe(u) + math.exp(g * u) * (kb * u + s * fo - s * (ka - kb) / a * math.exp(-a * (s * u - uj)))
        self.u = u
        return self.f


class Multiplier:
    def __init__(self, other, factor):
        self.other, self.factor = materials[other], factor

    def set(self, x):
        return self.factor * self.other.set(x)


class Parallel:
    def __init__(self, *others):
        self.others = [materials[other] for other in others]

    def set(self, x):
        return sum(other.set(x) for other in self.others)


class Elastic:
    def __init__(self, E):
        pass


class elastomericBearingPlasticity:
    def __init__(self, kInit, qd, alpha1, alpha2, mu, *rest):
        self.corner = Steel01(qd, (1.0 - alpha1) * kInit, 0.0)
        self.spring = alpha1 * kInit

    def set(self, x):
        return self.spring * x + self.corner.set(x)


class elastomericBearingBoucWen:
    def __init__(self, kInit, qd, alpha1, alpha2, mu, eta, beta, gamma, *rest):
        self.uy, self.qd, self.spring = qd / ((1.0 - alpha1) * kInit), qd, alpha1 * kInit
        self.p, self.x, self.z = (1.0, beta, gamma, eta), 0.0, 0.0

    def set(self, x):
        self.z = euler(self.z, (x - self.x) / self.uy, *self.p)
        self.x = x
        return self.spring * x + self.qd * self.z


def uniaxialMaterial(kind, tag, *arguments):
    materials[tag] = globals()[kind](*arguments)


def element(kind, tag, i, j, *arguments):
    global driven
    if kind == "zeroLength":
        assert arguments[0] == "-mat" and arguments[2:] == ("-dir", 2)
        driven = materials[arguments[1]]
        return
    print("element", kind, tag, i, j, *arguments)
    driven = globals()[kind](*arguments)


def timeSeries(kind, tag, dt_word, dt, values_word, *values):
    global path, at
    path, at = values, 0


def analyze(steps):
    global at, force
    at += 1
    force = driven.set(path[at])
    return 0


def eleForce(tag):
    return [0.0, -force, 0.0, 0.0, force, 0.0]


def ignored(*arguments):
    pass


node = fix = pattern = sp = constraints = numberer = system = algorithm = integrator = analysis = ignored
)text";

TEST_F(Folder, python_scripts_check_themselves) {
  // isolaw itself does not need python3; `./isolaw.sh test` installs it.
  if (!has("python3")) GTEST_SKIP() << "no python3 (isolaw.sh installs it): the script cannot be run";
  write("openseespy/__init__.py", "");
  write("openseespy/opensees.py", python_stub);
  struct ScriptCase {
    std::string law;
    std::vector<double> parameters;
  };
  for (auto const& c : {ScriptCase{"bilinear", bilinear_parameters}, ScriptCase{"bouc-wen", bouc_wen_parameters},
                        ScriptCase{"vaiana", vaiana_parameters()}, ScriptCase{"vaiana", vaiana_parameters(800.0, 12.0)},
                        ScriptCase{"vaiana", vaiana_parameters(-800.0, 12.0)}})
    for (auto const& units : unit_systems) {
      auto subject = subject_of(c.law, c.parameters);
      subject.device = "D'\"\\ \"\"\" {x} \xC3\xA8";
      write("bearing.py", openseespy_script(subject, realise(subject), units));
      ASSERT_EQ(run("python3 -m py_compile bearing.py"), 0) << read("printed");
      EXPECT_EQ(run("python3 bearing.py"), 0) << c.law << " " << units.id << "\n" << read("printed");
      EXPECT_NE(read("printed").find("PASS"), std::string::npos);
      EXPECT_EQ(read("printed").find("FAIL"), std::string::npos);
    }
  // Users who build OpenSees themselves have the module under the name `opensees`.
  fs::rename(folder_ / "openseespy/opensees.py", folder_ / "opensees.py");
  fs::remove_all(folder_ / "openseespy");
  EXPECT_EQ(run("python3 bearing.py"), 0) << read("printed");
  auto const bearing = subject_of("bilinear", bilinear_parameters);
  write("bearing.py", openseespy_script(bearing, realise(bearing), unit_systems[0]));
  ASSERT_EQ(run("python3 -c \"import bearing; bearing.bearing(7, 1, 2, 'upper', '-P', 3, '-Mz', 4)\""), 0);
  EXPECT_TRUE(read("printed").starts_with("element elastomericBearingPlasticity 7 1 2 ")) << read("printed");
  EXPECT_TRUE(read("printed").ends_with(" 0.0 2.0 -P 3 -Mz 4\n")) << read("printed");
  EXPECT_NE(run("python3 -c \"import bearing; bearing.material(7, 'uper')\""), 0);
  // The script's check must fail in an OpenSees that reads beta before gamma.
  auto wrong = std::string(python_stub);
  auto const at = wrong.find("n, gamma, beta, Ao");
  ASSERT_NE(at, std::string::npos);
  wrong.replace(at, 18, "n, beta, gamma, Ao");
  write("opensees.py", wrong);
  auto const subject = subject_of("bouc-wen", bouc_wen_parameters);
  write("bearing.py", openseespy_script(subject, realise(subject), unit_systems[0]));
  EXPECT_EQ(run("python3 bearing.py"), 1) << read("printed");
  EXPECT_NE(read("printed").find("FAIL"), std::string::npos);
}

// Stand-ins for Steel01, HystereticAsym, Multiplier, Parallel and the bilinear bearing of OpenSees in Tcl.
constexpr char const* tcl_stub = R"text(
foreach ignored {wipe model node fix pattern constraints numberer system algorithm integrator analysis} {
  proc $ignored {args} {}
}
proc uniaxialMaterial {kind tag args} {
  global kinds values state
  set kinds($tag) $kind
  set values($tag) $args
  set state($tag) {0.0 0.0}
}
proc element {kind tag i j args} {
  global driven
  if {$kind eq "zeroLength"} {
    set driven [lindex $args 1]
    return
  }
  puts "element $kind $tag $i $j $args"
  lassign $args kInit qd alpha1
  uniaxialMaterial Steel01 991 $qd [expr {(1.0 - $alpha1) * $kInit}] 0.0
  uniaxialMaterial Steel01 992 1e30 [expr {$alpha1 * $kInit}] 0.0
  uniaxialMaterial Parallel 993 991 992
  set driven 993
}
proc timeSeries {kind tag dt_word dt values_word values} {
  global path at
  set path $values
  set at 0
}
proc analyze {steps} {
  global path at driven force
  incr at
  set force [step $driven [lindex $path $at]]
  return 0
}
proc eleForce {tag} { global force; list 0.0 [expr {-$force}] 0.0 0.0 $force 0.0 }
proc step {tag x} {
  global kinds values state
  lassign $state($tag) before f
  switch -- $kinds($tag) {
    Steel01 {
      lassign $values($tag) Fy E b
      set middle [expr {$b * $E * $x}]
      set reach [expr {$Fy * (1.0 - $b)}]
      set f [expr {min(max($f + $E * ($x - $before), $middle - $reach), $middle + $reach)}]
    }
    HystereticAsym {
      lassign $values($tag) ka kb fo b1 b2 g
      if {$x != $before} {
        set a [expr {($ka - $kb) / (2.0 * $fo)}]
        set s [expr {$x > $before ? 1.0 : -1.0}]
        set fe {expr {exp($b1 * $u) - exp(-$b2 * $u) - ($b1 + $b2) * $u}}
        set u $before
        set d2 [expr {([eval $fe] - $f) * exp(-$g * $u) + $kb * $u + $s * $fo}]
        set uj [expr {$s * $u + log($s * $a * $d2 / ($ka - $kb)) / $a}]
        set u $x
        set f [expr {[eval $fe] + exp($g * $u) * ($kb * $u + $s * $fo - $s * ($ka - $kb) / $a * exp(-$a * ($s * $u - $uj)))}]
      }
    }
    Multiplier {
      lassign $values($tag) other factor
      set f [expr {$factor * [step $other $x]}]
    }
    Parallel {
      set f 0.0
      foreach other $values($tag) { set f [expr {$f + [step $other $x]}] }
    }
    default { error "no $kinds($tag)" }
  }
  set state($tag) [list $x $f]
  return $f
}
)text";

// If a second exported file defines the same name with another law, it must be refused with a message. It must neither
// replace the first file nor mix with it.
TEST_F(Folder, files_of_one_name_that_differ_are_refused) {
  auto const& units = unit_systems[0];
  auto const first = subject_of("bilinear", bilinear_parameters);
  auto second = first;
  second.parameters[0] *= 1.1;
  auto renamed = second;
  renamed.name = "pier_7";
  int number = 0;
  for (auto const& subject : {first, second, renamed}) {
    write(fmt::format("{}.hpp", ++number), cpp_header(subject, units));
    write(fmt::format("{}.tcl", number), opensees_script(subject, realise(subject), units));
  }
  std::string const compile = ISOLAW_COMPILER " -std=c++17 -Wall -Wextra -Werror ";
  auto const name = identifier(first, units);
  write("both.cpp",
        "#include \"1.hpp\"\n#include \"1.hpp\"\n#include \"3.hpp\"\n" + name + "::Material a;\npier_7::Material b;\n");
  EXPECT_EQ(run(compile + "-c both.cpp"), 0) << read("printed");
  write("both.cpp", "#include \"1.hpp\"\n#include \"2.hpp\"\n");
  EXPECT_NE(run(compile + "-c both.cpp"), 0);
  EXPECT_NE(read("printed").find("Another export of the name " + name + " is included already"), std::string::npos)
      << read("printed");
  // If the two files are compiled separately and linked together, each must keep its own law.
  write("one.cpp", fmt::format("#include \"1.hpp\"\ndouble one() {{ return {}::Material().trial(1.0); }}\n", name));
  write("two.cpp", fmt::format("#include \"2.hpp\"\n#include <cstdio>\ndouble one();\nint main() {{\n"
                               "  std::printf(\"%.3f %.3f\", one(), {}::Material().trial(1.0));\n}}\n",
                               name));
  ASSERT_EQ(run(compile + "one.cpp two.cpp -o apart && ./apart"), 0) << read("printed");
  EXPECT_EQ(read("printed"), "2.500 2.750");
  if (!has("tclsh")) GTEST_SKIP() << "no tclsh (isolaw.sh installs tcl): the scripts cannot be run";
  write("run.tcl", "source 1.tcl\nsource 1.tcl\nsource 3.tcl\nputs [catch {source 2.tcl} why]\nputs $why\n");
  ASSERT_EQ(run("tclsh run.tcl"), 0) << read("printed");
  EXPECT_EQ(read("printed"),
            "1\nthe name " + name + " is taken: choose another for 2.tcl by --name of isolaw export\n");
}

TEST_F(Folder, tcl_scripts_check_themselves) {
  // isolaw itself does not need tclsh; `./isolaw.sh test` installs it.
  if (!has("tclsh")) GTEST_SKIP() << "no tclsh (isolaw.sh installs tcl): the script cannot be run";
  write("stub.tcl", tcl_stub);
  auto const check = [&](Subject const& subject, UnitSystem const& units, bool good) {
    auto realisation = realise(subject);
    realisation.forms.resize(1);
    write("bearing.tcl", opensees_script(subject, realisation, units));
    write("run.tcl", fmt::format("source stub.tcl\nsource bearing.tcl\nputs \"returned [{}::self_check]\"\n",
                                 identifier(subject, units)));
    ASSERT_EQ(run("tclsh run.tcl"), 0) << read("printed");
    EXPECT_NE(read("printed").find(good ? "PASS" : "FAIL"), std::string::npos) << read("printed");
    EXPECT_NE(read("printed").find(good ? "returned 1" : "returned 0"), std::string::npos) << read("printed");
    // Set argv and argv0 as if the script were run directly with the argument `check`. It then checks itself and sets
    // the exit code.
    write("run.tcl", "source stub.tcl\nset argv check\nset argv0 bearing.tcl\nsource bearing.tcl\n");
    EXPECT_EQ(run("tclsh run.tcl"), good ? 0 : 1) << read("printed");
    EXPECT_NE(read("printed").find(good ? "PASS" : "FAIL"), std::string::npos) << read("printed");
  };
  for (auto const& units : unit_systems) {
    for (auto const& parameters :
         {vaiana_parameters(), vaiana_parameters(800.0, 12.0), vaiana_parameters(-800.0, 12.0)})
      check(subject_of("vaiana", parameters), units, true);
    auto subject = subject_of("bilinear", bilinear_parameters);
    subject.device = "x [exec false] {\\";
    check(subject, units, true);
  }
  auto const bearing = subject_of("bilinear", bilinear_parameters);
  write("bearing.tcl", opensees_script(bearing, realise(bearing), unit_systems[0]));
  write("run.tcl", "source stub.tcl\nsource bearing.tcl\n" + identifier(bearing, unit_systems[0]) +
                       "::bearing 7 1 2 upper -P 3 -Mz 4\n");
  ASSERT_EQ(run("tclsh run.tcl"), 0) << read("printed");
  EXPECT_TRUE(read("printed").starts_with("element elastomericBearingPlasticity 7 1 2 ")) << read("printed");
  EXPECT_TRUE(read("printed").ends_with(" 0.0 2.0 -P 3 -Mz 4\n")) << read("printed");
  auto wrong = std::string(tcl_stub);
  wrong.replace(wrong.find("lassign $values($tag) Fy E b"), 28, "lassign $values($tag) E Fy b");
  write("stub.tcl", wrong);
  check(subject_of("bilinear", bilinear_parameters), unit_systems[0], false);
}

}  // namespace
}  // namespace isolaw::programs_test
