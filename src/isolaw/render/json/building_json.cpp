#include "isolaw/render/json/building_json.hpp"

#include <algorithm>
#include <cmath>

#include "isolaw/base/version.hpp"
#include "isolaw/building/linear_oscillator.hpp"
#include "isolaw/data/channels/ground_motion.hpp"

namespace isolaw::render {
namespace {

constexpr int building_schema = 1;
constexpr int history_digits = 5, spectrum_digits = 4;
constexpr double mm_per_m = 1e3;

class BuildingWriter {
 public:
  BuildingWriter(JsonWriter& out, building::Study const& study, building::Answers const& answers, Digits digits)
      : out_(out),
        study_(study),
        answers_(answers),
        digits_(digits),
        systems_(digits == Digits::all ? stored_units : UnitSystems(unit_systems)) {}

  void operator()() {
    auto const& s = study_.file.settings;
    out_.member("schema", building_schema).member("isolaw", version()).member("title", s.title);
    write_said(out_.key("verdict"), systems_,
               [&](auto const& units) { return wording::paragraph(answers_.verdict, units); });
    write_findings(out_, "answer", answers_.verdict, wording::anywhere, systems_);
    truth("holds", answers_.holds);
    write_said(out_.key("about_bounds"), systems_,
               [&](auto const& units) { return wording::paragraph(answers_.about_bounds, units); });
    truth("bounds_are_enough", answers_.bounds_are_enough);
    out_.member("enough", building::wanted_share).key("warnings");
    warnings();
    write_findings(out_, "findings", answers_.warnings, wording::with_building, systems_);
    write_findings(out_, "calibration", answers_.calibration, wording::with_building, systems_);
    out_.member("assumed", answers_.assumed);
    number("weight_kN", answers_.weight_kN);
    write_values(out_.key("fixed_base_periods_s"), answers_.fixed_periods_s, rounding());
    bool const drawn = std::ranges::any_of(answers_.laws, [](auto const& law) { return law.draws > 0; });
    out_.key("draws");
    drawn ? out_.value(s.draws) : out_.null();
    out_.member("seed", s.seed);
    bound("lower_factor", s.lower), bound("upper_factor", s.upper);
    plan();
    motions();
    quantities();
    number("law_std_ln", answers_.law_std_ln);
    out_.key("laws").objects(answers_.laws, [&](building::LawAnswer const& law) {
      write_results(out_, answer_results, law, digits_, [&](std::string_view key) { nested(law, key); });
    });
  }

 private:
  void truth(std::string_view key, std::optional<bool> const& value) {
    out_.key(key);
    value ? out_.value(*value) : out_.null();
  }
  void warnings() {
    out_.begin_array();
    for (std::size_t i = 0; i < building_warnings(answers_).size(); ++i)
      write_said(out_, systems_, [&](auto const& units) { return building_warnings(answers_, units)[i]; });
    out_.end_array();
  }
  void doubts(building::LawAnswer const& law) {
    out_.begin_array();
    for (auto const& group : wording::grouped(law.doubts, wording::with_building))
      write_said(out_, systems_, [&](auto const& units) { return wording::sentence(group, units); });
    out_.end_array();
  }
  std::optional<int> rounding() const { return digits_ == Digits::all ? std::nullopt : std::optional(shown_digits); }
  void number(std::string_view key, std::optional<double> const& value) {
    write_value(out_.key(key), value ? Value(*value) : Value(), rounding());
  }
  void bound(std::string_view key, std::optional<building::PartFactors> const& factors) {
    if (!factors || factors->is_whole()) return number(key, factors ? std::optional(factors->elastic) : std::nullopt);
    out_.key(key).object([&] { number("elastic", factors->elastic), number("hysteretic", factors->hysteretic); });
  }
  void point(building::Point const& at) {
    number("x_m", at.x_mm / mm_per_m);
    number("y_m", at.y_mm / mm_per_m);
  }

  void plan() {
    out_.key("plan")
        .begin_object()
        .key("bearings")
        .objects(study_.file.bearings, [&](building::BearingPlace const& place) {
          point(place.at);
          out_.member("is",
                      place.kind == building::BearingKind::device ? std::string_view(place.device) : name(place.kind));
        });
    out_.key("corners").objects(answers_.corners, [&](building::Point const& at) { point(at); });
    out_.key("centre").object([&] { point(study_.file.frame.base.centre); }).end_object();
  }

  void motions() {
    out_.key("motions").objects(study_.file.motions, [&](building::Motion const& m) {
      double peak = 0.0;
      for (std::size_t i = 0; i < m.x_mm_s2.size(); ++i)
        peak = std::max(peak, std::hypot(m.x_mm_s2[i], m.y_mm_s2.empty() ? 0.0 : m.y_mm_s2[i]));
      out_.member("name", m.name).member("components", m.y_mm_s2.empty() ? 1 : 2);
      number("step_s", m.step_s);
      out_.member("samples", std::uint64_t{m.x_mm_s2.size()});
      number("peak_g", peak / data::gravity_mm_s2);
    });
  }

  void quantities() {
    out_.key("quantities").objects(building::quantities(), [&](building::Quantity const& row) {
      out_.member("key", row.key).member("title", row.title).member("unit", row.unit).member("meaning", row.meaning);
      out_.key("uncovered");
      row.uncovered.empty() ? out_.null() : out_.value(row.uncovered);
    });
  }

  void fractiles(std::array<double, 4> const& values) {
    for (std::size_t i = 0; i < values.size(); ++i) number(distribution_results[first_fractile + i].key, values[i]);
  }

  void distribution(building::Distribution const& d) {
    write_results(out_, distribution_results, d, digits_, [&](std::string_view key) {
      std::size_t motion = 0;
      if (key != "histogram")
        return void(out_.objects(d.by_motion, [&](auto const& of) {
          number("nominal", d.nominal_by_motion[motion++]);
          fractiles(of);
        }));
      if (d.histogram.counts.empty()) return void(out_.null());
      out_.object([&] {
        number("from", d.histogram.from), number("width", d.histogram.width);
        out_.key("counts").array(d.histogram.counts, [&](auto count) { out_.value(count); });
      });
    });
  }

  void coverage(building::LawAnswer const& law) {
    if (law.coverage.empty()) return void(out_.null());
    out_.begin_object();
    write_results(out_, coverage_results, law.coverage.front(), digits_);
    out_.key("of").object([&] {
      for (auto const& of : law.coverage)
        out_.key(of.quantity).object([&] { write_results(out_, coverage_results, of, digits_); });
    });
    out_.end_object();
  }

  void histories(building::LawAnswer const& law) {
    out_.objects(law.histories, [&](building::NominalHistory const& history) {
      write_results(out_, history_results, history, digits_, [&](std::string_view key) {
        out_.line(key == "x_mm"         ? history.x_mm
                  : key == "y_mm"       ? history.y_mm
                  : key == "shear_x_kN" ? history.shear_x_kN
                                        : history.shear_y_kN,
                  history_digits);
      });
    });
  }

  void loops(building::BearingLoops const& curves) {
    out_.member("motion", std::uint64_t{curves.motion}).member("of", curves.drawn ? "draw 1" : "nominal");
    number("step_s", curves.step_s);
    out_.key("x_mm").line(curves.x_mm, history_digits);
    out_.key("y_mm").line(curves.y_mm, history_digits);
    out_.key("rotation_rad").line(curves.rotation_rad, history_digits);
    out_.key("bearings").begin_array();
    for (std::size_t j = 0; j < curves.force_x_kN.size(); ++j) {
      out_.begin_object();
      out_.key("x_kN").line(curves.force_x_kN[j], spectrum_digits);
      out_.key("y_kN").line(curves.force_y_kN[j], spectrum_digits);
      out_.end_object();
    }
    out_.end_array();
  }

  void nested(building::LawAnswer const& law, std::string_view key) {
    if (key == "histories") return histories(law);
    if (key == "limits") return write_rows(out_, judged_results, law.limit_checks, digits_);
    if (key == "checked") return write_rows(out_, checked_results, law.checked, digits_);
    if (key == "doubts") return doubts(law);
    if (key == "coverage") return coverage(law);
    out_.begin_object();
    if (key == "floor_spectra") {
      out_.key("periods_s").line(building::spectrum_periods_s(), spectrum_digits);
      out_.key("floors_g").array(law.floor_spectra_g, [&](auto const& floor) { out_.line(floor, spectrum_digits); });
    }
    if (key == "loops") loops(law.loops);
    if (key == "peak_mm") fractiles(law.distributions.front().fractiles);
    if (key == "bearings") {
      out_.key("displacement_mm").line(law.bearing_mm, history_digits);
      out_.key("energy_share").line(law.bearing_energy_share, history_digits);
    }
    if (key == "quantities")
      for (std::size_t q = 0; q < law.distributions.size(); ++q)
        out_.key(building::quantities()[q].key).object([&] { distribution(law.distributions[q]); });
    out_.end_object();
  }

  static constexpr std::size_t first_fractile = 3;  // index in distribution_results
  static_assert(distribution_results[first_fractile].key == "p16");

  JsonWriter& out_;
  building::Study const& study_;
  building::Answers const& answers_;
  Digits digits_;
  UnitSystems systems_;
};

}  // namespace

void write_building(JsonWriter& out, building::Study const& study, building::Answers const& answers, Digits digits) {
  BuildingWriter(out, study, answers, digits)();
}

std::vector<std::string> building_warnings(building::Answers const& answers, UnitSystem const& units) {
  auto sentences = wording::sentences(answers.warnings, wording::with_building, units);
  for (auto const& sentence : wording::sentences(answers.calibration, wording::with_building, units))
    sentences.push_back(std::string(from_calibration) + sentence);
  return sentences;
}

std::vector<std::string> building_lines(building::Answers const& answers, UnitSystem const& units) {
  auto lines = wording::lines(answers.warnings, wording::with_building, units);
  std::ranges::move(wording::lines(answers.calibration, wording::with_building, units, from_calibration),
                    std::back_inserter(lines));
  return lines;
}

std::string building_json(building::Study const& study, building::Answers const& answers) {
  JsonWriter out(JsonWriter::Layout::indented);
  out.object([&] { write_building(out, study, answers, Digits::all); });
  return out.take();
}

}  // namespace isolaw::render
