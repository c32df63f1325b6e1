#include "render/surface/sparse_field.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>

#include "render/surface/kernel.hpp"

namespace spindrift::surface {
namespace {

using BlockValues = std::array<float, block_nodes>;

constexpr BlockValues all_nodes(float value) {
  BlockValues values{};
  values.fill(value);
  return values;
}

// Values of the blocks that keep none of their own: 0 outside the liquid, 1 deep inside it.
constexpr BlockValues all_zero = all_nodes(0.0f);
constexpr BlockValues all_one = all_nodes(1.0f);

// Adds one particle's kernel to a block; the particle's position is relative to the block's first
// node. Lengths are in spacings. All rows of nodes in the kernel's bounding box are done: to find
// out which of them miss the kernel's ball would take longer.
void splat(const glm::vec3& position, const ParticleKernel& kernel, float cell_size,
           float cells_per_spacing, BlockValues& values) {
  static_assert(block_edge == lane_count<float>);
  const float scale = 1.0f / kernel.radius;
  const glm::vec3 p = position * scale;
  const float cell = cell_size * scale;
  const glm::ivec3 first(glm::max(glm::ceil((position - kernel.radius) * cells_per_spacing), 0.0f));
  const glm::ivec3 last(
      glm::min(glm::floor((position + kernel.radius) * cells_per_spacing), float(block_edge - 1)));
  const Lanes nodes = Lanes{0, 1, 2, 3, 4, 5, 6, 7} * cell;
  const Lanes dx2 = (nodes - p.x) * (nodes - p.x);
  const Lanes dy2 = (nodes - p.y) * (nodes - p.y);
  const Lanes dz2 = (nodes - p.z) * (nodes - p.z);
  for (int k = first.z; k <= last.z; ++k) {
    const Lanes left = (1.0f - dz2[k]) - dx2;
    float* row = &values[(k * block_edge + first.y) * block_edge];
    for (int j = first.y; j <= last.y; ++j, row += block_edge) {
      Lanes sum;
      std::memcpy(&sum, row, sizeof sum);
      sum += kernel.amplitude * kernel_shape(left - dy2[j]);
      std::memcpy(row, &sum, sizeof sum);
    }
  }
}

// Returns the squared distance of a point from the cube [0, edge]^3.
float squared_distance_to_cube(const glm::vec3& p, float edge) {
  const glm::vec3 d = p - glm::clamp(p, 0.0f, edge);
  return glm::dot(d, d);
}

BlockSide side_of(const BlockValues& values, float iso_value) {
  int inside = 0;
  for (const float v : values)
    inside += v > iso_value;
  if (inside == 0)
    return BlockSide::outside;
  return inside == block_nodes ? BlockSide::inside : BlockSide::both;
}

// The box of bins whose particles can reach a block's nodes, both ends included.
struct BinRange {
  glm::ivec3 lo, hi;

  BinRange(const glm::ivec3& block_cell, double cell_size, double bin_size) {
    const glm::dvec3 first = glm::dvec3(block_cell) * (block_edge * cell_size);
    const double reach = bin_size * 1.0001;  // a margin for rounding
    lo = glm::ivec3(glm::floor((first - reach) / bin_size));
    hi = glm::ivec3(glm::floor((first + (block_edge - 1) * cell_size + reach) / bin_size));
  }

  // Returns whether all bins of the box are enclosed: then the block lies deep in the liquid, and
  // its field need not be summed.
  bool enclosed(const ParticleBins& bins, const Coverage& coverage) const {
    const glm::ivec3 extent = hi - lo + 1;
    int count = 0;
    bins.for_each_bin(lo, hi, [&](std::size_t b) { count += coverage.enclosed[b]; });
    return count == extent.x * extent.y * extent.z;
  }
};

// Returns the field at the nodes of a block.
BlockValues sum_kernels(const ParticleBins& bins, const Coverage& coverage,
                        const glm::ivec3& block_cell, double cell_size) {
  const glm::dvec3 origin = glm::dvec3(block_cell) * (block_edge * cell_size);
  const float block_size = float((block_edge - 1) * cell_size);
  const BinRange range(block_cell, cell_size, bins.bin_size());
  const float cells_per_spacing = float(1.0 / cell_size);
  BlockValues values{};
  bins.for_each_bin(range.lo, range.hi, [&](std::size_t bin) {
    const glm::vec3 shift = bins.shift(bin, origin);
    for (std::size_t k = bins.begin(bin); k < bins.end(bin); ++k) {
      const glm::vec3 p = bins.local(k) + shift;
      const ParticleKernel& kernel = coverage.kernels[k];
      if (squared_distance_to_cube(p, block_size) < kernel.radius * kernel.radius)
        splat(p, kernel, float(cell_size), cells_per_spacing, values);
    }
  });
  return values;
}

}  // namespace

SparseField::SparseField(const ParticleBins& bins, const Coverage& coverage, double cell_size,
                         float iso_value)
    : cell_size_(cell_size) {
  find_blocks(bins);
  fill_blocks(bins, coverage, iso_value);
}

// Keeps the blocks that hold a node which some particle reaches, or the lower corner of a cell with
// such a node, so that every cell the surface crosses belongs to a block.
void SparseField::find_blocks(const ParticleBins& bins) {
  const double support = bins.bin_size() * 1.0001;  // a margin for rounding
  const double block_size = block_edge * cell_size_;
  std::vector<glm::ivec3> lows(bins.bin_count()), highs(bins.bin_count());
  glm::ivec3 lowest(INT32_MAX);
  for (std::size_t bin = 0; bin < bins.bin_count(); ++bin) {
    glm::vec3 lo = bins.local(bins.begin(bin));
    glm::vec3 hi = lo;
    for (std::size_t k = bins.begin(bin) + 1; k < bins.end(bin); ++k) {
      lo = glm::min(lo, bins.local(k));
      hi = glm::max(hi, bins.local(k));
    }
    const glm::dvec3 origin = glm::dvec3(bins.cell(bin)) * bins.bin_size();
    lows[bin] =
        glm::ivec3(glm::floor((origin + glm::dvec3(lo) - support - cell_size_) / block_size));
    highs[bin] = glm::ivec3(glm::floor((origin + glm::dvec3(hi) + support) / block_size));
    lowest = glm::min(lowest, lows[bin]);
  }
  std::vector<KeyedIndex> found;
  for (std::size_t bin = 0; bin < bins.bin_count(); ++bin)
    for (int z = lows[bin].z; z <= highs[bin].z; ++z)
      for (int y = lows[bin].y; y <= highs[bin].y; ++y)
        for (int x = lows[bin].x; x <= highs[bin].x; ++x)
          found.push_back({grid_key(glm::ivec3(x, y, z) - lowest), 0});
  sort_by_key(found);
  lower_ = lowest;
  for (const KeyedIndex& item : found)
    if (keys_.empty() || keys_.back() != item.key)
      keys_.push_back(item.key);
}

void SparseField::fill_blocks(const ParticleBins& bins, const Coverage& coverage, float iso_value) {
  sides_.resize(keys_.size());
  slots_.resize(keys_.size());
#pragma omp parallel for schedule(dynamic, 16)
  for (std::size_t b = 0; b < keys_.size(); ++b) {
    const bool inside = BinRange(cell(b), cell_size_, bins.bin_size()).enclosed(bins, coverage);
    sides_[b] = inside ? BlockSide::inside : BlockSide::both;
  }
  std::uint32_t sampled = 0;
  for (std::size_t b = 0; b < keys_.size(); ++b)
    slots_[b] = sides_[b] == BlockSide::inside ? no_block : sampled++;
  values_ = std::make_unique_for_overwrite<float[]>(std::size_t(sampled) * block_nodes);

#pragma omp parallel for schedule(dynamic, 4)
  for (std::size_t b = 0; b < keys_.size(); ++b) {
    if (slots_[b] == no_block)
      continue;
    const BlockValues values = sum_kernels(bins, coverage, cell(b), cell_size_);
    sides_[b] = side_of(values, iso_value);
    std::copy(values.begin(), values.end(), &values_[std::size_t(slots_[b]) * block_nodes]);
  }
}

const float* SparseField::values(std::uint32_t block) const {
  if (block == no_block)
    return all_zero.data();
  const std::uint32_t slot = slots_[block];
  return slot == no_block ? all_one.data() : &values_[std::size_t(slot) * block_nodes];
}

std::uint32_t SparseField::find(const glm::ivec3& block_cell) const {
  const glm::ivec3 c = block_cell - lower_;
  constexpr int end = 1 << axis_bits;
  if (c.x < 0 || c.y < 0 || c.z < 0 || c.x >= end || c.y >= end || c.z >= end)
    return no_block;
  const std::uint64_t key = grid_key(c);
  const auto it = std::lower_bound(keys_.begin(), keys_.end(), key);
  return it != keys_.end() && *it == key ? std::uint32_t(it - keys_.begin()) : no_block;
}

SparseField::Around SparseField::around(std::uint32_t block) const {
  const glm::ivec3 center = cell(block);
  Around result;
  for (int row = 0; row < 9; ++row) {
    const glm::ivec3 first = center + glm::ivec3(-1, row % 3 - 1, row / 3 - 1);
    // Blocks that follow each other along x follow each other in memory.
    std::uint32_t next = no_block;
    for (int i = 0; i < 3; ++i) {
      const glm::ivec3 c = first + glm::ivec3(i, 0, 0);
      if (next == no_block)
        next = find(c);
      const bool found = next < keys_.size() && cell(next) == c;
      result[3 * row + i] = found ? next : no_block;
      next = found ? next + 1 : no_block;
    }
  }
  return result;
}

float SparseField::sample(const Around& near, const glm::vec3& point) const {
  const glm::vec3 base = glm::floor(point);
  const glm::vec3 f = point - base;
  const glm::ivec3 first(base);
  float sum = 0.0f;
  for (int corner = 0; corner < 8; ++corner) {
    const glm::ivec3 step(corner & 1, (corner >> 1) & 1, corner >> 2);
    const glm::ivec3 node = first + step;
    const glm::ivec3 offset = node >> 3;
    const glm::ivec3 in_block = node & 7;
    const bool is_near = glm::all(glm::lessThanEqual(glm::abs(offset), glm::ivec3(1)));
    const std::uint32_t block =
        is_near ? near[13 + offset.x + 3 * offset.y + 9 * offset.z] : find(cell(near[13]) + offset);
    const glm::vec3 w = glm::mix(1.0f - f, f, glm::vec3(step));
    sum += w.x * w.y * w.z *
           value(block, in_block.x + block_edge * (in_block.y + block_edge * in_block.z));
  }
  return sum;
}

}  // namespace spindrift::surface
