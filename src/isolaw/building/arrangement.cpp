#include "isolaw/building/arrangement.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "isolaw/base/hash.hpp"
#include "isolaw/num/random.hpp"

namespace isolaw::building {
namespace {

// Sums over the devices that have a place: their stiffness, and their stiffness times x and y of the place, measured
// from the wanted centre.
struct Sums {
  double k = 0.0, x = 0.0, y = 0.0;
  Sums with(double stiffness, Point const& at) const {
    return {k + stiffness, x + stiffness * at.x_mm, y + stiffness * at.y_mm};
  }
  // The square of the distance between the centre of stiffness and the wanted centre [mm2].
  double square() const { return (x * x + y * y) / (k * k); }
};

class Search {
 public:
  Search(std::span<Point const> places, Point centre, std::span<double const> stiffness) : stiffness_(stiffness) {
    for (auto const& p : places) places_.push_back({p.x_mm - centre.x_mm, p.y_mm - centre.y_mm});
    best_.device.resize(stiffness.size());
    std::iota(best_.device.begin(), best_.device.end(), std::size_t{0});
    best_square_ = sums(best_.device).square();
    best_.in_order_mm = std::sqrt(best_square_);
  }

  Arrangement operator()() {
    double arrangements = 1.0;
    for (std::size_t i = 0; i < places_.size(); ++i) arrangements *= static_cast<double>(stiffness_.size() - i);
    auto const first = best_.device;
    if (arrangements <= most_tried) {
      auto devices = first;
      try_all(devices, 0, {});
    } else {
      constexpr std::uint64_t starts = 200;
      for (std::uint64_t start = 0; start < starts; ++start) exchange(shuffled(first, start));
    }
    best_.device.resize(places_.size());
    best_.eccentricity_mm = std::sqrt(best_square_);
    return best_;
  }

 private:
  Sums sums(std::vector<std::size_t> const& device) const {
    Sums sum;
    for (std::size_t i = 0; i < places_.size(); ++i) sum = sum.with(stiffness_[device[i]], places_[i]);
    return sum;
  }

  void take_if_better(std::vector<std::size_t> const& device, double square) {
    if (!(square < best_square_)) return;
    best_.device = device;
    best_square_ = square;
  }

  // Tries all arrangements of the remaining devices on the places from `place` on.
  void try_all(std::vector<std::size_t>& device, std::size_t place, Sums const& so_far) {
    if (place == places_.size()) return take_if_better(device, so_far.square());
    for (std::size_t i = place; i < device.size(); ++i) {
      std::swap(device[place], device[i]);
      try_all(device, place + 1, so_far.with(stiffness_[device[place]], places_[place]));
      std::swap(device[place], device[i]);
    }
  }

  static std::vector<std::size_t> shuffled(std::vector<std::size_t> device, std::uint64_t start) {
    if (start == 0) return device;
    num::Draws draws(num::Stream(stable_hash("arrangement")).split(start), 0, 0);
    for (std::size_t i = device.size() - 1; i > 0; --i) std::swap(device[i], device[draws.below(i + 1)]);
    return device;
  }

  void exchange(std::vector<std::size_t> device) {
    auto sum = sums(device);
    for (bool better = true; better;) {
      better = false;
      std::size_t best_i = 0, best_j = 0;
      auto best = sum;
      double least = sum.square();
      for (std::size_t i = 0; i < places_.size(); ++i)
        for (std::size_t j = i + 1; j < device.size(); ++j) {
          double const more = stiffness_[device[j]] - stiffness_[device[i]];
          auto now = sum.with(more, places_[i]);
          if (j < places_.size()) now = now.with(-more, places_[j]);
          if (double const square = now.square(); square < least * (1.0 - 1e-12))
            best = now, least = square, best_i = i, best_j = j, better = true;
        }
      if (better) std::swap(device[best_i], device[best_j]), sum = best;
    }
    take_if_better(device, sums(device).square());
  }

  std::vector<Point> places_;
  std::span<double const> stiffness_;
  Arrangement best_;
  double best_square_ = 0.0;  // Sums::square() of best_
};

}  // namespace

Arrangement arrange(std::span<Point const> places, Point centre, std::span<double const> stiffness) {
  return Search(places, centre, stiffness)();
}

}  // namespace isolaw::building
