#include "isolaw/data/cycles/excursions.hpp"

#include <algorithm>
#include <cmath>

namespace isolaw::data {
namespace {

constexpr double at_rest = 0.05;   // a point closer to the centre than this fraction of the reach counts as the centre
constexpr double alike = 0.15;     // the reaches of alike excursions differ by at most this fraction of the larger one
constexpr double same_fall = 1.5;  // the times in which two alike excursions fall differ by at most this factor
constexpr double slight = 0.2;     // an excursion with less than this fraction of the next one's reach is a pre-load
// A record ends at rest if its last sample is off the centre by at most this many times its last step.
constexpr double closed_by = 1.5;
constexpr double high = 0.9, low = 0.1;  // fractions of the reach between which the fall of an excursion is timed

class Finder {
 public:
  Finder(std::span<double const> x, std::span<double const> time, Reversals const& motion, double centre)
      : x_(x), time_(time), at_(motion.at), band_(motion.band_mm), centre_(centre) {}

  std::vector<Excursion> find() {
    find_tips();
    if (excursions_.empty()) return {};
    for (std::size_t j = 0; j + 1 < excursions_.size(); ++j) {
      excursions_[j].last =
          boundary(excursions_[j], excursions_[j + 1].tip, excursions_[j + 1].positive != excursions_[j].positive);
      excursions_[j + 1].first = excursions_[j].last;
    }
    finish(excursions_.back());
    for (std::size_t j = 0; j < excursions_.size(); ++j) {
      if (!excursions_[j].ends_open) excursions_[j].fall = fall(excursions_[j]);
      if (j == 0) continue;
      excursions_[j].rest = rest_between(excursions_[j - 1], excursions_[j]);
      excursions_[j].rests = excursions_[j].rest > excursions_[j - 1].fall;
    }
    return std::move(excursions_);
  }

 private:
  double y(std::size_t i) const { return x_[i] - centre_; }
  double out(Excursion const& excursion, std::size_t i) const { return excursion.positive ? y(i) : -y(i); }
  double reach(std::size_t k) const { return std::abs(y(at_[k])); }
  double time(double index) const { return time_.empty() ? index : value_at(time_, index); }
  double level(double smaller) const { return std::max(std::min(band_, smaller / 2.0), at_rest * smaller); }

  void find_tips() {
    auto const last = at_.size() - 1;
    double const first_swing = std::abs(x_[at_[1]] - x_[at_[0]]) / 2.0;
    double const next_swing = last >= 2 ? std::abs(x_[at_[2]] - x_[at_[1]]) / 2.0 : first_swing;
    bool const from_rest = reach(0) <= std::max(band_, at_rest * std::max(first_swing, next_swing));
    bool turned = from_rest;
    if (!from_rest) add(0, false).starts_open = true;
    for (std::size_t k = 1; k <= last; ++k) {
      bool const is_high = x_[at_[k]] > x_[at_[k - 1]];
      double const out = is_high ? y(at_[k]) : -y(at_[k]);
      double const near = level(k == last ? reach(k - 1) : std::min(reach(k - 1), reach(k + 1)));
      if (std::abs(out) <= near)
        turned = true;
      else if (out > 0.0) {
        if (!excursions_.empty() && excursions_.back().positive == is_high && !turned)
          grow(excursions_.back(), k);
        else
          add(k, turned);
        turned = false;
      }
    }
  }

  Excursion& add(std::size_t k, bool turned) {
    auto const tip = at_[k];
    excursions_.push_back({.tip = tip, .positive = y(tip) > 0.0, .reach_mm = reach(k), .turns = turned});
    return excursions_.back();
  }

  void grow(Excursion& excursion, std::size_t k) const {
    if (reach(k) <= excursion.reach_mm) return;
    excursion.tip = at_[k];
    excursion.reach_mm = reach(k);
  }

  // An excursion ends where the motion crosses the centre or, if the motion only comes back to the centre, at the
  // sample nearest to it.
  double boundary(Excursion const& excursion, std::size_t to, bool crosses) const {
    std::size_t nearest = excursion.tip;
    for (auto i = excursion.tip + 1; i <= to; ++i) {
      double const before = out(excursion, i - 1);
      double const after = out(excursion, i);
      if (before > 0.0 && after <= 0.0) {
        double const part = before / (before - after);  // not finite for damaged data
        return static_cast<double>(i - 1) + (std::isfinite(part) ? part : 0.0);
      }
      if (!crosses && std::abs(after) < std::abs(y(nearest))) nearest = i;
    }
    return static_cast<double>(crosses ? to : nearest);
  }

  void finish(Excursion& excursion) const {
    auto const end = x_.size() - 1;
    bool crossed = false;
    for (auto i = excursion.tip + 1; i <= end && !crossed; ++i) crossed = out(excursion, i) <= 0.0;
    double const step = std::abs(x_[end] - x_[end - 1]);
    bool const comes_to_rest =
        std::abs(y(end)) <= std::max(level(excursion.reach_mm), std::min(closed_by * step, excursion.reach_mm / 4.0));
    excursion.ends_open = !crossed && !comes_to_rest;
    excursion.last = excursion.ends_open ? static_cast<double>(end) : boundary(excursion, end, false);
  }

  std::size_t first_beyond(Excursion const& excursion, double part) const {
    auto i = static_cast<std::size_t>(std::ceil(excursion.first));
    while (i < excursion.tip && out(excursion, i) < part * excursion.reach_mm) ++i;
    return i;
  }
  std::size_t last_beyond(Excursion const& excursion, double part) const {
    auto i = static_cast<std::size_t>(std::floor(excursion.last));
    while (i > excursion.tip && out(excursion, i) < part * excursion.reach_mm) --i;
    return i;
  }

  double duration(std::size_t from, std::size_t to) const {
    return time(static_cast<double>(to)) - time(static_cast<double>(from));
  }
  std::size_t first_below(Excursion const& excursion, std::size_t from, std::size_t end) const {
    while (from < end && out(excursion, from) > low * excursion.reach_mm) ++from;
    return from;
  }

  // The time in which displacement falls from 90 to 10 % of the excursion's reach. A rest that follows does not count.
  double fall(Excursion const& excursion) const {
    auto const from = last_beyond(excursion, high);
    return duration(from, first_below(excursion, from, static_cast<std::size_t>(std::floor(excursion.last))));
  }

  // The time between two excursions in which the device is near the centre. The caller takes it as a rest if it is
  // longer than the first excursion takes to fall.
  double rest_between(Excursion const& before, Excursion const& after) const {
    auto const to = first_beyond(after, low);
    return duration(first_below(before, last_beyond(before, high), to), to);
  }

  std::span<double const> x_, time_;
  std::vector<std::size_t> const& at_;
  double band_ = 0.0;
  double centre_ = 0.0;
  std::vector<Excursion> excursions_;
};

bool like(Excursion const& a, Excursion const& b) {
  bool const same_reach = std::abs(a.reach_mm - b.reach_mm) <= alike * std::max(a.reach_mm, b.reach_mm);
  return same_reach && (b.ends_open || (a.fall <= same_fall * b.fall && b.fall <= same_fall * a.fall));
}

bool starts(std::vector<Excursion> const& excursions, std::size_t i) {
  return i == 0 || excursions[i].turns || excursions[i].rests;
}
bool stands_apart(std::vector<Excursion> const& excursions, std::size_t i) {
  auto const& excursion = excursions[i];
  auto const& next = excursions[i + 1];
  bool const ends_a_stage = i > 0 && like(excursions[i - 1], excursion);
  if (!starts(excursions, i) && !ends_a_stage) return false;
  if (starts(excursions, i) && excursion.reach_mm < slight * next.reach_mm) return true;
  if (excursion.has_gap || next.has_gap) return false;
  if (i + 2 >= excursions.size() || like(excursion, next)) return false;
  auto const& after = excursions[i + 2];
  return after.positive == excursion.positive && like(next, after) && !like(excursion, after);
}

}  // namespace

std::vector<Excursion> excursions(std::span<double const> disp_mm, std::span<double const> time_s,
                                  Reversals const& motion, double centre_mm) {
  return motion.at.size() < 2 ? std::vector<Excursion>() : Finder(disp_mm, time_s, motion, centre_mm).find();
}

std::vector<Group> group_excursions(std::vector<Excursion> const& excursions) {
  std::vector<Group> groups;
  auto const add = [&](Part part, std::size_t begin, std::size_t end) {
    groups.push_back({.part = part, .begin = begin, .end = end});
    return end;
  };
  for (std::size_t i = 0; i < excursions.size();) {
    auto const& excursion = excursions[i];
    bool const opposite = i + 1 < excursions.size() && excursions[i + 1].positive != excursion.positive;
    if (excursion.ends_open || i + 1 == excursions.size()) {
      i = add(excursion.starts_open ? Part::open_start : Part::open_end, i, i + 1);
    } else if (excursion.starts_open) {
      // If the record starts while the motion goes outwards, each cycle begins with an excursion to that side. The next
      // excursion is then the second half of the cycle whose beginning is missing, so it is left out as well.
      bool const outwards = excursion.tip > 0 && opposite && !excursions[i + 1].ends_open && i + 2 < excursions.size();
      i = add(Part::open_start, i, outwards ? i + 2 : i + 1);
    } else if (!opposite) {
      i = add(starts(excursions, i) ? Part::pre_load : Part::half, i, i + 1);
    } else if (excursions[i + 1].ends_open) {
      i = add(Part::open_end, i, i + 2);
    } else if (stands_apart(excursions, i)) {
      i = add(starts(excursions, i) ? Part::pre_load : Part::half, i, i + 1);
    } else {
      i = add(Part::cycle, i, i + 2);
    }
  }
  return groups;
}

}  // namespace isolaw::data
