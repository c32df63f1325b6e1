// What a simulation is made from: plain data, SI units, every default stated.
#pragma once

#include <glm/glm.hpp>
#include <optional>
#include <variant>
#include <vector>

#include "sim/geometry/motion.hpp"
#include "sim/geometry/shape.hpp"

namespace spindrift::sim {

using namespace geometry;

/// A region filled with liquid at the start, but for what obstacles take up of it: particles on a
/// lattice that fits a box, or the bounds of a mesh, from face to face, as near to the fluid's
/// spacing as can be, and round shapes so that they hold their volume.
struct Volume {
  Shape shape = Box{};
  glm::vec3 velocity{0.f};  ///< initial velocity, m/s
};

/// A round opening that liquid enters through.
struct Disc {
  glm::vec3 center{0.f};              ///< m
  glm::vec3 direction{0.f, -1, 0.f};  ///< the way the liquid goes, at right angles to the opening
  float radius = 0.1f;                ///< m
};

/// A rectangular one.
struct Rectangle {
  glm::vec3 center{0.f};              ///< m
  glm::vec3 direction{0.f, -1, 0.f};  ///< the way the liquid goes, at right angles to the opening
  glm::vec3 up{0.f, 1.f, 0.f};        ///< along its height, as far as that is across the direction
  float width = 0.2f;                 ///< m
  float height = 0.2f;                ///< m
};

using Opening = std::variant<Disc, Rectangle>;

/// Liquid that enters the domain: area times speed in volume. It is carried through a nozzle, four
/// spacings long, that ends at the opening, and is free from there on.
struct Emitter {
  Opening opening = Disc{};
  float speed = 1.f;      ///< m/s
  float from = 0.f;       ///< when the first liquid comes out, s
  float to = 1e5f;        ///< when it ends, s
  int max_particles = 0;  ///< it ends after this many as well, whole layers; 0: any number
};

struct FluidSettings {
  float spacing =
      0.025f;  ///< distance between particle centres at rest, m; support radius is 2 spacings
  float rest_density = 1000.f;  ///< kg/m³
  float viscosity = 0.01f;      ///< dynamic viscosity, Pa·s
  float wall_viscosity = 0.f;  ///< with which walls and obstacles hold the liquid back, Pa·s; 0: it
                               ///< slips, the liquid's own viscosity: it sticks
  float surface_tension = 0.f;  ///< σ against the air, N/m; 0: none
  float contact_angle = 90.f;   ///< at which liquid that has surface tension meets walls and
                                ///< obstacles, degrees; 180: they are as air to it
  std::vector<Volume> volumes{{Box{{0.f, 0.f, 0.f}, {1.f, 1.f, 0.8f}}, glm::vec3{0.f}}};
  std::vector<Emitter> emitters = {};
};

enum class Direction { plus_x, minus_x, plus_y, minus_y, plus_z, minus_z };

/// The box that holds the liquid; its inner faces.
struct DomainSettings {
  glm::vec3 min{0.f};                ///< m
  glm::vec3 max{3.2f, 2.0f, 0.8f};   ///< m
  std::vector<Direction> open = {};  ///< faces without a wall, by the way out through them
};

/// Particles that come into it are taken away.
struct Sink {
  Shape shape = Box{};
};

/// A solid body, fixed or moving.
struct Obstacle {
  Shape shape = Box{};
  std::optional<float> wall_viscosity = std::nullopt;  ///< Pa·s; none: the fluid's
  std::optional<Motion> motion = std::nullopt;         ///< none: fixed
};

/// One key of a body acceleration that varies in time, linear in between, constant outside.
struct AccelerationKey {
  float time = 0.f;             ///< s
  glm::vec3 acceleration{0.f};  ///< m/s²
};

/// Air around the liquid, which slows down its spray.
struct AirSettings {
  float density = 1.2041f;      ///< kg/m³
  float viscosity = 1.845e-5f;  ///< dynamic viscosity, Pa·s
  glm::vec3 velocity{0.f};      ///< m/s: wind
};

struct ForceSettings {
  glm::vec3 gravity{0.f, -9.81f, 0.f};            ///< m/s²
  std::vector<AccelerationKey> body;              ///< added to gravity; none by default
  std::optional<AirSettings> air = std::nullopt;  ///< none: it does not slow the liquid down
};

enum class SolverType { pcisph, sph };
enum class Backend { automatic, cpu, cuda };
enum class PressureKernel { cubic, spiky };

struct SolverSettings {
  SolverType type = SolverType::pcisph;
  Backend backend = Backend::cpu;  ///< what computes; automatic: CUDA where that can
  PressureKernel pressure_kernel = PressureKernel::cubic;
  float max_compression =
      0.025f;  ///< PCISPH: largest ρ/ρ₀ − 1 left over by any step; (1e-4 ... 0.5)
  float mean_compression =
      0.001f;  ///< PCISPH: mean of max(0, ρ/ρ₀ − 1) left over by any step; (1e-5 ... 0.5)
  int min_iterations =
      1;  ///< PCISPH: pressure iterations per step, at least, where any pressure acts
  int max_iterations = 60;  ///< PCISPH: at most; a step not converged by then is repeated smaller
  float speed_of_sound =
      0.f;           ///< basic SPH: m/s; 0: ten times the fastest speed the scene can reach
  float cfl = 0.4f;  ///< CFL number: largest v Δt / H, H the support radius; (0.01 ... 1)
  float max_time_step = 0.005f;  ///< s
  float min_time_step =
      1e-7f;  ///< s; a step that would have to be smaller ends the run with an error
};

/// All that the simulation depends on. Nothing of how it is looked at.
struct Settings {
  FluidSettings fluid;
  DomainSettings domain;
  std::vector<Obstacle> obstacles;
  std::vector<Sink> sinks;
  ForceSettings forces;
  SolverSettings solver;

  /// Whether particles come or go during a run.
  bool exchanges_particles() const {
    return !fluid.emitters.empty() || !sinks.empty() || !domain.open.empty();
  }
};

}  // namespace spindrift::sim
