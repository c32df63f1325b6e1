#include "sim/flow/nozzle_rim.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "sim/core/kernels.hpp"

namespace spindrift::sim {
namespace {

/// The compression that walls may add to passing liquid, as a density ratio. If it were 0, boundary
/// particles almost a support radius away would have to go, on which liquid before the wall counts.
constexpr double accepted = 0.01;

/// The most passes over all places; in each pass boundary particles lose part of their volume where
/// they are too much.
constexpr int most_passes = 100;

/// The contribution of a boundary particle to the density ratio at a place.
struct Share {
  std::uint32_t sample;
  double value;  ///< V W with its full volume
};

/// A place where fluid particles come by, with the boundary particles near it.
struct Place {
  double room = 0;  ///< the density ratio that boundary particles may contribute there
  std::vector<Share> shares;

  /// The density ratio that boundary particles contribute if each b keeps the fraction parts[b] of
  /// its volume.
  double sum(const std::vector<double>& parts) const {
    double sum = 0;
    for (const Share& share : shares)
      sum += parts[share.sample] * share.value;
    return sum;
  }
};

/// The density ratio at one of the columns of a jet that is infinitely long.
double ratio_in_jet(const Nozzle& nozzle, const glm::vec3& column, float support_radius,
                    double particle_volume) {
  const CubicKernel kernel(support_radius);
  const double distance = nozzle.layer_distance(), reach = support_radius;
  const int layers = static_cast<int>(std::ceil(reach / distance));
  double sum = 0;
  for (const glm::vec3& other : nozzle.points()) {
    const double across = glm::distance(column, other);
    for (int k = -layers; across < reach && k <= layers; ++k)
      sum += kernel.value(static_cast<float>(std::hypot(across, k * distance)));
  }
  return particle_volume * sum;
}

/// Appends the places along one column, a quarter of a layer distance apart, that any boundary
/// particle contributes to.
void add_places(const Nozzle& nozzle, const glm::vec3& column,
                const std::vector<RimSample>& samples, float support_radius, double particle_volume,
                std::vector<Place>& places) {
  constexpr int per_layer = 4, behind = Nozzle::depth * per_layer, beyond = 2 * per_layer;
  const CubicKernel kernel(support_radius);
  const float step = nozzle.layer_distance() / per_layer;
  std::vector<Place> own(behind + beyond + 1);
  for (std::uint32_t b = 0; b < samples.size(); ++b) {
    const glm::vec3 off = samples[b].position - column;
    const float along = glm::dot(off, nozzle.direction());
    if (glm::length(off - along * nozzle.direction()) >= support_radius)
      continue;
    for (int k = -behind; k <= beyond; ++k) {
      const glm::vec3 at = static_cast<float>(k) * step * nozzle.direction();
      if (const double w = kernel.value(glm::distance(off, at)); w > 0)
        own[behind + k].shares.push_back({b, w * samples[b].volume});
    }
  }
  std::erase_if(own, [](const Place& place) { return place.shares.empty(); });
  if (own.empty())
    return;
  const double room =
      accepted + std::max(0., 1 - ratio_in_jet(nozzle, column, support_radius, particle_volume));
  for (Place& place : own) {
    place.room = room;
    places.push_back(std::move(place));
  }
}

/// Σ V W of samples at a place.
double sum_at(const glm::vec3& at, const std::vector<RimSample>& samples,
              const CubicKernel& kernel) {
  double sum = 0;
  for (const RimSample& sample : samples)
    sum += double{sample.volume} * kernel.value(glm::distance(at, sample.position));
  return sum;
}

/// The places of liquid that stands half a spacing before the wall when the nozzle opens: a grid of
/// half a spacing, as far around the opening as its particles reach.
void add_places_before(const Nozzle& nozzle, const NozzleSamples& samples, float support_radius,
                       float spacing, double particle_volume, std::vector<Place>& places) {
  const CubicKernel kernel(support_radius);
  const float step = 0.5f * spacing;
  const auto [center, reach] = nozzle.opening_ball();
  const auto [across, up] = nozzle.axes_across();
  const int most = static_cast<int>((reach + support_radius) / step);
  for (int j = -most; j <= most; ++j)
    for (int i = -most; i <= most; ++i) {
      const glm::vec3 at = center + step * (static_cast<float>(i) * across +
                                            static_cast<float>(j) * up + nozzle.direction());
      Place place;
      for (std::uint32_t b = 0; b < samples.beside.size(); ++b) {
        const RimSample& sample = samples.beside[b];
        if (const double w = kernel.value(glm::distance(at, sample.position)); w > 0)
          place.shares.push_back({b, w * sample.volume});
      }
      const double brought = particle_volume * nozzle.kernel_sum_at_begin(at, kernel);
      if (place.shares.empty() || brought == 0)
        continue;
      place.room = accepted + std::max(0., sum_at(at, samples.beside, kernel) +
                                               sum_at(at, samples.in_the_way, kernel) - brought);
      places.push_back(std::move(place));
    }
}

}  // namespace

std::vector<float> parts_beside(const Nozzle& nozzle, const NozzleSamples& samples,
                                float support_radius, float spacing, float particle_volume) {
  std::vector<Place> places;
  for (const glm::vec3& column : nozzle.points())
    add_places(nozzle, column, samples.beside, support_radius, particle_volume, places);
  add_places_before(nozzle, samples, support_radius, spacing, particle_volume, places);
  const std::size_t count = samples.beside.size();
  std::vector<double> parts(count, 1.), lost(count), weight(count);
  for (int pass = 0; pass < most_passes; ++pass) {
    std::fill(lost.begin(), lost.end(), 0.);
    std::fill(weight.begin(), weight.end(), 0.);
    bool fits = true;
    for (const Place& place : places) {
      const double sum = place.sum(parts);
      if (sum <= 1.0001 * place.room)
        continue;
      fits = false;
      for (const Share& share : place.shares) {
        lost[share.sample] += share.value * (1 - place.room / sum);
        weight[share.sample] += share.value;
      }
    }
    if (fits)
      break;
    for (std::size_t b = 0; b < parts.size(); ++b)
      if (weight[b] > 0)
        parts[b] *= 1 - lost[b] / weight[b];
  }
  return {parts.begin(), parts.end()};
}

}  // namespace spindrift::sim
