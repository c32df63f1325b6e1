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

namespace validation_tests {

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

struct Collapse {
  int across;                      ///< particles across the column
  float mean_compression = 1e-4f;  ///< allowed
  bool gate = false;               ///< it is let go by a gate that is pulled up, not at once
};

/// A column `across` particles wide, twice as high, and four thick, in a long tank; L = 1 m. The
/// gate takes T = 0.58 to rise above the column, steadily: 0.05 s at the experiment's L = 0.146 m.
Settings column_collapse(const Collapse& collapse) {
  Settings s;
  s.fluid.spacing = 1.f / static_cast<float>(collapse.across);
  s.fluid.viscosity = 0.001f;
  s.solver.mean_compression = collapse.mean_compression;
  const float spacing = s.fluid.spacing, thick = 4 * spacing;
  s.domain = {{0, 0, 0}, {15, 2.5f, thick}};
  s.fluid.volumes = {{Box{{0, 0, 0}, {1, 2, thick}}}};
  s.solver.max_time_step = 0.1f * spacing;  // the default at 20 particles across
  if (collapse.gate) {
    Motion lift;
    lift.keyframes = {{.time = 0}, {.time = 0.58f / 4.43f, .translate = {0, 2, 0}}};
    lift.interpolation = Interpolation::linear;
    s.obstacles = {
        {.shape = Box{{1, 0, -2 * spacing}, {1.1f, 2.5f, thick + 2 * spacing}}, .motion = lift}};
  }
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

constexpr double last_time = 4;  // T; later the water is a film thinner than a few particles

std::vector<FrontPoint> simulated_front(const Collapse& collapse) {
  const Settings s = column_collapse(collapse);
  const double per_second = std::sqrt(2 * gravity);
  Simulation simulation(s);
  std::vector<FrontPoint> curve;
  for (double t = 0; t < last_time + 0.6; t += 0.05) {
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

using FrontErrorsByName = std::map<std::string, FrontErrors>;

/// Errors of a front against every experiment, or, with a gate, against the one that has a gate.
/// The experiments' origin of time is not that of the motion. Koshizuka and Oka's points are T =
/// 0.386 apart, 1/30 s at L = 0.146 m: the frames of a film, the first of which is the last one
/// with water at rest. Martin and Moyce's water comes as far until T = 0.4 as in as much time after
/// that, as no water does that falls freely: a film of waxed paper held it back.
FrontErrorsByName front_errors(const Collapse& collapse, const std::vector<FrontPoint>& curve) {
  FrontErrorsByName errors;
  for (const char* file : {"martin_moyce_1952", "koshizuka_oka_1996"})
    for (const auto& [name, measured] : read_fronts(file)) {
      if (collapse.gate && !name.starts_with("koshizuka"))
        continue;
      const BestShift best = best_shift(curve, measured, last_time);
      const FrontErrors e{front_error(curve, measured, last_time, 0), best.error, best.shift};
      record(fmt::format("front | {} | {} | {:g} | {} | {:.1f} | {:.1f} | {:+.2f}", name,
                         collapse.across, 100 * double{collapse.mean_compression},
                         collapse.gate ? "a gate" : "at once", 100 * e.released, 100 * e.aligned,
                         e.shift));
      errors[name] = e;
    }
  return errors;
}

FrontErrorsByName front_errors(const Collapse& collapse) {
  return front_errors(collapse, simulated_front(collapse));
}

void check_aligned(const FrontErrorsByName& errors) {
  for (const auto& [name, error] : errors) {
    CAPTURE(name);
    CHECK(error.aligned < (name.starts_with("martin") ? 0.03 : 0.055));
    CHECK(std::abs(error.shift) < 0.386);
  }
}

/// Root mean square of the difference of two fronts, of L.
double difference(const std::vector<FrontPoint>& a, const std::vector<FrontPoint>& b) {
  double sum = 0;
  for (std::size_t k = 0; k < a.size(); ++k)
    sum += std::pow(a[k].z - b[k].z, 2);
  return std::sqrt(sum / static_cast<double>(a.size()));
}

}  // namespace

TEST_CASE("validation: a column's front runs as measured", "[validation][slow]") {
  check_aligned(front_errors({20, 1e-3f}));
}

TEST_CASE("validation: a gate that is pulled up does not hold a column's front back",
          "[validation][slow]") {
  const Collapse at_once{20}, gate{20, 1e-4f, true};
  const std::vector<FrontPoint> front = simulated_front(at_once), behind = simulated_front(gate);
  check_aligned(front_errors(at_once, front));
  check_aligned(front_errors(gate, behind));
  CHECK(difference(behind, front) < 0.1);
}

// From release the errors grow with resolution towards those of the limit: at once and without
// friction the water leads the experiments. By how much, and how much more with the default
// tolerance, is in docs/results.md.
TEST_CASE("validation: finer columns' fronts converge, and run as measured", "[validation][long]") {
  const auto coarse = simulated_front({10}), medium = simulated_front({20}),
             fine = simulated_front({40});
  const double first = difference(coarse, medium), second = difference(medium, fine);
  CAPTURE(first, second);
  CHECK(second < 0.9 * first);
  check_aligned(front_errors({40}, fine));
  check_aligned(front_errors({40, 1e-3f}));
  check_aligned(front_errors({40, 1e-4f, true}));
}

}  // namespace validation_tests
