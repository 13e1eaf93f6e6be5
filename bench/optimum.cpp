// Measures how often, and at what cost, the search `best` finds the smallest objective. It repeats the search with
// other random numbers for every law and device of a lot. A run succeeds if its objective is within 0.1 % of the
// smallest one that any run found or that best_known.toml lists.
// Usage: optimum LOT.toml RUNS [LAW...] [--device NAME]... [--peers FACTOR] [--update FILE --name RECORD]
//   --peers    runs searches of other programs too; each run gets FACTOR times the evaluations that
//              `best` takes on average
//   --update   writes results that are new or smaller to FILE (for example bench/best_known.toml); the record of an
//              entry is called "RECORD, device"
// Prints the runs as CSV, then a table by law and method. The records may lie outside the lot file's folder.
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <map>
#include <string_view>
#include <utility>

#include "isolaw/opt/multistart.hpp"
#include "named_problems.hpp"
#include "peers.hpp"

using namespace isolaw;

namespace {

constexpr auto own_method = "isolaw best";

struct Arguments {
  std::string lot, update, name = "lot";
  int runs = 0;
  double peers = 0.0;
  bench::Choice choice;
};

constexpr auto usage =
    "optimum LOT.toml RUNS [LAW...] [--device NAME]... [--peers FACTOR] [--update FILE --name RECORD]";

template <class Number>
bool parse_number(std::string const& text, Number& number) {
  auto const end = text.data() + text.size();
  return std::from_chars(text.data(), end, number).ptr == end;
}

Arguments parse(int argc, char** argv) {
  Arguments arguments;
  std::vector<std::string> positional;
  bool names_entries = false;
  for (int i = 1; i < argc; ++i) {
    std::string const word = argv[i];
    if (!word.starts_with("--") || i + 1 == argc) {
      positional.push_back(word);
      continue;
    }
    std::string const value = argv[++i];
    if (word == "--update")
      arguments.update = value;
    else if (word == "--name")
      arguments.name = value, names_entries = true;
    else if (word == "--device")
      arguments.choice.devices.push_back(value);
    else if (word == "--peers" && parse_number(value, arguments.peers) && arguments.peers > 0.0)
      continue;
    else
      throw Error({.where = word, .found = "not an option, or not a value of it: " + value, .allowed = usage});
  }
  if (positional.size() > 1) {
    arguments.lot = positional[0];
    if (!parse_number(positional[1], arguments.runs)) arguments.runs = 0;
    arguments.choice.laws.assign(positional.begin() + 2, positional.end());
  }
  if (arguments.runs < 1 || (!arguments.update.empty() && !names_entries))
    throw Error({.where = "usage", .found = usage});
  return arguments;
}

struct Run {
  double objective = 0.0, seconds = 0.0;
  int evaluations = 0;
};
using Runs = std::vector<Run>;

double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

// Collects the runs of all methods on one problem, and the best point that each method found.
class Contest {
 public:
  explicit Contest(bench::NamedProblem const& named) : named_(named) {}

  void run_own(int runs, opt::MultistartOptions const& options) {
    for (int run = 1; run <= runs; ++run) {
      auto const start = std::chrono::steady_clock::now();
      auto const found = opt::minimise_multistart(named_.problem, stream(run), options);
      add(own_method, run, {found.best_value, seconds_since(start), found.evaluations}, found.best);
    }
  }
  void run_peer(bench::Peer const& peer, int runs, int budget) {
    for (int run = 1; run <= runs; ++run) {
      bench::Watched const watched(named_.problem);
      auto const start = std::chrono::steady_clock::now();
      peer.search(watched, stream(run).key(), budget);
      add(peer.name, run, {watched.best_value(), seconds_since(start), watched.evaluations()}, watched.best());
    }
  }

  double mean_evaluations() const {
    double sum = 0.0;
    for (auto const& run : runs_.front().second) sum += run.evaluations;
    return sum / static_cast<double>(runs_.front().second.size());
  }
  std::vector<std::pair<std::string, Runs>> const& runs() const { return runs_; }
  std::vector<bench::BestKnown> const& found() const { return found_; }

 private:
  num::Stream stream(int run) const { return named_.stream.split(static_cast<std::uint64_t>(run)); }

  void add(std::string const& method, int number, Run const& run, std::vector<double> const& best) {
    fmt::print("\"{}\",{},{},{},{:.8g},{},{:.4f}\n", method, named_.entry.law, named_.device, number, run.objective,
               run.evaluations, run.seconds);
    std::fflush(stdout);
    if (runs_.empty() || runs_.back().first != method) runs_.emplace_back(method, Runs());
    runs_.back().second.push_back(run);
    if (!best.empty()) found_.push_back(named_.found(best, method));
  }

  bench::NamedProblem const& named_;
  std::vector<std::pair<std::string, Runs>> runs_;
  std::vector<bench::BestKnown> found_;
};

struct Tally {
  int successes = 0;
  std::vector<double> evaluations, seconds;
};

double median(std::vector<double> values) {
  auto const middle = values.begin() + std::ssize(values) / 2;
  std::ranges::nth_element(values, middle);
  return *middle;
}

}  // namespace

int main(int argc, char** argv) try {
  auto const arguments = parse(argc, argv);
  bench::NamedProblems const problems(arguments.lot, arguments.name, arguments.choice);
  bench::BestFile file(arguments.update);
  auto const peers = arguments.peers > 0.0 ? bench::peers(ISOLAW_PEERS_SCRIPT) : std::vector<bench::Peer>();
  std::map<std::string, std::vector<std::pair<std::string, Tally>>> laws;
  std::map<std::string, int> changes;

  std::puts("method,law,device,run,objective,evaluations,seconds");
  for (auto const& named : problems.all) {
    Contest contest(*named);
    contest.run_own(arguments.runs, problems.contents.settings.multistart);
    auto const budget = static_cast<int>(arguments.peers * contest.mean_evaluations());
    for (auto const& peer : peers) contest.run_peer(peer, arguments.runs, budget);

    double best = file.objective(named->entry.key);
    int changed = 0;
    for (auto const& found : contest.found()) {
      best = std::min(best, found.objective);
      changed += file.lower(found) != bench::Change::none;
    }
    if (changed > 0) file.write();
    changes[named->entry.law] += changed > 0;

    auto& methods = laws[named->entry.law];
    methods.resize(contest.runs().size());
    for (std::size_t i = 0; i < methods.size(); ++i) {
      auto& [method, tally] = methods[i];
      method = contest.runs()[i].first;
      for (auto const& run : contest.runs()[i].second) {
        tally.successes += run.objective <= best * (1.0 + bench::success_tolerance);
        tally.evaluations.push_back(run.evaluations);
        tally.seconds.push_back(run.seconds);
      }
    }
  }

  std::puts("\nlaw,method,successes,runs,median evaluations,median seconds");
  for (auto const& law : problems.contents.settings.laws) {
    for (auto const& [method, tally] : laws[law])
      fmt::print("{},\"{}\",{},{},{:.0f},{:.3f}\n", law, method, tally.successes, tally.seconds.size(),
                 median(tally.evaluations), median(tally.seconds));
  }
  std::puts("");
  for (auto const& [law, count] : changes)
    if (count > 0) fmt::print("{}: {} best objectives that the file did not hold, or held higher\n", law, count);
  return 0;
} catch (std::exception const& error) {
  std::fprintf(stderr, "optimum: %s\n", error.what());
  return 2;
}
