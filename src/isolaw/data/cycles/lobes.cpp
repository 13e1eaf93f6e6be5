#include "isolaw/data/cycles/lobes.hpp"

#include <algorithm>
#include <cmath>

namespace isolaw::data {
namespace {

constexpr double at_rest = 0.05;         // fraction of a lobe's reach; closer to the centre counts as at the centre
constexpr double alike = 0.15;           // difference of two reaches over the larger one; alike lobes differ by less
constexpr double same_fall = 1.5;        // ratio of the times in which two lobes fall; alike lobes have a smaller one
constexpr double slight = 0.2;           // fraction of the next lobe's reach; a lobe that is smaller is a pre-load
constexpr double high = 0.9, low = 0.1;  // fractions of the reach between which the fall of a lobe is timed

class Finder {
 public:
  Finder(std::span<double const> x, std::span<double const> time, Reversals const& motion, double centre)
      : x_(x), time_(time), at_(motion.at), band_(motion.band_mm), centre_(centre) {}

  std::vector<Lobe> find() {
    find_tips();
    if (lobes_.empty()) return {};
    for (std::size_t j = 0; j + 1 < lobes_.size(); ++j) {
      lobes_[j].last = boundary(lobes_[j], lobes_[j + 1].tip, lobes_[j + 1].positive != lobes_[j].positive);
      lobes_[j + 1].first = lobes_[j].last;
    }
    finish(lobes_.back());
    for (std::size_t j = 0; j < lobes_.size(); ++j) {
      if (!lobes_[j].ends_open) lobes_[j].fall = fall(lobes_[j]);
      if (j > 0) lobes_[j].rests = rests_between(lobes_[j - 1], lobes_[j]);
    }
    return std::move(lobes_);
  }

 private:
  double y(std::size_t i) const { return x_[i] - centre_; }
  double out(Lobe const& lobe, std::size_t i) const { return lobe.positive ? y(i) : -y(i); }
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
        if (!lobes_.empty() && lobes_.back().positive == is_high && !turned)
          grow(lobes_.back(), k);
        else
          add(k, turned);
        turned = false;
      }
    }
  }

  Lobe& add(std::size_t k, bool turned) {
    auto const tip = at_[k];
    lobes_.push_back({.tip = tip, .positive = y(tip) > 0.0, .reach_mm = reach(k), .turns = turned});
    return lobes_.back();
  }

  void grow(Lobe& lobe, std::size_t k) const {
    if (reach(k) <= lobe.reach_mm) return;
    lobe.tip = at_[k];
    lobe.reach_mm = reach(k);
  }

  // A lobe ends where the motion crosses the centre, or nearest to the centre if the motion only comes back to it.
  double boundary(Lobe const& lobe, std::size_t to, bool crosses) const {
    std::size_t nearest = lobe.tip;
    for (auto i = lobe.tip + 1; i <= to; ++i) {
      double const before = out(lobe, i - 1);
      double const after = out(lobe, i);
      if (before > 0.0 && after <= 0.0) {
        double const part = before / (before - after);  // not finite for damaged data
        return static_cast<double>(i - 1) + (std::isfinite(part) ? part : 0.0);
      }
      if (!crosses && std::abs(after) < std::abs(y(nearest))) nearest = i;
    }
    return static_cast<double>(crosses ? to : nearest);
  }

  void finish(Lobe& lobe) const {
    auto const end = x_.size() - 1;
    bool crossed = false;
    for (auto i = lobe.tip + 1; i <= end && !crossed; ++i) crossed = out(lobe, i) <= 0.0;
    bool const comes_to_rest = std::abs(y(end)) <= level(lobe.reach_mm);
    lobe.ends_open = !crossed && !comes_to_rest;
    lobe.last = lobe.ends_open ? static_cast<double>(end) : boundary(lobe, end, false);
  }

  std::size_t first_beyond(Lobe const& lobe, double part) const {
    auto i = static_cast<std::size_t>(std::ceil(lobe.first));
    while (i < lobe.tip && out(lobe, i) < part * lobe.reach_mm) ++i;
    return i;
  }
  std::size_t last_beyond(Lobe const& lobe, double part) const {
    auto i = static_cast<std::size_t>(std::floor(lobe.last));
    while (i > lobe.tip && out(lobe, i) < part * lobe.reach_mm) --i;
    return i;
  }

  double duration(std::size_t from, std::size_t to) const {
    return time(static_cast<double>(to)) - time(static_cast<double>(from));
  }
  std::size_t first_below(Lobe const& lobe, std::size_t from, std::size_t end) const {
    while (from < end && out(lobe, from) > low * lobe.reach_mm) ++from;
    return from;
  }

  // The time in which displacement falls from 90 to 10 % of the lobe's reach. A rest that follows does not count.
  double fall(Lobe const& lobe) const {
    auto const from = last_beyond(lobe, high);
    return duration(from, first_below(lobe, from, static_cast<std::size_t>(std::floor(lobe.last))));
  }

  // Whether the device rests between two lobes for longer than the first lobe takes to fall.
  bool rests_between(Lobe const& before, Lobe const& after) const {
    auto const to = first_beyond(after, low);
    return duration(first_below(before, last_beyond(before, high), to), to) > before.fall;
  }

  std::span<double const> x_, time_;
  std::vector<std::size_t> const& at_;
  double band_ = 0.0;
  double centre_ = 0.0;
  std::vector<Lobe> lobes_;
};

bool like(Lobe const& a, Lobe const& b) {
  bool const same_reach = std::abs(a.reach_mm - b.reach_mm) <= alike * std::max(a.reach_mm, b.reach_mm);
  return same_reach && (b.ends_open || (a.fall <= same_fall * b.fall && b.fall <= same_fall * a.fall));
}

bool starts(std::vector<Lobe> const& lobes, std::size_t i) {
  return i == 0 || lobes[i].turns || lobes[i].rests;
}
bool stands_apart(std::vector<Lobe> const& lobes, std::size_t i) {
  auto const& lobe = lobes[i];
  auto const& next = lobes[i + 1];
  bool const ends_a_stage = i > 0 && like(lobes[i - 1], lobe);
  if (!starts(lobes, i) && !ends_a_stage) return false;
  if (starts(lobes, i) && lobe.reach_mm < slight * next.reach_mm) return true;
  if (lobe.has_gap || next.has_gap) return false;
  if (i + 2 >= lobes.size() || like(lobe, next)) return false;
  auto const& after = lobes[i + 2];
  return after.positive == lobe.positive && like(next, after) && !like(lobe, after);
}

}  // namespace

std::vector<Lobe> lobes(std::span<double const> disp_mm, std::span<double const> time_s, Reversals const& motion,
                        double centre_mm) {
  return motion.at.size() < 2 ? std::vector<Lobe>() : Finder(disp_mm, time_s, motion, centre_mm).find();
}

std::vector<Group> group_lobes(std::vector<Lobe> const& lobes) {
  std::vector<Group> groups;
  auto const add = [&](Part part, std::size_t begin, std::size_t end) {
    groups.push_back({.part = part, .begin = begin, .end = end});
    return end;
  };
  for (std::size_t i = 0; i < lobes.size();) {
    auto const& lobe = lobes[i];
    bool const opposite = i + 1 < lobes.size() && lobes[i + 1].positive != lobe.positive;
    if (lobe.ends_open || i + 1 == lobes.size()) {
      i = add(lobe.starts_open ? Part::open_start : Part::open_end, i, i + 1);
    } else if (lobe.starts_open) {
      // If the record starts within a lobe on its way out, the next lobe is left out too, and cycles start outwards.
      bool const outwards = lobe.tip > 0 && opposite && !lobes[i + 1].ends_open && i + 2 < lobes.size();
      i = add(Part::open_start, i, outwards ? i + 2 : i + 1);
    } else if (!opposite) {
      i = add(starts(lobes, i) ? Part::pre_load : Part::half, i, i + 1);
    } else if (lobes[i + 1].ends_open) {
      i = add(Part::open_end, i, i + 2);
    } else if (stands_apart(lobes, i)) {
      i = add(starts(lobes, i) ? Part::pre_load : Part::half, i, i + 1);
    } else {
      i = add(Part::cycle, i, i + 2);
    }
  }
  return groups;
}

}  // namespace isolaw::data
