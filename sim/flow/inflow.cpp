#include "sim/flow/inflow.hpp"

#include <algorithm>
#include <limits>
#include <stdexcept>

#include "sim/flow/nozzle_rim.hpp"
#include "sim/step/measure.hpp"

namespace spindrift::sim::inline SPINDRIFT_BACKEND {
namespace {

/// A particle is not brought in where the centre of another is closer than this, in spacings. A
/// place in the middle of eight particles of a lattice is 0.866 spacings from each.
constexpr float least_distance = 0.87f;

/// A step's end and an event whose times differ by less than this, s, are at the same time.
constexpr double instant = 1e-9;

/// Sets Particles::held to which particles nozzles carry.
void mark(Executor& executor, Particles& particles, const HeldLayersView& carried) {
  if (carried.count == 0 && particles.held.empty())
    return;
  const std::uint32_t n = particles.count;
  float* held = particles.held.resized(n);
  const HeldLayersView layers = carried;
  const std::uint32_t* ids = particles.ids.data();
  executor.for_each("carry inflow", n, [=] SPINDRIFT_HD(std::uint32_t i) {
    held[i] = layers.of(ids[i]) != nullptr ? 1.f : 0.f;
  });
}

/// Released particles have been in free fall from the opening on: the position up to this time, the
/// velocity up to the middle of the last step.
/// @param carried the layers as they are now @param last_step the duration of the last step, s
/// @param acceleration of gravity and body forces, m/s²
void release(Executor& executor, Particles& particles, const HeldLayersView& carried,
             double last_step, const Vec3<float>& acceleration) {
  const Vec3Arrays x = particles.position.view(), v = particles.velocity.view();
  const HeldLayersView layers = carried;
  const std::uint32_t* ids = particles.ids.data();
  const Vec3<float> a = acceleration;
  executor.for_each("carry inflow", particles.count, [=] SPINDRIFT_HD(std::uint32_t i) {
    const HeldLayer* l = layers.of(ids[i]);
    if (l == nullptr || l->fall < 0)
      return;
    const double fall = l->fall;
    x.set(i, x[i] + static_cast<float>(0.5 * fall * fall) * a);
    v.set(i, v[i] + static_cast<float>(fall - 0.5 * last_step) * a);
  });
}

/// Where a search leaves what it finds: indices of particles, and their positions, m.
struct FoundParticles {
  Array<std::uint32_t>& indices;
  Array<Vec3<float>>& positions;
};

/// Finds the positions (m) of the particles in a box, except those that one nozzle carries.
std::vector<glm::vec3> in_the_place_of(Executor& executor, Particles& particles,
                                       const HeldLayersView& carried, std::uint32_t nozzle,
                                       const Box& box, const FoundParticles& result) {
  const Vec3Arrays x = particles.position.view();
  const HeldLayersView layers = carried;
  const Box place = box;
  const std::uint32_t* ids = particles.ids.data();
  const auto is_there = [=] SPINDRIFT_HD(std::uint32_t i) {
    const Vec3<float> p = x[i];
    if (p.x < place.min.x || p.y < place.min.y || p.z < place.min.z || p.x > place.max.x ||
        p.y > place.max.y || p.z > place.max.z)
      return false;
    const HeldLayer* own = layers.of(ids[i]);
    return own == nullptr || own->nozzle != nozzle;
  };
  executor.select("bring inflow", particles.count, result.indices, is_there);
  const auto count = static_cast<std::uint32_t>(result.indices.size());
  grow(result.positions, count);
  Vec3<float>* positions = result.positions.data();
  const std::uint32_t* found = result.indices.data();
  executor.for_each("bring inflow", count,
                    [=] SPINDRIFT_HD(std::uint32_t k) { positions[k] = x[found[k]]; });
  executor.wait();
  std::vector<glm::vec3> there;
  for (const Vec3<float>& p : result.positions)
    there.emplace_back(p.x, p.y, p.z);
  return there;
}

}  // namespace

Inflow::Inflow(const Settings& settings, const FluidConstants& constants, std::uint32_t first_id)
    : settings_(settings), constants_(constants), first_id_(first_id) {
  for (const Emitter& emitter : settings.fluid.emitters) {
    nozzles_.emplace_back(emitter, settings.fluid.spacing);
    put(points_.emplace_back(), nozzles_.back().points());
  }
  entered_.resize(nozzles_.size());
}

std::uint32_t Inflow::next_id(double time) const {
  std::int64_t id = first_id_;
  for (const Nozzle& nozzle : nozzles_)
    id += nozzle.entered(time + instant) * nozzle.layer_size();
  if (id > std::numeric_limits<std::uint32_t>::max())
    throw std::runtime_error("more than 4,294,967,295 particles have come out of fluid.emitters");
  return static_cast<std::uint32_t>(id);
}

/// Ids are given in the order in which layers come in, and at the same time in the order of the
/// emitters, so that they depend on nothing but the time.
Inflow::Layer Inflow::layer(std::uint32_t nozzle, std::int64_t k) const {
  const double time = nozzles_[nozzle].entry_time(k);
  std::int64_t id = first_id_;
  for (std::uint32_t n = 0; n < nozzles_.size(); ++n) {
    const std::int64_t before = n < nozzle    ? nozzles_[n].entered(time)
                                : n == nozzle ? k
                                              : nozzles_[n].entered_before(time);
    id += before * nozzles_[n].layer_size();
  }
  return {static_cast<std::uint32_t>(id), nozzle, k};
}

double Inflow::next_begin(double time, double end) const {
  for (const Nozzle& nozzle : nozzles_)
    if (nozzle.begin() > time + instant)
      end = std::min(end, nozzle.begin());
  return end;
}

float Inflow::speed_within(double begin, double end) const {
  float speed = 0;
  for (const Nozzle& nozzle : nozzles_)
    speed = std::max(speed, nozzle.speed_within(begin, end));
  return speed;
}

/// A boundary particle in the liquid's way has no volume while the nozzle is open; its density
/// ratio is then below 1 however close the liquid is, so that no pressure builds up. A boundary
/// particle beside the nozzle must not take the liquid in the nozzle, which is behind the wall's
/// face, for liquid that presses on it: it would push the jet on, by a third of its speed. Nor must
/// its volume compress the liquid that passes.
void Inflow::attach(Walls& walls) {
  constexpr float lowered = 3;
  const float reach = constants_.support_radius;
  const CubicKernel kernel(reach);
  Boundary& boundary = walls.boundary();
  openings_.resize(nozzles_.size());
  for (std::size_t n = 0; n < nozzles_.size(); ++n) {
    const Nozzle& nozzle = nozzles_[n];
    const Box in = nozzle.bounds();
    std::vector<WallSample> samples, beside;
    NozzleSamples found;
    for (std::uint32_t b = 0; b < boundary.count(); ++b) {
      const glm::vec3 x = boundary.position(b);
      if (glm::any(glm::lessThan(x, in.min - reach)) ||
          glm::any(glm::greaterThan(x, in.max + reach)))
        continue;
      const float volume = boundary.volume(b), solid = boundary.solids()[b];
      if (nozzle.is_in_the_way(x)) {
        samples.push_back({b, volume, solid, 0, lowered});
        found.in_the_way.push_back({x, volume});
      } else if (const double sum = nozzle.kernel_sum(x, kernel); sum > 0) {
        const float taken = constants_.volume * static_cast<float>(sum);
        beside.push_back({b, volume, solid, 1, taken});
        found.beside.push_back({x, volume});
      }
    }
    const std::vector<float> parts =
        parts_beside(nozzle, found, reach, constants_.spacing, constants_.volume);
    for (std::size_t k = 0; k < beside.size(); ++k) {
      beside[k].part = parts[k];
      samples.push_back(beside[k]);
    }
    put(openings_[n].samples, samples);
  }
}

/// Nozzles beside each other may share boundary particles. All are therefore reset before any is
/// lessened, so that the result depends on how far each nozzle is closed, and not on the order in
/// which the nozzles opened.
void Inflow::open_walls(Executor& executor, Walls& walls, double start, double end) {
  bool changed = false;
  for (std::size_t n = 0; n < nozzles_.size(); ++n) {
    Opening& opening = openings_[n];
    const Nozzle& nozzle = nozzles_[n];
    const double part = nozzle.begin() > start + instant ? 1 : nozzle.closed_part(end + instant);
    if (opening.closed_part == part)
      continue;
    changed = true;
    disturbs_ = disturbs_ || (part == 0 && !opening.samples.empty());
    opening.closed_part = part;
  }
  if (!changed)
    return;
  const SampleSetter wall = walls.sample_setter();
  for (const Opening& opening : openings_) {
    const WallSample* samples = opening.samples.data();
    executor.for_each("open walls", static_cast<std::uint32_t>(opening.samples.size()),
                      [=] SPINDRIFT_HD(std::uint32_t k) {
                        wall.set(samples[k].index, samples[k].volume, samples[k].solid);
                      });
  }
  for (const Opening& opening : openings_) {
    const auto closed = static_cast<float>(opening.closed_part);
    const WallSample* samples = opening.samples.data();
    executor.for_each("open walls", static_cast<std::uint32_t>(opening.samples.size()),
                      [=] SPINDRIFT_HD(std::uint32_t k) {
                        const WallSample& s = samples[k];
                        wall.lessen(s.index, glm::mix(s.part, 1.f, closed), (1 - closed) * s.loss);
                      });
  }
}

void Inflow::resume(Executor& executor, Particles& particles, Walls& walls, double time) {
  for (std::size_t n = 0; n < nozzles_.size(); ++n)
    entered_[n] = nozzles_[n].entered(time + instant);
  note_held_layers(time);
  mark(executor, particles, layers());
  open_walls(executor, walls, time, time);
}

void Inflow::note_held_layers(double time) {
  held_layers_.clear();
  for (std::uint32_t n = 0; n < nozzles_.size(); ++n)
    for (std::int64_t k = nozzles_[n].released(time); k < nozzles_[n].entered(time + instant); ++k)
      held_layers_.push_back(layer(n, k));
  std::sort(held_layers_.begin(), held_layers_.end(),
            [](const Layer& a, const Layer& b) { return a.first_id < b.first_id; });
  layers_at(time);
}

HeldLayersView Inflow::layers_at(double time) {
  std::vector<HeldLayer> layers;
  for (const Layer& l : held_layers_) {
    const Nozzle& nozzle = nozzles_[l.nozzle];
    layers.push_back({.first_id = l.first_id,
                      .size = nozzle.layer_size(),
                      .nozzle = l.nozzle,
                      .points = points_[l.nozzle].data(),
                      .direction = nozzle.direction(),
                      .velocity = nozzle.velocity(),
                      .way = nozzle.way(l.k, time),
                      .fall = time - nozzle.release_time(l.k)});
  }
  put(layers_, layers);
  return this->layers();
}

void Inflow::carry(Executor& executor, Particles& particles, double time) {
  if (held_layers_.empty())
    return;
  const PointView x = particles.drifted_position.view(), v = particles.drifted_velocity.view();
  const HeldLayersView layers = layers_at(time);
  const std::uint32_t* ids = particles.ids.data();
  executor.for_each("carry inflow", particles.count, [=] SPINDRIFT_HD(std::uint32_t i) {
    const HeldLayer* l = layers.of(ids[i]);
    if (l == nullptr)
      return;
    x.set(i, from_glm(pushed(l->points[ids[i] - l->first_id], l->direction, l->way)));
    v.set(i, from_glm(l->velocity));
  });
}

Exchange Inflow::bring(Executor& executor, Particles& particles, const Layer& layer, double time) {
  const Nozzle& nozzle = nozzles_[layer.nozzle];
  std::vector<glm::vec3> places;
  for (std::uint32_t p = 0; p < nozzle.layer_size(); ++p)
    places.push_back(nozzle.position(layer.k, p, time));
  const float distance = least_distance * constants_.spacing, reach = constants_.support_radius;
  Box around{places[0], places[0]};
  for (const glm::vec3& p : places) {
    around.min = glm::min(around.min, p - reach);
    around.max = glm::max(around.max, p + reach);
  }
  const std::vector<glm::vec3> others = in_the_place_of(executor, particles, layers(), layer.nozzle,
                                                        around, {found_, found_positions_});
  disturbs_ = disturbs_ || !others.empty();
  std::vector<glm::vec3> positions;
  std::vector<std::uint32_t> ids;
  Exchange exchange;
  for (std::uint32_t p = 0; p < nozzle.layer_size(); ++p) {
    const bool taken = std::any_of(others.begin(), others.end(), [&](const glm::vec3& other) {
      return glm::distance(other, places[p]) < distance;
    });
    if (taken)
      continue;
    positions.push_back(places[p]);
    ids.push_back(layer.first_id + p);
    exchange.energy_in += energy_of(constants_, settings_, places[p], nozzle.velocity());
  }
  exchange.entered = static_cast<std::int64_t>(positions.size());
  exchange.held_back = nozzle.layer_size() - exchange.entered;
  exchange_.append(executor, particles, positions, nozzle.velocity(), ids);
  return exchange;
}

Exchange Inflow::advance(Executor& executor, Particles& particles, Walls& walls, double time,
                         double last_step, const Vec3<float>& acceleration) {
  disturbs_ = false;
  const bool lets_go = std::any_of(held_layers_.begin(), held_layers_.end(), [&](const Layer& l) {
    return nozzles_[l.nozzle].release_time(l.k) <= time;
  });
  if (lets_go)
    release(executor, particles, layers_at(time), last_step, acceleration);
  note_held_layers(time);
  next_id(time);  // throws if the ids run out
  std::vector<Layer> entering;
  for (std::uint32_t n = 0; n < nozzles_.size(); ++n)
    for (const std::int64_t end = nozzles_[n].entered(time + instant); entered_[n] < end;
         ++entered_[n])
      entering.push_back(layer(n, entered_[n]));
  Exchange exchange;
  for (const Layer& l : entering)
    exchange += bring(executor, particles, l, time);
  mark(executor, particles, layers());
  open_walls(executor, walls, time, time);
  return exchange;
}

}  // namespace spindrift::sim::inline SPINDRIFT_BACKEND
