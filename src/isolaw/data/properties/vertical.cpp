#include "isolaw/data/properties/vertical.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "isolaw/base/error.hpp"
#include "isolaw/base/hash.hpp"
#include "isolaw/base/number_text.hpp"
#include "isolaw/base/printable.hpp"
#include "isolaw/base/words.hpp"
#include "isolaw/data/cycles/cycles.hpp"
#include "isolaw/data/signals/vertical_signals.hpp"

namespace isolaw::data {
namespace {

constexpr double usual_low = 0.3;        // fraction of the largest load: lower end of the usual range
constexpr int usual_loading = 3;         // number of the loading that is used; the last if there are fewer
constexpr double same_peak = 0.9;        // fraction of the largest load; a loading with a lower peak is ignored
constexpr double reversal = 0.1;         // fraction of the load's range; a smaller reversal is noise or a hold
constexpr double reached = 0.998;        // a loading ends at this fraction of its peak, because the device creeps there
constexpr double near_range_end = 0.02;  // a loading may miss the ends of the range by this fraction of the upper load
struct Loading {
  std::size_t first = 0, last = 0;
};
// Displacement and load, with signs turned so that compression is positive.
struct Compression {
  std::vector<double> disp_mm, load_kN;
  std::vector<std::string> turned;
};

void turn(std::vector<double>& values) {
  for (double& value : values) value = -value;
}

Compression compression_of(VerticalTest const& test) {
  Compression compression{.disp_mm = test.disp_mm, .load_kN = test.load_kN, .turned = {}};
  auto const [least, largest] = std::ranges::minmax(compression.load_kN);
  if (-least > largest) {
    turn(compression.load_kN);
    compression.turned.emplace_back("vertical load is recorded negative in compression");
  }
  auto const mean = [](std::vector<double> const& values) {
    double sum = 0.0;
    for (double const value : values) sum += value;
    return sum / static_cast<double>(values.size());
  };
  double const mean_disp = mean(compression.disp_mm), mean_load = mean(compression.load_kN);
  double together = 0.0;
  for (std::size_t i = 0; i < compression.load_kN.size(); ++i)
    together += (compression.disp_mm[i] - mean_disp) * (compression.load_kN[i] - mean_load);
  if (together < 0.0) {
    turn(compression.disp_mm);
    compression.turned.emplace_back("vertical displacement is recorded negative in compression");
  }
  return compression;
}

constexpr double noise_left = 0.0005;         // fraction of the range; averaging reduces noise to this
constexpr std::size_t least_of_loading = 10;  // least number of averaging windows in a loading

std::vector<double> running_mean(std::vector<double> const& x, std::size_t half) {
  std::vector<double> sums(x.size() + 1, 0.0), averages(x.size());
  for (std::size_t i = 0; i < x.size(); ++i) sums[i + 1] = sums[i] + x[i];
  for (std::size_t i = 0; i < x.size(); ++i) {
    auto const reach = std::min({half, i, x.size() - 1 - i});
    averages[i] = (sums[i + reach + 1] - sums[i - reach]) / static_cast<double>(2 * reach + 1);
  }
  return averages;
}

// All loadings that nearly reach the largest load, also one that the record's end cuts off. Ignores small reversals.
std::vector<Loading> all_loadings(std::vector<double> const& load) {
  auto const [least, largest] = std::ranges::minmax(load);
  double const step = reversal * (largest - least);
  std::vector<Loading> found;
  std::size_t low = 0, high = 0;
  bool rising = false;
  for (std::size_t i = 0; i < load.size(); ++i) {
    if (!rising && load[i] < load[low]) low = i;
    if (!rising && load[i] - load[low] > step) rising = true, high = i;
    if (rising && load[i] > load[high]) high = i;
    if (rising && load[high] - load[i] > step) {
      found.push_back({low, high});
      rising = false;
      low = i;
    }
  }
  if (rising) found.push_back({low, high});
  double const counts_kN = same_peak * largest;
  std::erase_if(found, [&](Loading const& l) { return load[l.last] < counts_kN; });
  return found;
}

std::size_t counting_among(std::vector<Loading> const& loadings) {
  return std::min(static_cast<std::size_t>(usual_loading), loadings.size()) - 1;
}

// Reduces noise by averaging both channels alike, which keeps the slope. Noise of 1 % would make a device look 2 to 7 %
// stiffer, because the largest noisy load exceeds the true one and noisy samples cross a limit early.
Compression without_noise(Compression compression) {
  auto const loadings = all_loadings(compression.load_kN);
  if (loadings.empty()) return compression;
  auto const part = [](std::vector<double> const& x) {
    auto const [least, largest] = std::ranges::minmax(x);
    return largest > least ? noise_deviation(x) / (largest - least) : 0.0;
  };
  double const noise = std::max(part(compression.load_kN), part(compression.disp_mm));
  auto const& counting = loadings[counting_among(loadings)];
  double const longest = static_cast<double>((counting.last - counting.first) / least_of_loading);
  auto const half = static_cast<std::size_t>(std::min(longest, std::pow(noise / noise_left, 2.0)) / 2.0);
  if (half == 0) return compression;
  compression.load_kN = running_mean(compression.load_kN, half);
  compression.disp_mm = running_mean(compression.disp_mm, half);
  return compression;
}

struct Point {
  double load_kN = 0.0, disp_mm = 0.0;
};

Point between(Compression const& c, std::size_t i, double load_kN) {
  double const share = (load_kN - c.load_kN[i]) / (c.load_kN[i + 1] - c.load_kN[i]);
  return {load_kN, c.disp_mm[i] + share * (c.disp_mm[i + 1] - c.disp_mm[i])};
}

struct Secant {
  Point low, high;
  double K_v() const { return (high.load_kN - low.load_kN) / (high.disp_mm - low.disp_mm); }
};

// Returns the secant from the last instant at the lower load to the first instant at the upper load, so that creep
// while a load is held has no effect.
Secant secant_of(Compression const& c, Loading const& loading, LoadRange const& range) {
  auto const& load = c.load_kN;
  Secant secant;
  auto end = loading.first;
  if (range.high_kN >= reached * load[loading.last]) {
    while (load[end] < reached * load[loading.last]) ++end;
    secant.high = {load[end], c.disp_mm[end]};
  } else {
    while (load[end] < range.high_kN) ++end;
    secant.high = end > loading.first ? between(c, end - 1, range.high_kN) : Point{load[end], c.disp_mm[end]};
  }
  auto start = end;
  while (start > loading.first && load[start] > range.low_kN) --start;
  secant.low = load[start] <= range.low_kN && start < end ? between(c, start, range.low_kN)
                                                          : Point{load[start], c.disp_mm[start]};
  return secant;
}

LoadRange usual_loads(double largest_kN) {
  return {usual_low * largest_kN, largest_kN};
}

LoadRange held_range(VerticalTest const& test, Compression const& c, Loading const& loading) {
  double const least = c.load_kN[loading.first], largest = c.load_kN[loading.last];
  auto const asked = test.loads.value_or(usual_loads(largest));
  double const missed = near_range_end * asked.high_kN;
  if (least > asked.low_kN + missed || largest < asked.high_kN - missed)
    throw Error({.where = test.file,
                 .found = fmt::format("the loading goes from {} to {} kN, K_v is asked for between {} and {} kN",
                                      number_text(least), number_text(largest), number_text(asked.low_kN),
                                      number_text(asked.high_kN)),
                 .allowed = "a loading that holds both",
                 .advice = fmt::format("loads = \"{}:{}\" beside the file", number_text(least), number_text(largest))});
  return {std::max(asked.low_kN, least), std::min(asked.high_kN, largest)};
}

void refuse_faults(VerticalTest const& test, Compression const& compression) {
  std::vector<Complaint> complaints;
  for (auto const& fault : vertical_faults(compression.disp_mm, compression.load_kN)) {
    auto const unit = fault.finding.word("unit");
    auto const level = fmt::format("level_{}", unit);
    auto const kept =
        fault.finding.has_number(level) ? fmt::format(" {:.5g} {}, from", fault.finding.number(level), unit) : "";
    complaints.push_back(
        {.where = test.file,
         .found =
             fmt::format("{} is {} at{} {}", fault.channel, said_of(fault.kind), kept, sample_text(fault.samples, {})),
         .advice = "another test, the part of the file that was not disturbed (rows), or K_v as stated"});
  }
  if (!complaints.empty()) throw Error(std::move(complaints));
}

void warn_about_size(VerticalStiffness& stiffness) {
  constexpr double softest = 1.0, stiffest = 1e5;
  if (stiffness.K_v_kN_per_mm >= softest && stiffness.K_v_kN_per_mm <= stiffest) return;
  stiffness.warnings.push_back({.kind = FindingKind::vertical_stiffness_implausible,
                                .numbers = {{"K_v_kN_per_mm", stiffness.K_v_kN_per_mm}},
                                .words = {{"than_any", stiffness.K_v_kN_per_mm > stiffest ? "stiffer" : "softer"}}});
}

std::string_view ordinal_end(int number) {
  if (number % 100 >= 11 && number % 100 <= 13) return "th";
  return number % 10 == 1 ? "st" : number % 10 == 2 ? "nd" : number % 10 == 3 ? "rd" : "th";
}

}  // namespace

LoadRange parse_loads(std::string_view text) {
  auto const colon = text.find(':');
  auto const low = number_in<double>(trimmed(text.substr(0, colon)));
  auto const high = colon == std::string_view::npos ? std::nullopt : number_in<double>(trimmed(text.substr(colon + 1)));
  if (low && high && std::isfinite(*high) && *low >= 0.0 && *high > *low) return {*low, *high};
  throw Error({.found = in_quotes(text),
               .allowed = "LOW:HIGH, two vertical loads in kN of which the first is smaller",
               .advice = "loads = \"300:1000\""});
}

std::string loads_text(LoadRange const& range) {
  return fmt::format("{}:{}", range.low_kN, range.high_kN);
}

std::string curve_hash(VerticalTest const& test) {
  std::string hashes;
  for (auto const* values : {&test.disp_mm, &test.load_kN})
    hashes +=
        sha256({static_cast<char const*>(static_cast<void const*>(values->data())), values->size() * sizeof(double)});
  return sha256(hashes);
}

VerticalStiffness vertical_stiffness(VerticalTest const& test) {
  VerticalStiffness stiffness;
  if (test.stated_kN_per_mm) {
    stiffness.K_v_kN_per_mm = *test.stated_kN_per_mm;
    stiffness.description = "as the laboratory states it";
    warn_about_size(stiffness);
    return stiffness;
  }
  if (test.load_kN.empty() || test.load_kN.size() != test.disp_mm.size())
    throw Error({.where = test.file, .found = "no samples of a vertical test"});
  auto const recorded = compression_of(test);
  refuse_faults(test, recorded);
  auto const compression = without_noise(recorded);
  auto const loadings = all_loadings(compression.load_kN);
  if (loadings.empty())
    throw Error({.where = test.file,
                 .found = "the vertical load does not rise",
                 .allowed = "one loading or more, from a small load to the largest"});
  auto const count = static_cast<int>(loadings.size());
  auto const place = counting_among(loadings);
  auto const number = static_cast<int>(place) + 1;
  auto const& counting = loadings[place];
  auto const range = held_range(test, compression, counting);
  auto const secant = secant_of(compression, counting, range);
  stiffness.K_v_kN_per_mm = secant.K_v();
  if (!std::isfinite(stiffness.K_v_kN_per_mm) || stiffness.K_v_kN_per_mm <= 0.0)
    throw Error(
        {.where = test.file,
         .found = fmt::format(
             "vertical displacement goes from {:.4g} to {:.4g} mm while the load rises from {:.4g} to {:.4g} kN",
             secant.low.disp_mm, secant.high.disp_mm, secant.low.load_kN, secant.high.load_kN),
         .allowed = "a displacement that grows with the load",
         .advice = "naming the two columns"});
  stiffness.loads = LoadRange{secant.low.load_kN, secant.high.load_kN};
  stiffness.disp_low_mm = secant.low.disp_mm;
  stiffness.disp_high_mm = secant.high.disp_mm;
  stiffness.loading = number;
  for (auto const& each : loadings)
    stiffness.loadings_kN_per_mm.push_back(compression.load_kN[each.first] <= range.high_kN
                                               ? secant_of(compression, each, range).K_v()
                                               : stiffness.K_v_kN_per_mm);
  stiffness.reversed_signals = compression.turned;
  stiffness.description =
      fmt::format("dF_v/dd_v, {}{} loading of {}, from {} to {} kN", number, ordinal_end(number), count,
                  number_text(stiffness.loads->low_kN), number_text(stiffness.loads->high_kN));
  warn_about_size(stiffness);
  return stiffness;
}

}  // namespace isolaw::data
