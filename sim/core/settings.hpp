// The settings of a simulation: plain data in SI units, with every default stated. The scene file
// is read into them.
#pragma once

#include <glm/glm.hpp>
#include <optional>
#include <variant>
#include <vector>

#include "sim/geometry/motion.hpp"
#include "sim/geometry/shape.hpp"

namespace spindrift::sim {

using namespace geometry;

/// A region filled with liquid at the start, but for what obstacles take up of it. Its particles
/// lie on a lattice as near to the fluid's spacing as can be: it fits a box, or the bounds of a
/// mesh, from face to face, and fills round shapes so that they hold their volume.
struct Volume {
  Shape shape = Box{};
  glm::vec3 velocity{0.f};  ///< initial velocity, m/s
};

/// A round opening that liquid enters through.
struct Disc {
  glm::vec3 center{0.f};              ///< m
  glm::vec3 direction{0.f, -1, 0.f};  ///< direction of the flow, at right angles to the opening
  float radius = 0.1f;                ///< m
};

/// A rectangular opening that liquid enters through.
struct Rectangle {
  glm::vec3 center{0.f};              ///< m
  glm::vec3 direction{0.f, -1, 0.f};  ///< direction of the flow, at right angles to the opening
  /// Direction of the height; only its part at right angles to `direction` counts.
  glm::vec3 up{0.f, 1.f, 0.f};
  float width = 0.2f;   ///< m
  float height = 0.2f;  ///< m
};

using Opening = std::variant<Disc, Rectangle>;

/// A source of liquid, which brings in the opening's area times the speed in volume per time. The
/// liquid is carried through a nozzle, four spacings long, that ends at the opening, and is free
/// from there on.
struct Emitter {
  Opening opening = Disc{};
  float speed = 1.f;      ///< m/s
  float from = 0.f;       ///< time at which the first liquid comes out, s
  float to = 1e5f;        ///< time at which the last liquid comes out, s
  int max_particles = 0;  ///< most particles in all, rounded down to whole layers; 0: no limit
};

struct FluidSettings {
  /// Distance between particle centres at rest, m; the support radius is 2 spacings.
  float spacing = 0.025f;
  float rest_density = 1000.f;  ///< kg/m³
  float viscosity = 0.01f;      ///< dynamic viscosity, Pa·s
  /// Dynamic viscosity with which walls and obstacles hold the liquid back, Pa·s. At 0 the liquid
  /// slips; at the liquid's own viscosity it sticks.
  float wall_viscosity = 0.f;
  float surface_tension = 0.f;  ///< σ against the air, N/m; 0: none
  /// Angle at which liquid that has surface tension meets walls and obstacles, degrees. At 180 they
  /// are as air to it.
  float contact_angle = 90.f;
  std::vector<Volume> volumes{{Box{{0.f, 0.f, 0.f}, {1.f, 1.f, 0.8f}}, glm::vec3{0.f}}};
  std::vector<Emitter> emitters = {};
};

/// A direction along an axis; it also names the face of the domain that lies that way.
enum class Direction { plus_x, minus_x, plus_y, minus_y, plus_z, minus_z };

/// The box that holds the liquid, given by its inner faces.
struct DomainSettings {
  glm::vec3 min{0.f};                ///< m
  glm::vec3 max{3.2f, 2.0f, 0.8f};   ///< m
  std::vector<Direction> open = {};  ///< faces without a wall, each by the direction out through it
};

/// A region in which particles are taken away.
struct Sink {
  Shape shape = Box{};
};

/// A solid body, fixed or moving.
struct Obstacle {
  Shape shape = Box{};
  std::optional<float> wall_viscosity = std::nullopt;  ///< Pa·s; none: FluidSettings' value
  std::optional<Motion> motion = std::nullopt;         ///< none: the obstacle is fixed
};

/// One key of a body acceleration that varies in time: linear between keys, constant before the
/// first and after the last.
struct AccelerationKey {
  float time = 0.f;             ///< s
  glm::vec3 acceleration{0.f};  ///< m/s²
};

/// Air around the liquid, which slows down its spray.
struct AirSettings {
  float density = 1.2041f;      ///< kg/m³
  float viscosity = 1.845e-5f;  ///< dynamic viscosity, Pa·s
  glm::vec3 velocity{0.f};      ///< velocity of the wind, m/s
};

struct ForceSettings {
  glm::vec3 gravity{0.f, -9.81f, 0.f};            ///< m/s²
  std::vector<AccelerationKey> body;              ///< acceleration added to gravity; may be empty
  std::optional<AirSettings> air = std::nullopt;  ///< none: no drag of the air
};

/// The pressure solver: PCISPH, or basic SPH with an equation of state.
enum class SolverType { pcisph, sph };
enum class Backend { automatic, cpu, cuda };
/// The kernel whose gradient gives the pressure force; see kernels.hpp.
enum class PressureKernel { cubic, spiky };

struct SolverSettings {
  SolverType type = SolverType::pcisph;
  Backend backend = Backend::cpu;  ///< automatic: CUDA where it is available, else the CPU
  PressureKernel pressure_kernel = PressureKernel::cubic;
  /// PCISPH: the largest ρ/ρ₀ − 1 that any step leaves over; (1e-4 ... 0.5).
  float max_compression = 0.025f;
  /// PCISPH: the mean of max(0, ρ/ρ₀ − 1) that any step leaves over; (1e-5 ... 0.5).
  float mean_compression = 0.001f;
  /// PCISPH: fewest pressure iterations per step, where any pressure acts.
  int min_iterations = 1;
  /// PCISPH: most pressure iterations per step; a step not converged by then is repeated smaller.
  int max_iterations = 60;
  /// Basic SPH: speed of sound of the equation of state, m/s; 0: ten times the fastest speed that
  /// the scene can reach.
  float speed_of_sound = 0.f;
  float cfl = 0.4f;  ///< CFL number: largest v Δt / H, H the support radius; (0.01 ... 1)
  float max_time_step = 0.005f;  ///< s
  /// Smallest time step size, s; a step that would have to be smaller ends the run with an error.
  float min_time_step = 1e-7f;
};

/// All that the simulation depends on, and nothing of how it is rendered.
struct Settings {
  FluidSettings fluid;
  DomainSettings domain;
  std::vector<Obstacle> obstacles;
  std::vector<Sink> sinks;
  ForceSettings forces;
  SolverSettings solver;

  /// Whether particles can enter or leave the domain during a run.
  bool exchanges_particles() const {
    return !fluid.emitters.empty() || !sinks.empty() || !domain.open.empty();
  }
};

}  // namespace spindrift::sim
