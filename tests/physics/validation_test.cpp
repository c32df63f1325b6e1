// Against what is not ours: experiments, and solutions on paper.
#include <fmt/format.h>

#include <catch2/catch.hpp>
#include <cmath>
#include <fstream>
#include <map>
#include <numbers>
#include <sstream>
#include <string>
#include <vector>

#include "invariants.hpp"

using namespace spindrift::sim;
using namespace spindrift::test;

namespace {

constexpr double gravity = 9.81;

struct FrontPoint {
  double t;  ///< time · √(2g/L), L the column's width
  double z;  ///< front position / L
};

/// The experiments' fronts by name: the last two columns of a table of T and Z.
std::map<std::string, std::vector<FrontPoint>> read_fronts(const std::string& file) {
  std::ifstream in(std::string(SOURCE_DIR) + "/tests/physics/data/" + file + ".csv");
  REQUIRE(in);
  std::map<std::string, std::vector<FrontPoint>> fronts;
  for (std::string line; std::getline(in, line);) {
    if (line.empty() || line[0] == '#' || line.find("T,Z") != std::string::npos)
      continue;
    const std::size_t z = line.rfind(','), t = z == 0 ? 0 : line.rfind(',', z - 1);
    const bool named = t != std::string::npos;
    const std::size_t begin = named ? t + 1 : 0;
    const std::string name = named ? file + " " + line.substr(0, line.find(',')) : file;
    fronts[name].push_back(
        {std::stod(line.substr(begin, z - begin)), std::stod(line.substr(z + 1))});
  }
  return fronts;
}

/// A column `across` particles wide, twice as high, and four thick, in a long tank; L = 1 m.
Settings column_collapse(int across) {
  Settings s;
  s.fluid.spacing = 1.f / static_cast<float>(across);
  s.fluid.viscosity = 0.001f;
  const float thick = 4 * s.fluid.spacing;
  s.domain = {{0, 0, 0}, {15, 2.5f, thick}};
  s.fluid.volumes = {{Box{{0, 0, 0}, {1, 2, thick}}}};
  s.solver.max_time_step = 0.1f * s.fluid.spacing;  // the default at 20 particles across
  return s;
}

/// How far the liquid on the floor reaches without a gap, m: the farthest particle in the last of
/// the bins, a support radius (two spacings) long and high, that hold a quarter of what a full one
/// does, of 16 particles. Spray that flies ahead does not count.
double front_position(const Frame& frame, double spacing) {
  std::vector<int> count;
  std::vector<double> farthest;
  for (const glm::vec3 p : frame.positions) {
    if (p.y > 2 * spacing)
      continue;
    const auto bin = static_cast<std::size_t>(p.x / (2 * spacing));
    if (bin >= count.size()) {
      count.resize(bin + 1, 0);
      farthest.resize(bin + 1, 0.);
    }
    ++count[bin];
    farthest[bin] = std::max(farthest[bin], double{p.x});
  }
  double front = 0;
  for (std::size_t k = 0; k < count.size() && count[k] >= 4; ++k)
    front = farthest[k] + 0.5 * spacing;
  return front;
}

double interpolated(const std::vector<FrontPoint>& curve, double t) {
  if (t <= 0)
    return curve.front().z;
  std::size_t k = 1;
  while (k + 1 < curve.size() && curve[k].t < t)
    ++k;
  const FrontPoint a = curve[k - 1], b = curve[k];
  return a.z + (b.z - a.z) * (t - a.t) / (b.t - a.t);
}

/// Root mean square of the error of Z, relative to the root mean square of Z, over the measured
/// points up to `last` in T; `shift` is added to the experiment's times.
double front_error(const std::vector<FrontPoint>& curve, const std::vector<FrontPoint>& measured,
                   double last, double shift) {
  double error = 0, norm = 0;
  for (const FrontPoint m : measured) {
    if (m.t > last || m.t == 0)
      continue;
    error += std::pow(interpolated(curve, m.t + shift) - m.z, 2);
    norm += m.z * m.z;
  }
  return std::sqrt(error / norm);
}

struct BestShift {
  double shift = 0, error = 1;
};

BestShift best_shift(const std::vector<FrontPoint>& curve, const std::vector<FrontPoint>& measured,
                     double last) {
  BestShift best;
  for (double shift = -0.5; shift <= 0.5; shift += 0.01)
    if (const double e = front_error(curve, measured, last, shift); e < best.error)
      best = {shift, e};
  return best;
}

std::vector<FrontPoint> simulated_front(int across, double last) {
  const Settings s = column_collapse(across);
  const double per_second = std::sqrt(2 * gravity);
  Simulation simulation(s);
  std::vector<FrontPoint> curve;
  for (double t = 0; t < last + 0.6; t += 0.05) {
    simulation.advance_to(t / per_second);
    curve.push_back({t, front_position(simulation.frame(), s.fluid.spacing)});
  }
  return curve;
}

struct FrontErrors {
  double released = 0;  ///< time counted from the release, as it stands in the tables
  double aligned = 0;   ///< the experiment's times shifted for the best agreement
  double shift = 0;     ///< that shift, of T
};

/// Errors of the front against every experiment. The experiments' origin of time is uncertain:
/// their water is let go by a wall that is pulled up or a film that melts, which holds it back at
/// first.
std::map<std::string, FrontErrors> front_errors(int across) {
  constexpr double last = 4;  // T; later the water is a film thinner than a few particles
  const std::vector<FrontPoint> curve = simulated_front(across, last);
  std::map<std::string, FrontErrors> errors;
  for (const char* file : {"martin_moyce_1952", "koshizuka_oka_1996"})
    for (const auto& [name, measured] : read_fronts(file)) {
      const BestShift best = best_shift(curve, measured, last);
      const FrontErrors e{front_error(curve, measured, last, 0), best.error, best.shift};
      record(fmt::format("front | {} | {} | {:.1f} | {:.1f} | {:+.2f}", name, across,
                         100 * e.released, 100 * e.aligned, e.shift));
      errors[name] = e;
    }
  return errors;
}

/// Koshizuka and Oka's front is not Martin and Moyce's shifted in time: it is slower later on.
double aligned_bound(const std::string& name) {
  return name.starts_with("martin") ? 0.03 : 0.06;
}

}  // namespace

TEST_CASE("validation: a column's front runs as measured", "[validation][slow]") {
  for (const auto& [name, error] : front_errors(20)) {
    CAPTURE(name);
    CHECK(error.aligned < aligned_bound(name));
    CHECK(std::abs(error.shift) < 0.4);
  }
}

TEST_CASE("validation: a finer column's front runs as measured", "[validation][long]") {
  for (const auto& [name, error] : front_errors(40)) {
    CAPTURE(name);
    CHECK(error.aligned < aligned_bound(name));
    CHECK(std::abs(error.shift) < 0.4);
  }
}

// Measured: 11 to 16 % at 40 particles across, and no less than at 20. The front starts ahead of
// the experiments by 0.25 of T, then runs as they do.
TEST_CASE("validation: a column's front runs as measured from its release on",
          "[validation][long][!mayfail]") {
  const auto coarse = front_errors(20), fine = front_errors(40);
  for (const auto& [name, error] : fine) {
    CAPTURE(name);
    CHECK(error.released < 0.05);
    CHECK(error.released < coarse.at(name).released);
  }
}
