// The search box of a law on one device: which parameters are free, between which values, and on which scale.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "isolaw/data/record.hpp"
#include "isolaw/laws/catalogue.hpp"

namespace isolaw::fit {

enum class BoxKind {
  published,  // Table 4 of Cucuzza et al. 2025; we supply two bounds that the table lacks. Always linear.
  scaled,     // called "auto" by the user: follows from the size of the record
};

struct Override {  // the option --set law.parameter=value|lo:hi|free|other parameter
  std::string law;
  std::string parameter;
  std::optional<laws::Interval> interval;  // equal ends fix the parameter; nullopt: free in its box, or tied
  std::string tied_to = {};                // the parameter of the same law whose value it takes; empty if not tied

  std::string text() const;  // as the user would type it
};

Override const* last_override(std::span<Override const> overrides, laws::LawEntry const& law,
                              std::string_view parameter);
std::string limits_text(laws::Interval const& limits, std::string_view unit);  // "above 0 kN/mm"
// Throws Error if the text has another form, the law or parameter is unknown, lower >= upper, the values leave the
// physical limits, or the parameter is tied to itself or to a parameter of another unit.
Override parse_override(std::string_view text);

struct SearchParameter {
  std::string name, unit;
  bool free = true;
  double value = 0.0;                       // if the parameter is fixed
  std::optional<std::size_t> tied_to = {};  // index of the parameter whose value it takes, in which case it is not free
  double lower = 0.0, upper = 0.0;
  laws::Scale scale = laws::Scale::linear;
  // Maps the unit interval to values of the parameter, and back; both clamp to the interval.
  double at(double unit_coordinate) const;
  double coordinate(double value_) const;
};

struct SearchBox {
  std::vector<SearchParameter> parameters;  // all parameters of the law, in its order
  // The point of the free parameters' unit box for these values of all parameters, clamped into the box.
  std::vector<double> contract(std::span<double const> values) const;

  std::size_t free_count() const;
  void expand(std::span<double const> point, std::span<double> values) const;
};

// The same box with logarithmic scales for two kinds of free intervals of one sign: if the ends differ by a factor of
// `wide_interval` or more, and, even if the interval ends at zero, if the law asks for such a scale. On a linear scale
// a parameter that matters by its order of magnitude would be sought in the last decade only. A scale that ends at zero
// covers six decades, a scale across zero covers six on each side.
inline constexpr double wide_interval = 100.0;
SearchBox on_logarithmic_scales(SearchBox box, laws::LawEntry const& law);
// A best value this close to an edge, as a share of the interval on the search scale, counts as at the bound.
inline constexpr double bound_tolerance = 1e-3;
enum class AtBound { no, lower, upper };
std::string_view name(AtBound bound);  // "", "lower", "upper"
AtBound at_bound(SearchParameter const& parameter, double value);
// Typical sizes of a record's quantities, in the units of the law. Throws Error for a record without samples.
laws::RecordScales scales_of(data::FitRecord const& record, laws::LawInfo const& law);
// `published` uses the scaled interval for parameters that the paper lacks. Throws Error for a parameter tied to a
// parameter that is itself tied.
SearchBox make_box(laws::LawEntry const& law, BoxKind kind, laws::RecordScales const& scales,
                   std::span<Override const> overrides);

}  // namespace isolaw::fit
