#include "sim/flow/nozzle.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>

#include "sim/core/kernels.hpp"

namespace spindrift::sim {
namespace {

/// Two unit vectors that span the plane of an opening.
struct Frame2 {
  glm::vec3 across, up;
};

/// The frame at right angles to `direction`, with `up` as near to the given vector as can be.
Frame2 frame_of(const glm::vec3& direction, const glm::vec3& up) {
  const glm::vec3 across = glm::normalize(glm::cross(up, direction));
  return {across, glm::cross(direction, across)};
}

/// Offsets from a disc's centre of a square lattice that has one point or four around it, lattice
/// steps.
constexpr std::array<glm::vec2, 2> even_offsets{{{0, 0}, {0.5f, 0.5f}}};

/// The offset of one that has two. Small discs may need it: a lattice that is strained by more than
/// a tenth to fit the disc is too dense by itself.
constexpr glm::vec2 uneven_offset{0.5f, 0};
constexpr double most_strain = 0.08;

/// Fills a disc with a square lattice. The number of points is the one whose distance comes nearest
/// to the spacing when all have the same share of the area.
OpeningPoints fill(const Disc& disc, float spacing) {
  struct Place {
    glm::vec2 at;   ///< from the centre, lattice steps
    float squared;  ///< distance from the centre, squared
  };
  const double area = std::numbers::pi * disc.radius * disc.radius;
  const int reach = static_cast<int>(std::ceil(disc.radius / spacing)) + 2;
  std::vector<Place> best;
  double best_step = 0;
  const auto misfit = [&](double step) { return std::abs(std::log(step / spacing)); };
  const auto try_lattice = [&](const glm::vec2& offset) {
    std::vector<Place> places;
    for (int j = -reach; j <= reach; ++j)
      for (int i = -reach; i <= reach; ++i) {
        const glm::vec2 at = glm::vec2(i, j) + offset;
        places.push_back({at, glm::dot(at, at)});
      }
    std::stable_sort(places.begin(), places.end(),
                     [](const Place& a, const Place& b) { return a.squared < b.squared; });
    for (std::size_t n = 1; n < places.size(); ++n) {
      const double step = std::sqrt(area / static_cast<double>(n));
      if (places[n].squared > places[n - 1].squared &&
          (best.empty() || misfit(step) < misfit(best_step))) {
        best.assign(places.begin(), places.begin() + static_cast<std::ptrdiff_t>(n));
        best_step = step;
      }
    }
  };
  for (const glm::vec2& offset : even_offsets)
    try_lattice(offset);
  if (misfit(best_step) > most_strain)
    try_lattice(uneven_offset);
  const glm::vec3 direction = glm::normalize(disc.direction);
  const bool upright = std::abs(direction.y) > 0.9f;
  const Frame2 frame = frame_of(direction, upright ? glm::vec3(1, 0, 0) : glm::vec3(0, 1, 0));
  OpeningPoints filled;
  const auto step = static_cast<float>(best_step);
  for (const Place& p : best)
    filled.points.push_back(disc.center + step * (p.at.x * frame.across + p.at.y * frame.up));
  filled.layer_distance =
      static_cast<float>(std::pow(double{spacing}, 3) / (best_step * best_step));
  return filled;
}

/// Fills a rectangle with a lattice of whole rows and columns.
OpeningPoints fill(const Rectangle& r, float spacing) {
  const double width = double{r.width} / spacing, height = double{r.height} / spacing;
  int columns = 1, rows = 1;
  double least = INFINITY;
  // Of the four ways to round the two numbers, take the one that deforms the lattice least.
  for (const double n : {std::floor(width), std::ceil(width)})
    for (const double m : {std::floor(height), std::ceil(height)}) {
      if (n < 1 || m < 1)
        continue;
      const double a = std::log(width / n), b = std::log(height / m);
      const double strain = a * a + b * b + (a + b) * (a + b);
      if (strain < least) {
        least = strain;
        columns = static_cast<int>(n);
        rows = static_cast<int>(m);
      }
    }
  const Frame2 frame = frame_of(glm::normalize(r.direction), r.up);
  const float dx = r.width / static_cast<float>(columns), dy = r.height / static_cast<float>(rows);
  OpeningPoints filled;
  for (int j = 0; j < rows; ++j)
    for (int i = 0; i < columns; ++i)
      filled.points.push_back(
          r.center +
          dx * (static_cast<float>(i) + 0.5f * static_cast<float>(1 - columns)) * frame.across +
          dy * (static_cast<float>(j) + 0.5f * static_cast<float>(1 - rows)) * frame.up);
  filled.layer_distance = spacing * spacing / dx * spacing / dy;
  return filled;
}

/// The number of k in [0, most) for which `done(k)` is true. These are all k below some number, and
/// `guess` is near that number.
template <class Done>
std::int64_t count_done(double guess, std::int64_t most, Done done) {
  auto k = static_cast<std::int64_t>(std::clamp(guess, 0., static_cast<double>(most)));
  while (k < most && done(k))
    ++k;
  while (k > 0 && !done(k - 1))
    --k;
  return k;
}

double area(const Disc& disc) {
  return std::numbers::pi * std::pow(double{disc.radius}, 2);
}
double area(const Rectangle& rectangle) {
  return double{rectangle.width} * rectangle.height;
}

}  // namespace

double opening_area(const Opening& opening) {
  return std::visit([](const auto& one) { return area(one); }, opening);
}

OpeningPoints fill_opening(const Opening& opening, float spacing) {
  return std::visit([&](const auto& one) { return fill(one, spacing); }, opening);
}

glm::vec3 direction_of(const Opening& opening) {
  return std::visit([](const auto& one) { return glm::normalize(one.direction); }, opening);
}

Nozzle::Nozzle(const Emitter& emitter, float spacing)
    : begin_(std::round(1e6 * double{emitter.from}) / 1e6),  // makes 0.1f exactly 0.1 s
      speed_(emitter.speed),
      reach_(0.75f * spacing),
      direction_(direction_of(emitter.opening)),
      velocity_(emitter.speed * direction_) {
  const OpeningPoints filled = fill_opening(emitter.opening, spacing);
  points_ = filled.points;
  distance_ = filled.layer_distance;
  const double pushed = (double{emitter.to} - emitter.from) * emitter.speed;
  layer_count_ = std::max<std::int64_t>(0, std::llround(pushed / distance_));
  if (emitter.max_particles > 0)
    layer_count_ = std::min<std::int64_t>(layer_count_, emitter.max_particles / layer_size());
}

double Nozzle::release_time(std::int64_t k) const {
  return begin_ + (static_cast<double>(k) + 0.5) * distance_ / speed_;
}

double Nozzle::entry_time(std::int64_t k) const {
  return std::max(begin_, begin_ + (static_cast<double>(k) + 0.5 - depth) * distance_ / speed_);
}

std::int64_t Nozzle::entered(double time) const {
  return count_done((time - begin_) * speed_ / distance_ + depth, layer_count_,
                    [&](std::int64_t k) { return entry_time(k) <= time; });
}

std::int64_t Nozzle::entered_before(double time) const {
  return count_done((time - begin_) * speed_ / distance_ + depth, layer_count_,
                    [&](std::int64_t k) { return entry_time(k) < time; });
}

std::int64_t Nozzle::released(double time) const {
  return count_done((time - begin_) * speed_ / distance_, layer_count_,
                    [&](std::int64_t k) { return release_time(k) <= time; });
}

glm::vec3 Nozzle::position(std::int64_t k, std::uint32_t point, double time) const {
  return pushed(points_[point], direction_, way(k, time));
}

double Nozzle::closed_part(double time) const {
  constexpr double layers = 10;  // as many would come out while the wall closes
  if (layer_count_ == 0 || time < begin_)
    return 1;
  const double since = (time - release_time(layer_count_)) * speed_ / distance_;
  return std::clamp(since / layers, 0., 1.);
}

bool Nozzle::is_in_the_way(const glm::vec3& p) const {
  return std::any_of(points_.begin(), points_.end(), [&](const glm::vec3& at) {
    const float along = glm::dot(p - at, direction_);
    return along < 0.25f * reach_ && along > -(depth + 1) * static_cast<float>(distance_) &&
           glm::length(p - at - along * direction_) < reach_;
  });
}

/// @param first how far behind the opening the first layer is, layer distances
double Nozzle::kernel_sum_with(const glm::vec3& p, const CubicKernel& kernel, double first) const {
  double sum = 0;
  for (int layer = 0; layer < depth; ++layer) {
    const auto behind = static_cast<float>((layer + first) * distance_);
    for (const glm::vec3& point : points_)
      sum += kernel.value(glm::distance(p, point - behind * direction_));
  }
  return sum;
}

double Nozzle::kernel_sum(const glm::vec3& p, const CubicKernel& kernel) const {
  constexpr int moments = 8;
  double largest = 0;
  for (int moment = 0; moment < moments; ++moment)
    largest = std::max(largest, kernel_sum_with(p, kernel, static_cast<double>(moment) / moments));
  return largest;
}

double Nozzle::kernel_sum_at_begin(const glm::vec3& p, const CubicKernel& kernel) const {
  return kernel_sum_with(p, kernel, 0.5);
}

std::pair<glm::vec3, float> Nozzle::opening_ball() const {
  const glm::vec3 center = std::accumulate(points_.begin(), points_.end(), glm::vec3(0)) /
                           static_cast<float>(points_.size());
  float radius = 0;
  for (const glm::vec3& point : points_)
    radius = std::max(radius, glm::distance(center, point));
  return {center, radius};
}

std::pair<glm::vec3, glm::vec3> Nozzle::axes_across() const {
  const bool upright = std::abs(direction_.y) > 0.9f;
  const Frame2 frame = frame_of(direction_, upright ? glm::vec3(1, 0, 0) : glm::vec3(0, 1, 0));
  return {frame.across, frame.up};
}

float Nozzle::speed_within(double begin, double end) const {
  return end >= begin_ && layer_count_ > 0 && begin < release_time(layer_count_ - 1)
             ? static_cast<float>(speed_)
             : 0.f;
}

Box Nozzle::bounds() const {
  Box box{points_[0], points_[0]};
  for (const glm::vec3& p : points_)
    for (const glm::vec3& q : {p, p - depth * static_cast<float>(distance_) * direction_}) {
      box.min = glm::min(box.min, q);
      box.max = glm::max(box.max, q);
    }
  return box;
}

}  // namespace spindrift::sim
