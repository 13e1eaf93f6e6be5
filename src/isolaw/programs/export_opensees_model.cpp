// Writes the law's Tcl script for OpenSees, together with a building on isolators of this law.
#include <fmt/format.h>

#include "isolaw/base/words.hpp"
#include "isolaw/programs/exports.hpp"
#include "isolaw/programs/model_text.hpp"
#include "isolaw/programs/script_addition.hpp"

namespace isolaw::programs {
namespace {

std::string tcl_bearings(ModelNumbers const& numbers) {
  std::string text;
  for (auto const& b : numbers.bearings)
    text += fmt::format("    {{{{{}}} {} {} {} {} {} {}}}\n", b.name, exact_text(b.x), exact_text(b.y),
                        exact_text(b.angle_rad), exact_text(b.load), exact_text(b.K_v), exact_text(b.mass));
  return text;
}

std::string tcl_data(ModelNumbers const& n, UnitSystem const& units) {
  std::string text = fmt::format(
      "  # A row for each isolator: name, x, y, angle [rad], load, vertical stiffness, mass above it.\n"
      "  variable bearings {{\n{}  }}\n"
      "  # The weight on the isolators, its mass, the mass's moment of inertia about its centre, and this centre.\n"
      "  variable weight {}\n  variable mass {}\n  variable inertia {}\n  variable centre_x {}\n  variable centre_y {}\n"
      "  variable held {}\n"
      "  # Newton's iteration stops below a displacement change of the tolerance. `tested`: largest displacement in the tests.\n"
      "  variable tolerance {}\n  variable tested {}\n"
      "  variable cases {{{}}}\n"
      "  # Ground motion: seconds between samples, analysis steps per sample, accelerations [{}/s2].\n"
      "  variable sample_s {}\n  variable pieces {}\n",
      tcl_bearings(n), exact_text(n.weight), exact_text(n.mass), exact_text(n.inertia), exact_text(n.x),
      exact_text(n.y), n.held ? 1 : 0, exact_text(n.tolerance), exact_text(n.tested), joined(n.cases, " "),
      units.length.symbol, exact_text(n.motion_step_s), n.pieces);
  for (std::size_t i = 0; i < 2; ++i)
    text += fmt::format("  variable acceleration_{} {{\n{}\n  }}\n", i == 0 ? "x" : "y",
                        i < n.motions.size() ? number_lines(n.motions[i], " ", "    ") : std::string());
  text += fmt::format("  variable slab_header {{{}}}\n  variable peaks_header {{{}}}\n  variable units {{{} {}}}\n\n",
                      slab_header(units), peaks_header(units), units.force.symbol, units.length.symbol);
  return text;
}

std::string tcl_isolator(ModelNumbers const& n) {
  return n.coupled
             ? "      bearing $i $i $top [variant $case $i] -P $axial -T 1 -My 1 -Mz 1 -orient 0.0 0.0 1.0 $c $s 0.0\n"
             : fmt::format(
                   "      {} $tag [variant $case $i]\n"
                   "      element zeroLength $i $i $top -mat $tag $tag $axial -dir 1 2 3 -orient $c $s 0.0 [expr {{-$s}}] $c 0.0\n",
                   n.function);
}

constexpr std::string_view tcl_build_head = R"tcl(  # The variant of the law that isolator number i has in a case.
  proc variant {case i} {
    return [expr {[string match draw_* $case] ? "${case}_$i" : $case}]
  }

  # Builds the model. Nodes 1 to n are on the ground, n + 1 to 2 n above the isolators, and 2 n + 1 at the centre of
  # mass. The isolators are elements 1 to n.
  proc build {case} {
    foreach name {bearings mass inertia centre_x centre_y held} { variable $name }
    wipe
    model basic -ndm 3 -ndf 6
    set n [llength $bearings]
    set slab [expr {2 * $n + 1}]
    node $slab $centre_x $centre_y 0.0
    fix $slab 0 0 1 1 1 $held
    mass $slab $mass $mass 0.0 0.0 0.0 $inertia
    uniaxialMaterial Elastic 1 0.0
    set tops {}
    set i 0
    foreach bearing $bearings {
      incr i
      lassign $bearing name x y angle load stiffness own
      set top [expr {$n + $i}]
      lappend tops $top
      node $i $x $y 0.0
      node $top $x $y 0.0
      fix $i 1 1 1 1 1 1
      fix $top 0 0 0 1 1 $held
      mass $top 0.0 0.0 $own 0.0 0.0 0.0
      set tag [expr {10 * $i}]
      set axial [expr {$tag + 9}]
      uniaxialMaterial Elastic $axial $stiffness
      set c [expr {cos($angle)}]
      set s [expr {sin($angle)}]
)tcl";

constexpr std::string_view tcl_rest = R"tcl(    }
    # OpenSees accepts no rigid diaphragm whose rotation is fixed.
    if {$held} { equalDOF $slab {*}$tops 1 2 } else { rigidDiaphragm 3 $slab {*}$tops }
  }

  proc equations {} {
    variable tolerance
    constraints Transformation
    numberer RCM
    system BandGeneral
    test NormDispIncr $tolerance 50
    algorithm Newton
  }

  # Applies the vertical loads and keeps them constant.
  proc gravity {} {
    variable bearings
    variable weight
    set n [llength $bearings]
    set loads ""
    set i $n
    foreach bearing $bearings { append loads "load [incr i] 0.0 0.0 [expr {-[lindex $bearing 4]}] 0.0 0.0 0.0\n" }
    timeSeries Linear 1
    pattern Plain 1 1 $loads
    equations
    integrator LoadControl 0.1
    analysis Static
    if {[analyze 10] != 0} { error "no equilibrium under the vertical loads" }
    set carried 0.0
    for {set i 1} {$i <= $n} {incr i} { set carried [expr {$carried - [lindex [eleForce $i] 8]}] }
    if {abs($carried - $weight) > 1e-6 * $weight} { error "the isolators carry $carried of $weight" }
    loadConst -time 0.0
    wipeAnalysis
  }

  # Makes one step. If Newton's method does not converge, makes ten smaller ones, with KrylovNewton where needed.
  # Returns 0 on success.
  proc step {dt} {
    if {[analyze 1 $dt] == 0} { return 0 }
    for {set k 0} {$k < 10} {incr k} {
      if {[analyze 1 [expr {$dt / 10.0}]] == 0} continue
      algorithm KrylovNewton
      set failed [analyze 1 [expr {$dt / 10.0}]]
      algorithm Newton
      if {$failed != 0} { return $failed }
    }
    return 0
  }

  # Shakes the model of one case and writes its motion to folder/case. Returns the largest displacement of an isolator,
  # the name of this isolator, the largest displacement of the slab's centre, the largest shear along x, along y and in
  # plan, the largest rotation, the displacement of the slab at the end, and the lines for peaks.csv.
  proc shake {case folder} {
    foreach name {bearings acceleration_x acceleration_y sample_s pieces slab_header units} { variable $name }
    build $case
    gravity
    set tag 1
    foreach values [list $acceleration_x $acceleration_y] {
      incr tag
      if {[llength $values] == 0} continue
      timeSeries Path $tag -dt $sample_s -values $values
      pattern UniformExcitation $tag [expr {$tag - 1}] -accel $tag
    }
    equations
    integrator Newmark 0.5 0.25
    analysis Transient
    file mkdir [file join $folder $case]
    set slab_file [open [file join $folder $case slab.csv] w]
    set bearing_file [open [file join $folder $case bearings.csv] w]
    puts $slab_file $slab_header
    lassign $units force length
    set line {time [s]}
    foreach bearing $bearings {
      set name [lindex $bearing 0]
      append line ",$name ux \[$length\],$name uy \[$length\],$name Fx \[$force\],$name Fy \[$force\]"
    }
    puts $bearing_file $line
    set n [llength $bearings]
    set slab [expr {2 * $n + 1}]
    for {set i 1} {$i <= $n} {incr i} {
      set far($i) 0.0
      set strong($i) 0.0
      set left($i) 0.0
      set load($i) [expr {-[lindex [eleForce $i] 8]}]
    }
    set most_slab 0.0
    set most_x 0.0
    set most_y 0.0
    set most 0.0
    set most_turn 0.0
    set dt [expr {$sample_s / $pieces}]
    set samples [llength $acceleration_x]
    puts $slab_file "0.0,0.0,0.0,0.0,0.0,0.0"
    puts $bearing_file "0.0[string repeat ,0.0 [expr {4 * $n}]]"
    for {set sample 1} {$sample < $samples} {incr sample} {
      for {set piece 0} {$piece < $pieces} {incr piece} {
        if {[step $dt] != 0} { error "case $case: no equilibrium at [getTime] s" }
        set Vx 0.0
        set Vy 0.0
        set row ""
        for {set i 1} {$i <= $n} {incr i} {
          lassign [nodeDisp [expr {$n + $i}]] ux uy
          lassign [lrange [eleForce $i] 6 7] Fx Fy
          set Vx [expr {$Vx + $Fx}]
          set Vy [expr {$Vy + $Fy}]
          set left($i) [expr {hypot($ux, $uy)}]
          if {!($left($i) < 1e30)} { error "case $case: the displacement is no number at [getTime] s" }
          set F [expr {hypot($Fx, $Fy)}]
          if {!($F < 1e30)} { error "case $case: the force is no number at [getTime] s" }
          if {$left($i) > $far($i)} { set far($i) $left($i) }
          if {$F > $strong($i)} { set strong($i) $F }
          append row [format ",%.10g,%.10g,%.10g,%.10g" $ux $uy $Fx $Fy]
        }
        lassign [nodeDisp $slab] ux uy uz rx ry turn
        set most_slab [expr {max($most_slab, hypot($ux, $uy))}]
        set most_x [expr {max($most_x, abs($Vx))}]
        set most_y [expr {max($most_y, abs($Vy))}]
        set most [expr {max($most, hypot($Vx, $Vy))}]
        set most_turn [expr {max($most_turn, abs($turn))}]
      }
      set time [format %.10g [expr {$sample * $sample_s}]]
      puts $slab_file [format "%s,%.10g,%.10g,%.10g,%.10g,%.10g" $time $ux $uy $turn $Vx $Vy]
      puts $bearing_file "$time$row"
    }
    close $slab_file
    close $bearing_file
    wipe
    set worst 1
    set lines ""
    for {set i 1} {$i <= $n} {incr i} {
      if {$far($i) > $far($worst)} { set worst $i }
      append lines [format "%s,%s,%.8g,%.8g,%.8g,%.8g\n" $case [lindex $bearings [expr {$i - 1}] 0] $far($i) $strong($i) $load($i) $left($i)]
    }
    return [list $far($worst) [lindex $bearings [expr {$worst - 1}] 0] $most_slab $most_x $most_y $most $most_turn [expr {hypot($ux, $uy)}] $lines]
  }

  # Runs the named cases, or all if none is named. Prints the largest values and writes them to folder/peaks.csv.
  proc run {folder which} {
    foreach name {cases weight tested peaks_header units} { variable $name }
    foreach case $which {
      if {$case ni $cases} { error "no case $case; there is: $cases" }
    }
    if {[llength $which] == 0} { set which $cases }
    lassign $units force length
    file mkdir $folder
    set peaks [open [file join $folder peaks.csv] w]
    puts $peaks $peaks_header
    set row "%-10s %12s %-12s %12s %12s %12s %12s %12s %12s"
    puts [format $row case "isolator" "which" "slab" "Vx" "Vy" "V/weight" "rotation" "left at end"]
    puts [format $row "" "\[$length\]" "" "\[$length\]" "\[$force\]" "\[$force\]" "" "\[rad\]" "\[$length\]"]
    set beyond {}
    set drawn {}
    foreach case $which {
      lassign [shake $case $folder] far name slab Vx Vy V turn left lines
      puts -nonewline $peaks $lines
      flush $peaks
      set cells [lmap value [list $far $slab $Vx $Vy] { format %.5g $value }]
      lappend cells [format %.4g [expr {$V / $weight}]] [format %.3g $turn] [format %.3g $left]
      puts [format $row $case {*}[linsert $cells 1 $name]]
      if {$far > $tested} { lappend beyond "$case moves $name by [format %.4g $far]" }
      if {[string match draw_* $case]} { lappend drawn [list $far $slab $Vx $Vy [expr {$V / $weight}] $turn $left] }
    }
    close $peaks
    if {[llength $drawn] > 1} {
      for {set k 0} {$k < 7} {incr k} {
        set values [lsort -real [lmap one $drawn { lindex $one $k }]]
        lappend means [expr {[tcl::mathop::+ {*}$values] / [llength $values]}]
        lappend largest [lindex $values end]
      }
      foreach what {mean largest} values [list $means $largest] {
        lassign [lmap value $values { format %.4g $value }] far slab Vx Vy V turn left
        puts [format $row $what $far "of draws" $slab $Vx $Vy $V $turn $left]
      }
    }
    if {[llength $beyond] > 0} {
      puts "WARNING: beyond the [format %.4g $tested] $length that were tested, where the law is an extrapolation: [join $beyond {; }]"
    }
    puts "written: $folder"
  }
)tcl";

}  // namespace

std::string opensees_model(Subject const& subject, Realisation const& realisation, UnitSystem const& units) {
  auto const numbers = model_numbers(subject, realisation, units);
  auto const space = identifier(subject, units);
  ScriptAddition addition;
  addition.facts = model_facts(subject, realisation, units);
  addition.usage = run_usage("OpenSees this-file", space + "_results", numbers);
  addition.procedures =
      tcl_data(numbers, units) + std::string(tcl_build_head) + tcl_isolator(numbers) + std::string(tcl_rest);
  addition.dispatch = fmt::format(
      "if {{[info exists argv0] && [info script] eq $argv0 && [info exists argv] && [lindex $argv 0] eq \"run\"}} {{\n"
      "  set folder [expr {{[llength $argv] > 1 ? [lindex $argv 1] : \"{0}_results\"}}]\n"
      "  if {{[catch {{ {0}::run $folder [lrange $argv 2 end] }} message]}} {{\n    puts stderr \"isolaw: $message\"\n    exit 1\n  }}\n"
      "  exit 0\n}}\n",
      space);
  return opensees_script(subject, realisation, units, addition);
}

}  // namespace isolaw::programs
