// Writes the law's OpenSeesPy module, together with a building on isolators of this law: the model of the Tcl script.
#include <fmt/format.h>

#include "isolaw/base/words.hpp"
#include "isolaw/building/bearing.hpp"
#include "isolaw/laws/plane/in_plane.hpp"
#include "isolaw/programs/exports.hpp"
#include "isolaw/programs/model_text.hpp"
#include "isolaw/programs/script_addition.hpp"

namespace isolaw::programs {
namespace {

std::string python_data(ModelNumbers const& n, UnitSystem const& units) {
  std::string bearings, cases;
  for (auto const& b : n.bearings)
    bearings += fmt::format("    (\"{}\", {}, {}, {}, {}, {}, {}),\n", b.name, exact_text(b.x), exact_text(b.y),
                            exact_text(b.angle_rad), exact_text(b.load), exact_text(b.K_v), exact_text(b.mass));
  for (auto const& each : n.cases) cases += (cases.empty() ? "\"" : ", \"") + each + "\"";
  std::string text = fmt::format(
      "# A row for each isolator: name, x, y, angle [rad], load, vertical stiffness, mass above it.\n"
      "BEARINGS = [\n{}]\n"
      "# The weight on the isolators, its mass, the mass's moment of inertia about its centre, and this centre.\n"
      "WEIGHT, MASS, INERTIA, CENTRE = {}, {}, {}, ({}, {})\n"
      "HELD = {}\n"
      "# Newton's iteration stops below a displacement change of the tolerance. TESTED: largest displacement in the tests.\n"
      "TOLERANCE, TESTED = {}, {}\n"
      "CASES = [{}]\n"
      "# Ground motion: seconds between samples, analysis steps per sample, accelerations [{}/s2].\n"
      "SAMPLE_S, PIECES = {}, {}\n",
      bearings, exact_text(n.weight), exact_text(n.mass), exact_text(n.inertia), exact_text(n.x), exact_text(n.y),
      n.held ? 1 : 0, exact_text(n.tolerance), exact_text(n.tested), cases, units.length.symbol,
      exact_text(n.motion_step_s), n.pieces);
  text += "ACCELERATIONS = [\n";
  for (auto const& motion : n.motions)
    text += fmt::format("    [\n{}\n    ],\n", number_lines(motion, ", ", "        "));
  text += fmt::format("]\nSLAB_HEADER = \"{}\"\nPEAKS_HEADER = \"{}\"\nFORCE, LENGTH = \"{}\", \"{}\"\n\n\n",
                      slab_header(units), peaks_header(units), units.force.symbol, units.length.symbol);
  return text;
}

std::string python_springs(std::string_view function) {
  return fmt::format(
      "{}(tag, variant(case, i))\n"
      "ops.element(\"zeroLength\", i, i, top, \"-mat\", tag, tag, axial, \"-dir\", 1, 2, 3, \"-orient\", c, s, 0.0, -s, c, 0.0)\n",
      function);
}

std::string python_isolator(ModelNumbers const& n) {
  return n.coupled
             ? "bearing(i, i, top, variant(case, i), \"-P\", axial, \"-T\", 1, \"-My\", 1, \"-Mz\", 1, \"-orient\", 0.0, 0.0, 1.0, c, s, 0.0)\n"
             : python_springs(n.function);
}

// Says how the law itself acts in two horizontal directions, as in isolaw.building. A law that has a formula for two
// directions acts by it. Any other law acts as springs around a circle, which round off the loop's knee. Such springs
// need an odd law: its force in one direction must mirror that in the opposite direction. If the law is not odd, or the
// motion is along x alone, there is one spring along each axis instead.
building::Coupling coupling_in_model(Subject const& subject) {
  auto const coupling = building::coupling_of(subject.law->info.id, subject.parameters);
  bool const springs = laws::springs_follow(subject.law->info.id) && subject.model->motions.size() > 1;
  return coupling == building::Coupling::springs && !springs ? building::Coupling::separate : coupling;
}

// True if the bearings are springs around a circle with the parameters that the campaign fitted to such springs. For
// drawn laws there are no parameters that were fitted to springs.
bool as_fitted_springs(Subject const& subject) {
  return coupling_in_model(subject) == building::Coupling::springs && subject.springs && subject.model->draws.empty();
}

std::string python_isolator_with_law(Subject const& subject) {
  return coupling_in_model(subject) == building::Coupling::separate
             ? python_springs("law_material")
             : "about = law_arguments(variant(case, i))\n" +
                   std::string(as_fitted_springs(subject) ? "about[\"source\"] = LAW_SPRINGS\n" : "") +
                   "isolaw.opensees.section(tag, orient=[0.0, 0.0, 1.0, c, s, 0.0], **about)\n"
                   "ops.section(\"Aggregator\", tag + 1, axial, \"P\", \"-section\", tag)\n"
                   "ops.element(\"zeroLengthSection\", i, i, top, tag + 1, \"-orient\", 0.0, 0.0, 1.0, c, s, 0.0)\n";
}

std::string python_springs_of_law(Subject const& subject) {
  std::string text = "# Parameters that were fitted to the tests for the springs of a section.\nLAW_SPRINGS = {\n";
  for (std::size_t i = 0; i < subject.springs->size(); ++i)
    text += fmt::format("    \"{}\": {},\n", subject.law->parameters[i].name, exact_text((*subject.springs)[i]));
  return text + "}\n\n\n";
}

std::string indented(std::string_view lines, std::size_t by) {
  std::string text;
  for (std::string_view rest = lines; !rest.empty();) text += fmt::format("{:{}}{}\n", "", by, take_part(rest, '\n'));
  return text;
}

std::vector<Fact> law_facts(Subject const& subject) {
  auto const coupling = coupling_in_model(subject);
  return {{"Law or re-fit",
           "the isolators have the law itself if Python finds the package isolaw and this package accepts the running "
           "OpenSees, else the re-fit; a run prints which of the two they have, and why. The argument --re-fit, or "
           "RE_FIT = True below, chooses the re-fit. The errors above are those of the re-fit; the law itself has none "
           "of them"},
          {"  isolators with the law",
           coupling == building::Coupling::coupled ? "a section with the law's own form in two directions"
           : coupling == building::Coupling::springs
               ? std::string("a section of springs around the circle, with ") +
                     (as_fitted_springs(subject) ? "parameters that were fitted to such springs"
                      : subject.springs
                          ? "the parameters of the law along one direction: the springs round its knee and "
                            "dissipate less than with parameters fitted to such springs, which draws do not have"
                          : "the parameters of the law along one direction: the springs round its knee and "
                            "dissipate less (isolaw calibrate --bidirectional springs fits them)")
               : "two independent springs at right angles, along the isolator's own axes"}};
}

constexpr std::string_view python_switch =
    R"python(# True, or the argument --re-fit: the isolators have the re-fit even if the law itself is available.
RE_FIT = False


)python";

constexpr std::string_view python_choice = R"python(LAW_FAILED = "its check failed"


@functools.cache
def no_law():
    """Returns why the law itself is not available in this Python and OpenSees, or "" if it is and its check passes.
    Wipes the model."""
    global isolaw
    try:
        import isolaw.opensees

        isolaw.opensees.attach(ops)
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            return "" if law_self_check() else LAW_FAILED
    except (ImportError, OSError, AttributeError, TypeError, ValueError) as error:  # isolaw.Error is a ValueError
        return f"{type(error).__name__}: {error}"


def isolators():
    """Returns whether the isolators have the law itself, and a sentence that says whether they do, and why."""
    reason = "RE_FIT or --re-fit asks for it" if RE_FIT else no_law()
    if reason:
        return False, f"The isolators have the re-fit. Why not the law itself: {reason}."
    return True, f"The isolators have the law itself, by the Python package isolaw {isolaw.__version__}."


)python";

constexpr std::string_view python_build_head = R"python(def variant(case, i):
    """The variant of the law that isolator number i has in a case."""
    return f"{case}_{i}" if case.startswith("draw_") else case


def build(case):
    """Builds the model. Nodes 1 to n are on the ground, n + 1 to 2 n above the isolators, and 2 n + 1 at the centre of
    mass. The isolators are elements 1 to n."""
HAS_LAW    ops.wipe()
    ops.model("basic", "-ndm", 3, "-ndf", 6)
    n = len(BEARINGS)
    slab = 2 * n + 1
    ops.node(slab, *CENTRE, 0.0)
    ops.fix(slab, 0, 0, 1, 1, 1, HELD)
    ops.mass(slab, MASS, MASS, 0.0, 0.0, 0.0, INERTIA)
    ops.uniaxialMaterial("Elastic", 1, 0.0)
    for i, (_, x, y, angle, _, stiffness, own) in enumerate(BEARINGS, 1):
        top = n + i
        ops.node(i, x, y, 0.0)
        ops.node(top, x, y, 0.0)
        ops.fix(i, 1, 1, 1, 1, 1, 1)
        ops.fix(top, 0, 0, 0, 1, 1, HELD)
        ops.mass(top, 0.0, 0.0, own, 0.0, 0.0, 0.0)
        tag, axial = 10 * i, 10 * i + 9
        ops.uniaxialMaterial("Elastic", axial, stiffness)
        c, s = math.cos(angle), math.sin(angle)
)python";

constexpr std::string_view python_rest = R"python(    # OpenSees accepts no rigid diaphragm whose rotation is fixed.
    if HELD:
        ops.equalDOF(slab, n + 1, 1, 2)
    else:
        ops.rigidDiaphragm(3, slab, *range(n + 1, 2 * n + 1))


def equations():
    ops.constraints("Transformation")
    ops.numberer("RCM")
    ops.system("BandGeneral")
    ops.test("NormDispIncr", TOLERANCE, 50)
    ops.algorithm("Newton")


def vertical(i):
    return -ops.eleForce(i)[8]


def gravity():
    """Applies the vertical loads and keeps them constant."""
    n = len(BEARINGS)
    ops.timeSeries("Linear", 1)
    ops.pattern("Plain", 1, 1)
    for i, bearing_ in enumerate(BEARINGS, 1):
        ops.load(n + i, 0.0, 0.0, -bearing_[4], 0.0, 0.0, 0.0)
    equations()
    ops.integrator("LoadControl", 0.1)
    ops.analysis("Static")
    if ops.analyze(10) != 0:
        raise RuntimeError("no equilibrium under the vertical loads")
    carried = sum(vertical(i) for i in range(1, n + 1))
    if abs(carried - WEIGHT) > 1e-6 * WEIGHT:
        raise RuntimeError(f"the isolators carry {carried} of {WEIGHT}")
    ops.loadConst("-time", 0.0)
    ops.wipeAnalysis()


def step(dt):
    """Makes one step. If Newton's method does not converge, makes ten smaller ones, with KrylovNewton where needed.
    Returns 0 on success."""
    if ops.analyze(1, dt) == 0:
        return 0
    for _ in range(10):
        if ops.analyze(1, dt / 10.0) == 0:
            continue
        ops.algorithm("KrylovNewton")
        failed = ops.analyze(1, dt / 10.0)
        ops.algorithm("Newton")
        if failed != 0:
            return failed
    return 0


def opened(*names):
    return open(os.path.join(*names), "w", encoding="utf-8")


def shake(case, folder):
    """Shakes the model of one case and writes its motion to folder/case. Returns the largest displacement of an isolator,
    the name of this isolator, the largest displacement of the slab's centre, the largest shear along x, along y and in
    plan, the largest rotation, the displacement of the slab at the end, and the lines for peaks.csv."""
    build(case)
    gravity()
    for tag, values in enumerate(ACCELERATIONS, 2):
        ops.timeSeries("Path", tag, "-dt", SAMPLE_S, "-values", *(float(a) for a in values))
        ops.pattern("UniformExcitation", tag, tag - 1, "-accel", tag)
    equations()
    ops.integrator("Newmark", 0.5, 0.25)
    ops.analysis("Transient")
    os.makedirs(os.path.join(folder, case), exist_ok=True)
    n = len(BEARINGS)
    slab = 2 * n + 1
    names = [each[0] for each in BEARINGS]
    far, strong, left = [0.0] * n, [0.0] * n, [0.0] * n
    load = [vertical(i) for i in range(1, n + 1)]
    most_slab = most_x = most_y = most = most_turn = 0.0
    dt = SAMPLE_S / PIECES
    with opened(folder, case, "slab.csv") as slab_file, opened(folder, case, "bearings.csv") as bearing_file:
        print(SLAB_HEADER, file=slab_file)
        print("time [s]", *(f"{name} {what}" for name in names for what in
                            (f"ux [{LENGTH}]", f"uy [{LENGTH}]", f"Fx [{FORCE}]", f"Fy [{FORCE}]")),
              sep=",", file=bearing_file)
        print("0.0,0.0,0.0,0.0,0.0,0.0", file=slab_file)
        print("0.0" + ",0.0" * (4 * n), file=bearing_file)
        for sample in range(1, len(ACCELERATIONS[0])):
            for _ in range(PIECES):
                if step(dt) != 0:
                    raise RuntimeError(f"case {case}: no equilibrium at {ops.getTime()} s")
                sum_x = sum_y = 0.0
                row = []
                for i in range(n):
                    ux, uy = ops.nodeDisp(n + 1 + i)[:2]
                    force_x, force_y = ops.eleForce(i + 1)[6:8]
                    sum_x += force_x
                    sum_y += force_y
                    left[i], force = math.hypot(ux, uy), math.hypot(force_x, force_y)
                    if not (left[i] < 1e30 and force < 1e30):
                        raise RuntimeError(f"case {case}: displacement or force is no number at {ops.getTime()} s")
                    far[i], strong[i] = max(far[i], left[i]), max(strong[i], force)
                    row += [f"{value:.10g}" for value in (ux, uy, force_x, force_y)]
                ux, uy, _, _, _, turn = ops.nodeDisp(slab)
                most_slab = max(most_slab, math.hypot(ux, uy))
                most_x, most_y = max(most_x, abs(sum_x)), max(most_y, abs(sum_y))
                most, most_turn = max(most, math.hypot(sum_x, sum_y)), max(most_turn, abs(turn))
            time = f"{sample * SAMPLE_S:.10g}"
            print(time, *(f"{value:.10g}" for value in (ux, uy, turn, sum_x, sum_y)), sep=",", file=slab_file)
            print(time, *row, sep=",", file=bearing_file)
    ops.wipe()
    worst = far.index(max(far))
    lines = [f"{case},{names[i]},{far[i]:.8g},{strong[i]:.8g},{load[i]:.8g},{left[i]:.8g}" for i in range(n)]
    return far[worst], names[worst], most_slab, most_x, most_y, most, most_turn, math.hypot(ux, uy), lines


def table_row(*cells):
    print("{:<10} {:>12} {:<12} {:>12} {:>12} {:>12} {:>12} {:>12} {:>12}".format(*cells))


def run(folder, which=()):
    """Runs the named cases, or all if none is named. Prints the largest values and writes them to folder/peaks.csv."""
    for case in which:
        if case not in CASES:
            raise ValueError(f"no case {case}; there is: {' '.join(CASES)}")
    os.makedirs(folder, exist_ok=True)
SAY_WHICH    table_row("case", "isolator", "which", "slab", "Vx", "Vy", "V/weight", "rotation", "left at end")
    table_row("", f"[{LENGTH}]", "", f"[{LENGTH}]", f"[{FORCE}]", f"[{FORCE}]", "", "[rad]", f"[{LENGTH}]")
    beyond, drawn = [], []
    with opened(folder, "peaks.csv") as peaks:
        print(PEAKS_HEADER, file=peaks)
        for case in which or CASES:
            far, name, slab, sum_x, sum_y, both, turn, left, lines = shake(case, folder)
            print(*lines, sep="\n", file=peaks, flush=True)
            table_row(case, f"{far:.5g}", name, f"{slab:.5g}", f"{sum_x:.5g}", f"{sum_y:.5g}", f"{both / WEIGHT:.4g}",
                      f"{turn:.3g}", f"{left:.3g}")
            if far > TESTED:
                beyond.append(f"{case} moves {name} by {far:.4g}")
            if case.startswith("draw_"):
                drawn.append((far, slab, sum_x, sum_y, both / WEIGHT, turn, left))
    if len(drawn) > 1:
        for what, of in (("mean", lambda values: sum(values) / len(values)), ("largest", max)):
            far, *others = [f"{of(values):.4g}" for values in zip(*drawn)]
            table_row(what, far, "of draws", *others)
    if beyond:
        print(f"WARNING: beyond the {TESTED:.4g} {LENGTH} that were tested, where the law is an extrapolation: "
              + "; ".join(beyond))
    print("written:", folder)


def main(arguments):
    """Runs the analyses if the first argument is `run`, else the self-check. Returns the exit code."""
ARGUMENTS    if not arguments or arguments[0] != "run":
        passed = self_check()
CHECK        return 0 if passed else 1
    try:
        run(arguments[1] if len(arguments) > 1 else "FOLDER", arguments[2:])
    except (RuntimeError, ValueError, OSError) as error:
        print("isolaw:", error, file=sys.stderr)
        return 1
    return 0


)python";

}  // namespace

std::string openseespy_model(Subject const& subject, Realisation const& realisation, UnitSystem const& units) {
  auto const numbers = model_numbers(subject, realisation, units);
  auto const folder = identifier(subject, units) + "_results";
  ScriptAddition addition;
  addition.facts = model_facts(subject, realisation, units);
  addition.usage = run_usage("python3 this-file", folder, numbers);
  bool const either = !realisation.substitute.empty();
  auto const isolator = python_isolator(numbers);
  auto build = std::string(python_build_head), rest = std::string(python_rest);
  auto const set = [](std::string& text, std::string_view place, std::string_view by) {
    text.replace(text.find(place), place.size(), by);
  };
  set(rest, "FOLDER\"", folder + "\"");
  set(build, "HAS_LAW", either ? "    has_law = isolators()[0]\n" : "");
  set(rest, "SAY_WHICH",
      either ? "    which_one = isolators()[1]\n"
               "    print(which_one)\n"
               "    with opened(folder, \"isolators.txt\") as file:\n"
               "        print(which_one, file=file)\n"
             : "");
  set(rest, "ARGUMENTS",
      either ? "    global RE_FIT\n"
               "    RE_FIT = RE_FIT or \"--re-fit\" in arguments\n"
               "    arguments = [word for word in arguments if word != \"--re-fit\"]\n"
             : "");
  set(rest, "CHECK",
      either ? "        passed = no_law() != LAW_FAILED and passed\n"
               "        print(isolators()[1])\n"
             : "");
  addition.procedures = fmt::format("{}import math\nimport os\nimport sys\n{}\n", either ? "import functools\n" : "",
                                    either ? "import warnings\n" : "") +
                        python_data(numbers, units);
  if (either) {
    for (auto& fact : law_facts(subject)) addition.facts.push_back(std::move(fact));
    addition.head = python_switch;
    addition.usage += "#           --re-fit: the isolators have the re-fit even if the law itself is available\n";
    addition.procedures += law_in_python(subject, units, "law_");
    if (as_fitted_springs(subject)) addition.procedures += python_springs_of_law(subject);
    addition.procedures += python_choice;
  }
  addition.procedures += build;
  if (either)
    addition.procedures +=
        "        if has_law:\n"
        "            # No warning that a static analysis has no velocity: these loads move nothing in plan.\n"
        "            with warnings.catch_warnings():\n"
        "                warnings.simplefilter(\"ignore\")\n" +
        indented(python_isolator_with_law(subject), 16) + "        else:\n" + indented(isolator, 12);
  else
    addition.procedures += indented(isolator, 8);
  addition.procedures += rest;
  addition.dispatch = "sys.exit(main(sys.argv[1:]))\n";
  return openseespy_script(subject, realisation, units, addition);
}

}  // namespace isolaw::programs
