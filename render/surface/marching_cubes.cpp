#include "render/surface/marching_cubes.hpp"

#include <algorithm>
#include <array>
#include <memory>

#include "render/surface/cube_cases.hpp"

namespace spindrift::surface {
namespace {

// How far below the surface `IsoSurface::bulk` is sampled, in spacings.
constexpr double kBulkDepth = 2.0;

// A block's nodes with the neighbours that its surface needs: nodes -1 ... 9 along each axis, for
// the gradients at nodes 0 ... 8, which are the corners of the block's cells.
class Apron {
 public:
  static constexpr int kEdge = kBlockEdge + 3;

  Apron(const SparseField& field, const std::array<std::uint32_t, 27>& around) {
    float* out = values_.data();
    for (int z = -1; z <= kBlockEdge + 1; ++z) {
      for (int y = -1; y <= kBlockEdge + 1; ++y) {
        const int row = 3 * ((y >> 3) + 1) + 9 * ((z >> 3) + 1);
        const int first = kBlockEdge * ((y & 7) + kBlockEdge * (z & 7));
        *out++ = field.value(around[row], first + 7);
        for (int x = 0; x < kBlockEdge; ++x)
          *out++ = field.value(around[row + 1], first + x);
        *out++ = field.value(around[row + 2], first);
        *out++ = field.value(around[row + 2], first + 1);
      }
    }
  }

  float at(const glm::ivec3& node) const {
    return values_[(node.x + 1) + kEdge * ((node.y + 1) + kEdge * (node.z + 1))];
  }

  glm::vec3 gradient(const glm::ivec3& n) const {
    return {at({n.x + 1, n.y, n.z}) - at({n.x - 1, n.y, n.z}),
            at({n.x, n.y + 1, n.z}) - at({n.x, n.y - 1, n.z}),
            at({n.x, n.y, n.z + 1}) - at({n.x, n.y, n.z - 1})};
  }

 private:
  std::array<float, kEdge * kEdge * kEdge> values_;
};

// A grid edge seen from a block: its lower node, which may lie in a block beyond, and its axis.
struct GridEdge {
  std::uint8_t x, y, z, axis;
};

// What one block adds to the mesh, before its vertices have their final numbers.
struct BlockSurface {
  std::vector<glm::vec3> vertices, normals;
  std::vector<float> bulk;
  std::vector<std::array<GridEdge, 3>> triangles;
  std::array<std::uint16_t, 3 * kBlockNodes> vertex_on_edge;  // set for crossed edges only

  static int edge_index(int node, int axis) { return 3 * node + axis; }
};

constexpr int node_index(int x, int y, int z) {
  return x + kBlockEdge * (y + kBlockEdge * z);
}

std::array<std::uint32_t, 27> blocks_around(const SparseField& field, std::uint32_t block) {
  const glm::ivec3 center = field.cell(block);
  std::array<std::uint32_t, 27> around;
  for (int i = 0; i < 27; ++i)
    around[i] = i == 13 ? block : field.find(center + glm::ivec3(i % 3, i / 3 % 3, i / 9) - 1);
  return around;
}

// Can the surface cross one of the block's cells? Their corners lie in this block and in the seven
// that follow it.
bool may_be_crossed(const SparseField& field, std::uint32_t block) {
  const BlockSide side = field.side(block);
  if (side == BlockSide::kBoth)
    return true;
  const glm::ivec3 cell = field.cell(block);
  for (int i = 1; i < 8; ++i)
    if (field.side(field.find(cell + glm::ivec3(i & 1, (i >> 1) & 1, i >> 2))) != side)
      return true;
  return false;
}

class BlockMarcher {
 public:
  BlockMarcher(const SparseField& field, std::uint32_t block, float iso_value, float spacing)
      : field_(field),
        block_(block),
        iso_value_(iso_value),
        spacing_(spacing),
        values_(field, blocks_around(field, block)) {}

  void march(BlockSurface& out) const {
    for (int z = 0; z < kBlockEdge; ++z)
      for (int y = 0; y < kBlockEdge; ++y)
        for (int x = 0; x < kBlockEdge; ++x) {
          const int corners = inside_corners({x, y, z});
          if (corners == 0 || corners == 255)
            continue;
          add_vertices({x, y, z}, corners, out);
          add_triangles({x, y, z}, corners, out);
        }
  }

 private:
  int inside_corners(const glm::ivec3& node) const {
    int corners = 0;
    for (int c = 0; c < 8; ++c)
      corners |= int(values_.at(node + glm::ivec3(c & 1, (c >> 1) & 1, c >> 2)) > iso_value_) << c;
    return corners;
  }

  // The vertices on the three grid edges that start at this node.
  void add_vertices(const glm::ivec3& node, int corners, BlockSurface& out) const {
    for (int axis = 0; axis < 3; ++axis) {
      const bool here = (corners & 1) != 0;
      const bool there = (corners & (1 << (1 << axis))) != 0;
      if (here == there)
        continue;
      const int edge = BlockSurface::edge_index(node_index(node.x, node.y, node.z), axis);
      out.vertex_on_edge[edge] = std::uint16_t(out.vertices.size());
      add_vertex(node, axis, out);
    }
  }

  void add_vertex(const glm::ivec3& node, int axis, BlockSurface& out) const {
    glm::ivec3 next = node;
    ++next[axis];
    const float a = values_.at(node);
    const float b = values_.at(next);
    // Kept off the nodes, so that the vertices around a node stay apart.
    constexpr float margin = 0.01f;
    const float t = std::clamp((iso_value_ - a) / (b - a), margin, 1.0f - margin);
    glm::vec3 point(node);
    point[axis] += t;

    glm::vec3 outward = -glm::mix(values_.gradient(node), values_.gradient(next), t);
    const float length = glm::length(outward);
    if (length > 1e-6f) {
      outward /= length;
    } else {
      outward = glm::vec3(0.0f);
      outward[axis] = a > b ? 1.0f : -1.0f;
    }

    const double cell_size = field_.cell_size() * double(spacing_);
    const glm::dvec3 first = glm::dvec3(field_.cell(block_) * kBlockEdge);
    out.vertices.push_back(glm::vec3((first + glm::dvec3(point)) * cell_size));
    out.normals.push_back(outward);
    const float depth = float(kBulkDepth / field_.cell_size());
    out.bulk.push_back(field_.sample(block_, point - outward * depth));
  }

  static void add_triangles(const glm::ivec3& node, int corners, BlockSurface& out) {
    const CubeCase& cube = cube_cases()[corners];
    for (int i = 0; i < cube.triangle_count; ++i) {
      std::array<GridEdge, 3> triangle;
      for (int k = 0; k < 3; ++k) {
        const CubeEdge edge = cube_edge(cube.triangles[i][k]);
        triangle[k] = {std::uint8_t(node.x + (edge.corner & 1)),
                       std::uint8_t(node.y + ((edge.corner >> 1) & 1)),
                       std::uint8_t(node.z + (edge.corner >> 2)), std::uint8_t(edge.axis)};
      }
      out.triangles.push_back(triangle);
    }
  }

  const SparseField& field_;
  std::uint32_t block_;
  float iso_value_;
  float spacing_;
  Apron values_;
};

using BlockSurfaces = std::vector<std::unique_ptr<BlockSurface>>;  // null: no surface there

BlockSurfaces march_blocks(const SparseField& field, float iso_value, float spacing) {
  BlockSurfaces blocks(field.block_count());
#pragma omp parallel for schedule(dynamic, 4)
  for (std::size_t b = 0; b < blocks.size(); ++b) {
    if (!may_be_crossed(field, std::uint32_t(b)))
      continue;
    blocks[b] = std::make_unique<BlockSurface>();
    BlockMarcher(field, std::uint32_t(b), iso_value, spacing).march(*blocks[b]);
  }
  return blocks;
}

// The final number of the vertex on a grid edge that a block's triangle refers to.
std::uint32_t vertex_number(const GridEdge& edge, const std::array<std::uint32_t, 8>& following,
                            const BlockSurfaces& blocks,
                            const std::vector<std::uint32_t>& first_vertex) {
  const std::uint32_t owner = following[(edge.x >> 3) | (edge.y >> 3) << 1 | (edge.z >> 3) << 2];
  const int node = node_index(edge.x & 7, edge.y & 7, edge.z & 7);
  return first_vertex[owner] +
         blocks[owner]->vertex_on_edge[BlockSurface::edge_index(node, edge.axis)];
}

IsoSurface join(const SparseField& field, const BlockSurfaces& blocks) {
  std::vector<std::uint32_t> first_vertex(blocks.size());
  std::vector<std::size_t> first_triangle(blocks.size());
  std::uint32_t vertex_count = 0;
  std::size_t triangle_count = 0;
  for (std::size_t b = 0; b < blocks.size(); ++b) {
    first_vertex[b] = vertex_count;
    first_triangle[b] = triangle_count;
    if (!blocks[b])
      continue;
    vertex_count += std::uint32_t(blocks[b]->vertices.size());
    triangle_count += blocks[b]->triangles.size();
  }

  IsoSurface result;
  result.mesh.vertices.resize(vertex_count);
  result.mesh.normals.resize(vertex_count);
  result.bulk.resize(vertex_count);
  result.mesh.triangles.resize(triangle_count);
#pragma omp parallel for schedule(dynamic, 16)
  for (std::size_t b = 0; b < blocks.size(); ++b) {
    if (!blocks[b])
      continue;
    const BlockSurface& block = *blocks[b];
    std::copy(block.vertices.begin(), block.vertices.end(),
              result.mesh.vertices.begin() + first_vertex[b]);
    std::copy(block.normals.begin(), block.normals.end(),
              result.mesh.normals.begin() + first_vertex[b]);
    std::copy(block.bulk.begin(), block.bulk.end(), result.bulk.begin() + first_vertex[b]);

    std::array<std::uint32_t, 8> following;
    const glm::ivec3 cell = field.cell(b);
    for (int i = 0; i < 8; ++i)
      following[i] = field.find(cell + glm::ivec3(i & 1, (i >> 1) & 1, i >> 2));
    std::size_t t = first_triangle[b];
    for (const std::array<GridEdge, 3>& triangle : block.triangles) {
      glm::uvec3& corners = result.mesh.triangles[t++];
      for (int k = 0; k < 3; ++k)
        corners[k] = vertex_number(triangle[k], following, blocks, first_vertex);
    }
  }
  return result;
}

}  // namespace

IsoSurface march_cubes(const SparseField& field, float iso_value, float spacing) {
  return join(field, march_blocks(field, iso_value, spacing));
}

}  // namespace spindrift::surface
