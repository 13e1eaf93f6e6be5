#include "peers.hpp"

#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cstdio>
#include <sstream>
#include <stdexcept>

namespace isolaw::bench {
namespace {

// Runs a Python program and talks to it over a socket. The Python program first sends the names of its searches. For
// each search this class sends one line with the task. The Python program then asks for values or residuals at points
// in the unit box until it says that the search is done.
class PythonPeer {
 public:
  explicit PythonPeer(std::string const& script) {
    std::array<int, 2> ends{};
    if (socketpair(AF_UNIX, SOCK_STREAM, 0, ends.data()) != 0) throw std::runtime_error("no socket");
    child_ = fork();
    if (child_ == 0) {
      dup2(ends[1], STDIN_FILENO);
      dup2(ends[1], STDOUT_FILENO);
      close(ends[0]);
      close(ends[1]);
      // Runs Debian's interpreter if there is one, because only that interpreter finds Debian's Python libraries.
      execl("/usr/bin/python3", "python3", script.c_str(), static_cast<char*>(nullptr));
      execlp("python3", "python3", script.c_str(), static_cast<char*>(nullptr));
      _exit(127);
    }
    close(ends[1]);
    socket_ = ends[0];
  }
  PythonPeer(PythonPeer const&) = delete;
  PythonPeer& operator=(PythonPeer const&) = delete;
  ~PythonPeer() {
    close(socket_);
    if (child_ > 0) waitpid(child_, nullptr, 0);
  }

  // Returns the names of the searches. There are none if Python or its libraries are missing.
  std::vector<std::string> methods() {
    std::string line;
    for (char c = 0; receive(&c, 1) && c != '\n';) line += c;
    std::vector<std::string> names;
    std::istringstream list(line);
    for (std::string name; std::getline(list, name, ';');) names.push_back(name);
    return names;
  }

  void search(std::string const& method, Watched const& problem, std::uint64_t seed, int budget) {
    std::ostringstream task;
    task << method << ';' << problem.dimension() << ';' << problem.weights().size() << ';' << seed << ';' << budget
         << '\n';
    send(task.str().data(), task.str().size());
    for (;;) {
      std::array<std::int32_t, 2> request{};
      if (!receive(request.data(), sizeof request)) throw std::runtime_error(method + " ended early");
      if (request[0] == done) return;
      opt::Points points(problem.dimension(), static_cast<std::size_t>(request[1]));
      if (!receive(points.values.data(), points.values.size() * sizeof(double)))
        throw std::runtime_error(method + " ended early");
      answer(problem, points, request[0] == residuals);
    }
  }

 private:
  static constexpr std::int32_t done = 0, residuals = 2;

  void answer(Watched const& problem, opt::Points const& points, bool wants_residuals) {
    std::vector<double> values(points.size() * (wants_residuals ? problem.weights().size() : 1));
    if (wants_residuals) {
      problem.residuals(points, values);
      // Multiplies each residual by its weight and by the number of residuals. The objective is then the mean of the
      // absolute values of these products.
      auto const weights = problem.weights();
      for (std::size_t i = 0; i < values.size(); ++i)
        values[i] *= weights[i % weights.size()] * static_cast<double>(weights.size());
    } else {
      problem.evaluate(points, values);
    }
    send(values.data(), values.size() * sizeof(double));
  }

  void send(void const* data, std::size_t bytes) const {
    for (auto const* at = static_cast<char const*>(data); bytes > 0;) {
      auto const sent = ::send(socket_, at, bytes, MSG_NOSIGNAL);
      if (sent <= 0) throw std::runtime_error("the peer in Python has ended");
      at += sent;
      bytes -= static_cast<std::size_t>(sent);
    }
  }
  bool receive(void* data, std::size_t bytes) const {
    for (auto* at = static_cast<char*>(data); bytes > 0;) {
      auto const got = ::recv(socket_, at, bytes, 0);
      if (got <= 0) return false;
      at += got;
      bytes -= static_cast<std::size_t>(got);
    }
    return true;
  }

  int socket_ = -1;
  pid_t child_ = -1;
};

}  // namespace

void Watched::see(std::span<double const> point, double value) const {
  ++evaluations_;
  if (!(value < best_value_)) return;
  best_value_ = value;
  best_.assign(point.begin(), point.end());
}

void Watched::evaluate(opt::Points const& points, std::span<double> values) const {
  problem_.evaluate(points, values);
  for (std::size_t i = 0; i < points.size(); ++i) see(points[i], values[i]);
}

void Watched::residuals(opt::Points const& points, std::span<double> values) const {
  problem_.residuals(points, values);
  auto const w = weights();
  for (std::size_t i = 0; i < points.size(); ++i) {
    double sum = 0.0;
    for (std::size_t j = 0; j < w.size(); ++j) sum += w[j] * std::abs(values[i * w.size() + j]);
    see(points[i], sum);
  }
}

std::vector<Peer> peers(std::string const& script) {
  std::vector<Peer> all;
  auto const python = std::make_shared<PythonPeer>(script);
  for (auto const& method : python->methods())
    all.push_back({method, [python, method](Watched const& problem, std::uint64_t seed, int budget) {
                     python->search(method, problem, seed, budget);
                   }});
  if (all.empty()) std::fputs("skipped: SciPy and CMA-ES; see above, or there is no python3\n", stderr);
#ifdef ISOLAW_CERES
  all.push_back({"Ceres", search_by_ceres});
#else
  std::fputs("skipped: Ceres; libceres-dev was not installed when this was built\n", stderr);
#endif
  return all;
}

}  // namespace isolaw::bench
