#include "render/surface/sparse_field.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace spindrift::surface {
namespace {

using BlockValues = std::array<float, kBlockNodes>;

// Adds one particle's kernel to a block; the particle's position is relative to the block's first
// node. Lengths are in spacings.
void splat(const glm::vec3& position, const ParticleKernel& kernel, float cell_size,
           BlockValues& values) {
  const glm::vec3 p = position / kernel.radius;
  const float cell = cell_size / kernel.radius;
  std::array<float, kBlockEdge> dx2;
  for (int i = 0; i < kBlockEdge; ++i) {
    const float dx = float(i) * cell - p.x;
    dx2[i] = dx * dx;
  }
  for (int k = 0; k < kBlockEdge; ++k) {
    const float dz = float(k) * cell - p.z;
    const float left_z = 1.0f - dz * dz;
    if (left_z <= 0.0f)
      continue;
    for (int j = 0; j < kBlockEdge; ++j) {
      const float dy = float(j) * cell - p.y;
      const float left = left_z - dy * dy;
      if (left <= 0.0f)
        continue;
      float* const row = &values[(k * kBlockEdge + j) * kBlockEdge];
#pragma omp simd
      for (int i = 0; i < kBlockEdge; ++i) {
        row[i] += kernel.amplitude * kernel_shape(left - dx2[i]);
      }
    }
  }
}

// Squared distance of a point from the cube [0, edge]^3.
float squared_distance_to_cube(const glm::vec3& p, float edge) {
  const glm::vec3 d = p - glm::clamp(p, 0.0f, edge);
  return glm::dot(d, d);
}

BlockSide side_of(const BlockValues& values, float iso_value) {
  int inside = 0;
  for (const float v : values)
    inside += v > iso_value;
  if (inside == 0)
    return BlockSide::kOutside;
  return inside == kBlockNodes ? BlockSide::kInside : BlockSide::kBoth;
}

// The bins whose particles can reach a block's nodes, and whether the block needs them at all.
struct BinRange {
  glm::ivec3 lo, hi;

  BinRange(const glm::ivec3& block_cell, double cell_size, double bin_size) {
    const glm::dvec3 first = glm::dvec3(block_cell) * (kBlockEdge * cell_size);
    const double reach = bin_size * 1.0001;  // a margin for rounding
    lo = glm::ivec3(glm::floor((first - reach) / bin_size));
    hi = glm::ivec3(glm::floor((first + (kBlockEdge - 1) * cell_size + reach) / bin_size));
  }

  bool enclosed(const ParticleBins& bins, const Coverage& coverage) const {
    const glm::ivec3 extent = hi - lo + 1;
    int count = 0;
    bins.for_each_bin(lo, hi, [&](std::size_t b) { count += coverage.enclosed[b]; });
    return count == extent.x * extent.y * extent.z;
  }
};

}  // namespace

SparseField::SparseField(const ParticleBins& bins, const Coverage& coverage, double cell_size,
                         float iso_value)
    : cell_size_(cell_size) {
  find_blocks(bins);
  fill_blocks(bins, coverage, iso_value);
}

// Blocks that hold a node which some particle reaches, or the lower corner of a cell with such a
// node, so that every cell the surface crosses belongs to a block.
void SparseField::find_blocks(const ParticleBins& bins) {
  const double support = bins.bin_size() * 1.0001;  // a margin for rounding
  const double block_size = kBlockEdge * cell_size_;
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
    sides_[b] = inside ? BlockSide::kInside : BlockSide::kBoth;
  }
  std::uint32_t sampled = 0;
  for (std::size_t b = 0; b < keys_.size(); ++b)
    slots_[b] = sides_[b] == BlockSide::kInside ? kNoBlock : sampled++;
  values_.resize(std::size_t(sampled) * kBlockNodes);

  const float cell_size = float(cell_size_);
  const float block_size = float(kBlockEdge - 1) * cell_size;
#pragma omp parallel
  {
    ParticleBatch batch;
    BlockValues values;
#pragma omp for schedule(dynamic, 4)
    for (std::size_t b = 0; b < keys_.size(); ++b) {
      if (slots_[b] == kNoBlock)
        continue;
      const glm::dvec3 origin = glm::dvec3(cell(b)) * (kBlockEdge * cell_size_);
      const BinRange range(cell(b), cell_size_, bins.bin_size());
      batch.clear();
      bins.for_each_bin(range.lo, range.hi,
                        [&](std::size_t bin) { bins.append(bin, origin, batch); });
      values.fill(0.0f);
      for (std::size_t k = 0; k < batch.size(); ++k) {
        const glm::vec3 p(batch.x[k], batch.y[k], batch.z[k]);
        const ParticleKernel& kernel = coverage.kernels[batch.particle[k]];
        if (squared_distance_to_cube(p, block_size) < kernel.radius * kernel.radius)
          splat(p, kernel, cell_size, values);
      }
      sides_[b] = side_of(values, iso_value);
      std::copy(values.begin(), values.end(),
                values_.begin() + std::size_t(slots_[b]) * kBlockNodes);
    }
  }
}

std::uint32_t SparseField::find(const glm::ivec3& block_cell) const {
  const glm::ivec3 c = block_cell - lower_;
  constexpr int end = 1 << kAxisBits;
  if (c.x < 0 || c.y < 0 || c.z < 0 || c.x >= end || c.y >= end || c.z >= end)
    return kNoBlock;
  const std::uint64_t key = grid_key(c);
  const auto it = std::lower_bound(keys_.begin(), keys_.end(), key);
  return it != keys_.end() && *it == key ? std::uint32_t(it - keys_.begin()) : kNoBlock;
}

float SparseField::sample(std::uint32_t block, const glm::vec3& point) const {
  const glm::vec3 base = glm::floor(point);
  const glm::vec3 f = point - base;
  const glm::ivec3 first(base);
  glm::ivec3 near(0);
  std::uint32_t near_block = block;
  float sum = 0.0f;
  for (int corner = 0; corner < 8; ++corner) {
    const glm::ivec3 step(corner & 1, (corner >> 1) & 1, corner >> 2);
    const glm::ivec3 node = first + step;
    const glm::ivec3 offset = node >> 3;
    const glm::ivec3 in_block = node & 7;
    if (offset != near) {
      near = offset;
      near_block = find(cell(block) + offset);
    }
    const glm::vec3 w = glm::mix(1.0f - f, f, glm::vec3(step));
    sum += w.x * w.y * w.z *
           value(near_block, in_block.x + kBlockEdge * (in_block.y + kBlockEdge * in_block.z));
  }
  return sum;
}

}  // namespace spindrift::surface
