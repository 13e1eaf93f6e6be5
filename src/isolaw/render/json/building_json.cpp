#include "isolaw/render/json/building_json.hpp"

#include <algorithm>
#include <cmath>

#include "isolaw/base/version.hpp"
#include "isolaw/data/ground_motion.hpp"

namespace isolaw::render {
namespace {

constexpr int building_schema = 1;
constexpr int history_digits = 5, spectrum_digits = 4;
constexpr double mm_per_m = 1e3;

class BuildingWriter {
 public:
  BuildingWriter(JsonWriter& out, building::Study const& study, building::Answers const& answers, Digits digits)
      : out_(out), study_(study), answers_(answers), digits_(digits) {}

  void operator()() {
    auto const& s = study_.file.settings;
    out_.member("schema", building_schema).member("isolaw", version()).member("title", s.title);
    out_.member("verdict", wording::paragraph(answers_.verdict)).key("bounds_are_enough");
    answers_.bounds_are_enough ? out_.value(*answers_.bounds_are_enough) : out_.null();
    out_.member("enough", building::wanted_share).member("warnings", building_warnings(answers_));
    write_findings(out_, "findings", answers_.warnings, wording::with_building);
    write_findings(out_, "calibration", answers_.calibration, wording::with_building);
    out_.member("assumed", answers_.assumed);
    number("weight_kN", answers_.weight_kN);
    write_values(out_.key("fixed_base_periods_s"), answers_.fixed_periods_s, rounding());
    out_.member("draws", s.draws).member("seed", s.seed);
    number("lower_factor", s.lower), number("upper_factor", s.upper);
    plan();
    motions();
    quantities();
    number("law_std_ln", answers_.law_std_ln);
    each("laws", answers_.laws, [&](building::LawAnswer const& law) {
      write_results(out_, answer_results, law, digits_, [&](std::string_view key) { nested(law, key); });
    });
  }

 private:
  std::optional<int> rounding() const { return digits_ == Digits::all ? std::nullopt : std::optional(shown_digits); }
  void number(std::string_view key, std::optional<double> const& value) {
    write_value(out_.key(key), value ? Value(*value) : Value(), rounding());
  }
  template <class Items, class Write>
  void each(std::string_view key, Items const& items, Write const& write) {
    out_.key(key).begin_array();
    for (auto const& item : items) {
      out_.begin_object();
      write(item);
      out_.end_object();
    }
    out_.end_array();
  }
  void point(building::Point const& at) {
    number("x_m", at.x_mm / mm_per_m);
    number("y_m", at.y_mm / mm_per_m);
  }

  void plan() {
    out_.key("plan").begin_object();
    each("bearings", study_.file.bearings, [&](building::BearingPlace const& place) {
      point(place.at);
      out_.member("is", place.stands == building::Stands::device ? std::string_view(place.device) : name(place.stands));
    });
    each("corners", answers_.corners, [&](building::Point const& at) { point(at); });
    out_.key("centre").begin_object();
    point(study_.file.frame.base.centre);
    out_.end_object().end_object();
  }

  void motions() {
    each("motions", study_.file.motions, [&](building::Motion const& m) {
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
    each("quantities", building::quantities(), [&](building::Quantity const& row) {
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
      if (key == "histogram") {
        out_.begin_object();
        number("from", d.histogram.from), number("width", d.histogram.width);
        out_.key("counts").begin_array();
        for (auto const count : d.histogram.counts) out_.value(count);
        out_.end_array().end_object();
        return;
      }
      out_.begin_array();
      for (std::size_t m = 0; m < d.by_motion.size(); ++m) {
        out_.begin_object();
        number("nominal", d.nominal_by_motion[m]);
        fractiles(d.by_motion[m]);
        out_.end_object();
      }
      out_.end_array();
    });
  }

  void coverage(building::LawAnswer const& law) {
    out_.begin_object();
    if (!law.coverage.empty()) write_results(out_, coverage_results, law.coverage.front(), digits_);
    out_.key("of").begin_object();
    for (std::size_t i = 0; i < law.coverage.size(); ++i) {
      out_.key(law.coverage[i].quantity).begin_object();
      write_results(out_, coverage_results, law.coverage[i], digits_);
      out_.end_object();
    }
    out_.end_object().end_object();
  }

  void histories(building::LawAnswer const& law) {
    out_.begin_array();
    for (auto const& history : law.histories) {
      out_.begin_object();
      write_results(out_, history_results, history, digits_, [&](std::string_view key) {
        out_.line(key == "x_mm"         ? history.x_mm
                  : key == "y_mm"       ? history.y_mm
                  : key == "shear_x_kN" ? history.shear_x_kN
                                        : history.shear_y_kN,
                  history_digits);
      });
      out_.end_object();
    }
    out_.end_array();
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
    if (key == "coverage") return coverage(law);
    if (key == "histories") return histories(law);
    if (key == "checked") {
      out_.begin_array();
      for (auto const& checked : law.checked) {
        out_.begin_object();
        write_results(out_, checked_results, checked, digits_);
        out_.end_object();
      }
      out_.end_array();
      return;
    }
    if (key == "doubts") {
      out_.value(wording::sentences(law.doubts, wording::with_building));
      return;
    }
    out_.begin_object();
    if (key == "floor_spectra") {
      out_.key("periods_s").line(building::spectrum_periods_s(), spectrum_digits);
      out_.key("floors_g").begin_array();
      for (auto const& floor : law.floor_spectra_g) out_.line(floor, spectrum_digits);
      out_.end_array();
    }
    if (key == "loops") loops(law.loops);
    if (key == "peak_mm") fractiles(law.distributions.front().fractiles);
    if (key == "bearings") {
      out_.key("displacement_mm").line(law.bearing_mm, history_digits);
      out_.key("energy_share").line(law.bearing_energy_share, history_digits);
    }
    if (key == "quantities")
      for (std::size_t q = 0; q < law.distributions.size(); ++q) {
        out_.key(building::quantities()[q].key).begin_object();
        distribution(law.distributions[q]);
        out_.end_object();
      }
    out_.end_object();
  }

  static constexpr std::size_t first_fractile = 3;  // the index of the first fractile in distribution_results
  static_assert(distribution_results[first_fractile].key == "p16");

  JsonWriter& out_;
  building::Study const& study_;
  building::Answers const& answers_;
  Digits digits_;
};

}  // namespace

void write_building(JsonWriter& out, building::Study const& study, building::Answers const& answers, Digits digits) {
  BuildingWriter(out, study, answers, digits)();
}

std::vector<std::string> building_warnings(building::Answers const& answers) {
  auto sentences = wording::sentences(answers.warnings, wording::with_building);
  for (auto const& sentence : wording::sentences(answers.calibration, wording::with_building))
    sentences.push_back("From the calibration: " + sentence);
  return sentences;
}

std::string building_json(building::Study const& study, building::Answers const& answers) {
  JsonWriter out(JsonWriter::Layout::indented);
  out.begin_object();
  write_building(out, study, answers, Digits::all);
  out.end_object();
  return out.take();
}

}  // namespace isolaw::render
