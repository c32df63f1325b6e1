// Changes planted in the scenes that ship: the golden test of each (scenes.json) must notice every
// one, and pass where nothing is changed but Mesa computes otherwise. Prints what was found as the
// rows of a table (docs/golden.md).
#include <fmt/format.h>

#include <catch2/catch.hpp>
#include <cstdlib>
#include <glm/gtc/matrix_transform.hpp>
#include <optional>

#include "app/compare/comparison.hpp"
#include "app/draw/scene_drawing.hpp"
#include "app/golden/golden_list.hpp"
#include "app/run/particle_source.hpp"
#include "render/output/output.hpp"

namespace fs = std::filesystem;
namespace planted_tests {

using namespace spindrift;

namespace {

// Parts of a limit: what is no change stays below the one, what is a change comes above the other.
constexpr double most_noise = 0.2, least_change = 1.3;

constexpr float viscous = 1.f;   // Pa·s: a fifth more or less of it can be seen...
constexpr double flowing = 0.1;  // ...where the liquid is faster than this, m/s

const fs::path list_file = fs::path(SOURCE_DIR) / "tests/golden/scenes.json";

app::CachedFrame simulated(const app::Scene& scene, int number) {
  app::RenderOptions options;
  options.cache = false;
  std::vector<app::ProbeReading> readings;
  app::ParticleSource source(scene, options, readings);
  for (int k = 0; k < number; ++k)
    source.next(k);
  return source.keep(number, source.next(number).value());
}

glm::vec3 turned(glm::vec3 direction, float degrees, glm::vec3 axis) {
  return glm::vec3(glm::rotate(glm::mat4(1), glm::radians(degrees), axis) *
                   glm::vec4(direction, 0));
}

/// How far a picture is from the reference.
struct Found {
  compare::Metrics metrics;
  double of_limit = 0;  ///< as a part of the limit that it comes nearest to
};

/// A golden test's frame, drawn again with changes and held against its reference.
class Planting {
 public:
  Planting(const app::GoldenList& list, const app::Golden& golden)
      : golden_(golden),
        threshold_(list.threshold),
        max_flip_(golden.max_flip.value_or(list.max_flip)),
        max_changed_(golden.max_changed.value_or(list.max_changed)),
        reference_(output::read_png(list_file.parent_path() / list.references / golden.name /
                                    fmt::format("{:04}.png", golden.frames.front()))),
        right_(simulated(golden.resolved, golden.frames.front())) {}

  /// Makes all changes that the scene can have, and prints a row of the table.
  void check() {
    fmt::print("| `{}` |", golden_.name);
    check_unchanged();
    check_light();
    end_of_kind();
    check_obstacles();
    end_of_kind();
    const bool is_viscous = golden_.resolved.simulation.fluid.viscosity >= viscous;
    if (is_viscous && right_.statistics.max_speed > flowing)
      check_viscosity();
    end_of_kind();
    if (golden_.resolved.look.style == gl::Style::mesh)
      check_normals();
    end_of_kind();
    fmt::print("\n");
  }

 private:
  void check_unchanged() {
    const Found noise = found(draw(golden_.resolved, right_.frame));
    INFO(golden_.name << ": nothing is changed; FLIP " << noise.metrics.flip.mean);
    CHECK(noise.of_limit < most_noise);
    print(noise);
  }

  void check_light() {
    for (const auto& [degrees, axis] : {std::pair{8.f, glm::vec3(0, 0, 1)}, {20.f, {0, 1, 0}}}) {
      app::Scene scene = golden_.resolved;
      scene.light.direction = turned(scene.light.direction, degrees, axis);
      expect_noticed(fmt::format("the light turned by {} degrees", degrees),
                     draw(scene, right_.frame));
    }
  }

  void check_obstacles() {
    const auto& obstacles = golden_.resolved.simulation.obstacles;
    for (std::size_t k = 0; k < obstacles.size(); ++k) {
      app::Scene scene = golden_.resolved;
      scene.simulation.obstacles.erase(scene.simulation.obstacles.begin() +
                                       static_cast<std::ptrdiff_t>(k));
      expect_noticed(fmt::format("without obstacles[{}]", k), simulate_and_draw(scene));
    }
  }

  void check_viscosity() {
    for (const float factor : {1.2f, 0.8f}) {
      app::Scene scene = golden_.resolved;
      scene.simulation.fluid.viscosity *= factor;
      expect_noticed(fmt::format("viscosity times {}", factor), simulate_and_draw(scene));
    }
  }

  void check_normals() {
    const auto plant = [&](const char* name, const auto& change) {
      expect_noticed(name, draw(golden_.resolved, right_.frame, change));
    };
    plant("normals flipped", [](glm::vec3 n) { return -n; });
    plant("y and z of normals exchanged", [](glm::vec3 n) { return glm::vec3(n.x, n.z, n.y); });
    plant("normals turned by 20 degrees", [](glm::vec3 n) { return turned(n, 20, {0, 0, 1}); });
  }

  template <class F>
  static Image draw(const app::Scene& scene, const sim::Frame& frame, F normal) {
    app::SceneDrawing drawing(scene);
    Mesh surface;
    if (drawing.shows_surface())
      surface = drawing.surface_of(frame);
    for (glm::vec3& n : surface.normals)
      n = normal(n);
    return drawing.draw(frame, surface);
  }

  static Image draw(const app::Scene& scene, const sim::Frame& frame) {
    return draw(scene, frame, [](glm::vec3 n) { return n; });
  }

  Image simulate_and_draw(const app::Scene& scene) const {
    return draw(scene, simulated(scene, golden_.frames.front()).frame);
  }

  Found found(const Image& picture) const {
    const auto metrics = compare::compare(reference_, picture, threshold_).tally.metrics();
    return {metrics, std::max(metrics.flip.mean / max_flip_, metrics.changed / max_changed_)};
  }

  void expect_noticed(const std::string& change, const Image& picture) {
    const Found change_found = found(picture);
    INFO(golden_.name << ": " << change << "; FLIP " << change_found.metrics.flip.mean
                      << ", changed " << change_found.metrics.changed);
    CHECK(change_found.of_limit > least_change);
    if (!least_ || change_found.of_limit < least_->of_limit)
      least_ = change_found;
  }

  static void print(const Found& f) {
    fmt::print(" {:.4f}, {:.2f} % |", f.metrics.flip.mean, 100 * f.metrics.changed);
  }

  /// Of several changes of a kind the table has the one that is seen least.
  void end_of_kind() {
    if (least_)
      print(*least_);
    else
      fmt::print(" |");
    least_.reset();
  }

  const app::Golden& golden_;
  int threshold_;
  double max_flip_, max_changed_;
  Image reference_;
  app::CachedFrame right_;
  std::optional<Found> least_;
};

}  // namespace

TEST_CASE(
    "golden tests of shipped scenes notice planted changes, and pass with Mesa set otherwise") {
  // As on a processor without AVX; read when the first picture is drawn.
  ::setenv("GALLIUM_OVERRIDE_CPU_CAPS", "sse4.1", 1);
  ::setenv("LP_NATIVE_VECTOR_WIDTH", "128", 1);
  const app::GoldenList list = app::read_golden_list(list_file);
  for (const app::Golden& golden : list.goldens)
    DYNAMIC_SECTION(golden.name) {
      Planting(list, golden).check();
    }
}

}  // namespace planted_tests
