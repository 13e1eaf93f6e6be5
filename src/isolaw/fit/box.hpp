// Where the parameters of a law are searched on one device: which are free, between which values, on which scale.
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
  published,  // Table 4 of the paper, with the two bounds lost there supplied; always linear
  scaled,     // "auto": from the size of the record
};

// Option --set law.parameter=value|lo:hi|free|other parameter.
struct Override {
  std::string law;
  std::string parameter;
  std::optional<laws::Interval> interval;  // equal ends: fixed at that value; nullopt: free in its box, or tied
  std::string tied_to = {};                // another parameter of the law whose value it takes; empty: none

  std::string text() const;  // as the user would type it
};

// Of the parameter, the last, which counts; nullptr: none.
Override const* last_override(std::span<Override const> overrides, laws::LawEntry const& law,
                              std::string_view parameter);

// What a parameter may be, "above 0 kN/mm".
std::string limits_text(laws::Interval const& limits, std::string_view unit);

// Throws Error: malformed, unknown law or parameter, lower >= upper, outside the physical limits, a tie to itself or to
// a parameter of another unit.
Override parse_override(std::string_view text);

struct SearchParameter {
  std::string name, unit;
  bool free = true;
  double value = 0.0;                       // when fixed
  std::optional<std::size_t> tied_to = {};  // not free: takes the value of this one; free: none
  double lower = 0.0, upper = 0.0;
  laws::Scale scale = laws::Scale::linear;

  // From the unit interval to the parameter's value and back (clamped to it).
  double at(double unit_coordinate) const;
  double coordinate(double value_) const;
};

struct SearchBox {
  std::vector<SearchParameter> parameters;  // all of the law's, in its order

  // The point of the unit box that gives these values of the law's parameters, the free ones clamped into it.
  std::vector<double> contract(std::span<double const> values) const;

  std::size_t free_count() const;
  // Parameter values for a point of the unit box of the free parameters.
  void expand(std::span<double const> point, std::span<double> values) const;
};

// The same box, searched on a logarithmic scale in every free interval of one sign that spans a factor of
// `wide_interval` or more, and in those that end at zero where the law's own box is logarithmic: what acts through its
// order of magnitude is otherwise looked for in the last decade alone. A scale that ends at zero holds six decades, one
// across it six on each side.
inline constexpr double wide_interval = 100.0;
SearchBox on_logarithmic_scales(SearchBox box, laws::LawEntry const& law);

// A best value this close to an edge, as a share of the interval on the search scale, is at its bound.
inline constexpr double bound_tolerance = 1e-3;
enum class AtBound { no, lower, upper };
std::string_view name(AtBound bound);  // "", "lower", "upper"
AtBound at_bound(SearchParameter const& parameter, double value);

// The size of a record in the units of a law. Throws Error for a record without samples.
laws::RecordScales scales_of(data::FitRecord const& record, laws::LawInfo const& law);

// `published` falls back to the scaled interval for parameters the paper does not calibrate. Throws Error for a tie to
// a parameter that is tied itself.
SearchBox make_box(laws::LawEntry const& law, BoxKind kind, laws::RecordScales const& scales,
                   std::span<Override const> overrides);

}  // namespace isolaw::fit
