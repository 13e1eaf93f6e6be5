// The search box of a law for one device: which parameters are free, in which intervals and on which scales.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "isolaw/data/channels/record.hpp"
#include "isolaw/laws/catalogue.hpp"

namespace isolaw::fit {

enum class BoxKind {
  published,  // the intervals of Table 4 of Cucuzza et al. 2025 on linear scales; two bounds that it lacks are ours
  scaled,     // "auto" for users: intervals computed from the record's largest displacement, force, stiffness, ...
};

// The option --set law.parameter=value|lower:upper|free|other parameter.
struct Override {
  std::string law;
  std::string parameter;
  // The interval to search. Equal ends fix the parameter. nullopt: the option frees the parameter in its usual interval
  // or ties it to another parameter.
  std::optional<laws::Interval> interval;
  std::string tied_to = {};  // name of the parameter whose value this parameter takes; empty if not tied

  std::string text() const;  // the text of the option --set, as the user would type it
};

Override const* last_override(std::span<Override const> overrides, laws::LawEntry const& law,
                              std::string_view parameter);
// Says which values physical limits allow, for example "above 0 kN/mm".
std::string limits_text(laws::Interval const& limits, std::string_view unit);
// Reads the text of one --set option. Throws Error if the text has another form, the law or the parameter is unknown,
// lower >= upper, a value is outside the physical limits, or the parameter is tied to itself or to a parameter of
// another unit.
Override parse_override(std::string_view text);

struct SearchParameter {
  std::string name, unit;
  bool free = true;
  double value = 0.0;                       // the value if the parameter is neither free nor tied
  std::optional<std::size_t> tied_to = {};  // index of the parameter whose value this one takes; it is then not free
  double lower = 0.0, upper = 0.0;          // the interval to search, in `unit`, if the parameter is free
  laws::Scale scale = laws::Scale::linear;
  // at() maps [0, 1] to the parameter's interval and coordinate() maps back. Values outside are clamped.
  double at(double unit_coordinate) const;
  double coordinate(double value_) const;
};

struct SearchBox {
  std::vector<SearchParameter> parameters;  // all parameters of the law, in its order
  // Returns coordinate() of each free parameter for `values`, which hold all parameters of the law. expand() does the
  // reverse: it writes the values of all parameters.
  std::vector<double> contract(std::span<double const> values) const;

  std::size_t free_count() const;
  void expand(std::span<double const> point, std::span<double> values) const;
};

// Gives a free parameter a logarithmic scale if the law asks for it, or if the ends of its interval differ by a factor
// of `wide_interval` or more: on a linear scale, a search would spend 90 % of its points on the last decade. Intervals
// that span zero keep their scale. A logarithmic scale that ends at zero covers six decades.
inline constexpr double wide_interval = 100.0;
SearchBox on_logarithmic_scales(SearchBox box, laws::LawEntry const& law);
// A value counts as being at a bound if its distance from the bound is at most this fraction of the search interval,
// measured on the parameter's scale.
inline constexpr double bound_tolerance = 1e-3;
enum class AtBound { no, lower, upper };
std::string_view name(AtBound bound);  // for `no`, `lower` and `upper`: "", "lower", "upper"
AtBound at_bound(SearchParameter const& parameter, double value);
// Returns the search interval of a parameter with its bound `bound` moved outwards, but not beyond the physical limit.
// A bound that moves away from zero becomes ten times as large, and one that moves towards zero a tenth as large. A
// bound at zero becomes minus the other bound. nullopt if the bound is a physical limit already, or for AtBound::no.
std::optional<laws::Interval> interval_beyond(laws::ParameterInfo const& parameter, laws::Interval interval,
                                              AtBound bound);
bool same_bounds(SearchBox const& a, SearchBox const& b);
// Widens the box: if a value in `values` lies at a bound, moves this bound outwards as interval_beyond() does.
// Intervals that an override states stay as they are. nullopt if no bound moves.
std::optional<SearchBox> box_beyond(SearchBox const& box, laws::LawEntry const& law, std::span<double const> values,
                                    std::span<Override const> overrides);
// Returns the record's largest displacement, stiffness and so on, in the units of the law. Throws Error for a record
// without samples.
laws::RecordScales scales_of(data::FitRecord const& record, laws::LawInfo const& law);
// Makes the box for a law. If the paper has no interval for a parameter, BoxKind::published takes the interval of
// BoxKind::scaled. Throws Error if a parameter is tied to a parameter that is tied itself.
SearchBox make_box(laws::LawEntry const& law, BoxKind kind, laws::RecordScales const& scales,
                   std::span<Override const> overrides);

}  // namespace isolaw::fit
