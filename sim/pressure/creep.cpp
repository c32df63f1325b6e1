#include "sim/pressure/creep.hpp"

#include <cmath>

namespace spindrift::sim::inline SPINDRIFT_BACKEND {
namespace {

/// How far a step may move freely falling liquid, in spacings.
constexpr double longest_way = 0.02;

/// Share of solver.mean_compression that a step may leave. Measured on 16 pools with a body in
/// them: the first frame's mean compression is up to 1.6 times the setting with 1, up to 1.2 times
/// with 0.5, and up to 1.1 times with 0.25, less than that in 15 of them.
constexpr float tightness = 0.25f;

}  // namespace

Creep::Creep(const std::vector<std::uint32_t>& loose, std::uint32_t next_id) {
  std::vector<std::uint32_t> is_loose(next_id);
  for (const std::uint32_t number : loose)
    is_loose[number] = 1;
  put(is_loose_, is_loose);
  position_.resize(next_id);
  velocity_.resize(next_id);
}

double Creep::longest_step(double acceleration, float spacing) {
  return std::sqrt(longest_way * spacing / acceleration);
}

SolverSettings Creep::tightened(SolverSettings settings) {
  settings.mean_compression *= tightness;
  return settings;
}

void Creep::begin(Executor& executor, Particles& particles) {
  const Vec3Arrays x = particles.position.view(), v = particles.velocity.view(),
                   kept_x = position_.view(), kept_v = velocity_.view();
  const std::uint32_t* ids = particles.ids.data();
  executor.for_each("settle", particles.count, [=] SPINDRIFT_HD(std::uint32_t i) {
    kept_x.set(ids[i], x[i]);
    kept_v.set(ids[i], v[i]);
    v.set(i, {0, 0, 0});
  });
}

void Creep::end_step(Executor& executor, Particles& particles) {
  const Vec3Arrays x = particles.position.view(), v = particles.velocity.view(),
                   kept_x = position_.view();
  const std::uint32_t *ids = particles.ids.data(), *is_loose = is_loose_.data();
  executor.for_each("settle", particles.count, [=] SPINDRIFT_HD(std::uint32_t i) {
    v.set(i, {0, 0, 0});
    if (is_loose[ids[i]] == 0)
      x.set(i, kept_x[ids[i]]);
  });
}

void Creep::end(Executor& executor, Particles& particles) {
  const Vec3Arrays v = particles.velocity.view(), kept_v = velocity_.view();
  const std::uint32_t* ids = particles.ids.data();
  executor.for_each("settle", particles.count,
                    [=] SPINDRIFT_HD(std::uint32_t i) { v.set(i, kept_v[ids[i]]); });
}

}  // namespace spindrift::sim::inline SPINDRIFT_BACKEND
