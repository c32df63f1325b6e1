#include "render/surface/marching_cubes.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <memory>

#include "render/surface/cube_cases.hpp"

namespace spindrift::surface {
namespace {

// Depth below the surface at which `IsoSurface::bulk` is sampled, in particle spacings.
constexpr double bulk_depth = 2.0;

// The field at a block's nodes and at the neighbouring nodes that its surface needs: nodes -1 ... 9
// along each axis, for the gradients at nodes 0 ... 8, which are the corners of the block's cells.
class Apron {
 public:
  static constexpr int edge = block_edge + 3;

  Apron(const SparseField& field, const SparseField::Around& around) {
    std::array<const float*, 27> blocks;
    for (int i = 0; i < 27; ++i)
      blocks[i] = field.values(around[i]);
    float* out = values_.data();
    for (int z = -1; z <= block_edge + 1; ++z) {
      for (int y = -1; y <= block_edge + 1; ++y) {
        const float* const* const row = &blocks[3 * ((y >> 3) + 1) + 9 * ((z >> 3) + 1)];
        const int first = block_edge * ((y & 7) + block_edge * (z & 7));
        out[0] = row[0][first + 7];
        std::copy_n(row[1] + first, block_edge, out + 1);
        out[block_edge + 1] = row[2][first];
        out[block_edge + 2] = row[2][first + 1];
        out += edge;
      }
    }
  }

  // Returns which of the nodes 0 ... 8 of a row along x lie inside: bit x is set if node x does.
  unsigned inside_nodes(int y, int z, float iso_value) const {
    const float* const row = &values_[1 + edge * ((y + 1) + edge * (z + 1))];
    unsigned bits = unsigned(row[block_edge] > iso_value) << block_edge;
#pragma omp simd reduction(| : bits)
    for (int x = 0; x < block_edge; ++x)
      bits |= unsigned(row[x] > iso_value) << x;
    return bits;
  }

  float at(const glm::ivec3& node) const {
    return values_[(node.x + 1) + edge * ((node.y + 1) + edge * (node.z + 1))];
  }

  glm::vec3 gradient(const glm::ivec3& n) const {
    return {at({n.x + 1, n.y, n.z}) - at({n.x - 1, n.y, n.z}),
            at({n.x, n.y + 1, n.z}) - at({n.x, n.y - 1, n.z}),
            at({n.x, n.y, n.z + 1}) - at({n.x, n.y, n.z - 1})};
  }

 private:
  std::array<float, edge * edge * edge> values_;
};

// A grid edge as seen from a block: its lower node, which may lie in a following block, and its
// axis.
struct GridEdge {
  std::uint8_t x, y, z, axis;
};

// The part of the mesh in one block, before its vertices have their numbers in the whole mesh.
struct BlockSurface {
  struct Vertex {
    glm::vec3 position, normal;
    float bulk;
  };
  std::vector<Vertex> vertices;
  std::vector<std::array<GridEdge, 3>> triangles;
  SparseField::Around around;
  // The number in this block of the vertex on each grid edge; set for crossed edges only.
  std::array<std::uint16_t, 3 * block_nodes> vertex_on_edge;

  static int edge_index(int node, int axis) { return 3 * node + axis; }
};

constexpr int node_index(int x, int y, int z) {
  return x + block_edge * (y + block_edge * z);
}

// Returns the index in SparseField::Around of the i-th of the eight blocks that hold the corners of
// a block's cells; number 0 is the block itself.
constexpr int following(int i) {
  return 13 + (i & 1) + 3 * ((i >> 1) & 1) + 9 * (i >> 2);
}

// Returns whether the surface may cross one of the block's cells, whose corners lie in this block
// and in the seven that follow it.
bool may_be_crossed(const SparseField& field, const SparseField::Around& around) {
  const BlockSide side = field.side(around[following(0)]);
  if (side == BlockSide::both)
    return true;
  for (int i = 1; i < 8; ++i)
    if (field.side(around[following(i)]) != side)
      return true;
  return false;
}

// Marches the cells of one block.
class BlockMarcher {
 public:
  BlockMarcher(const SparseField& field, const SparseField::Around& around, float iso_value,
               float spacing)
      : field_(field),
        around_(around),
        iso_value_(iso_value),
        spacing_(spacing),
        values_(field, around) {}

  void march(BlockSurface& out) const {
    std::array<std::array<unsigned, block_edge + 1>, block_edge + 1> inside;
    for (int z = 0; z <= block_edge; ++z)
      for (int y = 0; y <= block_edge; ++y)
        inside[z][y] = values_.inside_nodes(y, z, iso_value_);
    for (int z = 0; z < block_edge; ++z)
      for (int y = 0; y < block_edge; ++y)
        march_row(y, z, {inside[z][y], inside[z][y + 1], inside[z + 1][y], inside[z + 1][y + 1]},
                  out);
  }

 private:
  // Marches the cells of a row along x. Their corners lie in four rows of nodes, for which `inside`
  // holds the results of Apron::inside_nodes().
  void march_row(int y, int z, const std::array<unsigned, 4>& inside, BlockSurface& out) const {
    const unsigned any = inside[0] | inside[1] | inside[2] | inside[3];
    const unsigned all = inside[0] & inside[1] & inside[2] & inside[3];
    const unsigned crossed = (any | any >> 1) & ~(all & all >> 1) & ((1u << block_edge) - 1);
    for (unsigned left = crossed; left != 0; left &= left - 1) {
      const int x = std::countr_zero(left);
      int corners = 0;
      for (int row = 0; row < 4; ++row)
        corners |= int(inside[row] >> x & 3u) << (2 * row);
      add_vertices({x, y, z}, corners, out);
      add_triangles({x, y, z}, corners, out);
    }
  }

  // Adds the vertices on those of the three grid edges starting at this node that are crossed.
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
    // The vertex keeps off the nodes, so that the vertices around a node stay apart.
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
    const glm::dvec3 first = glm::dvec3(field_.cell(around_[following(0)]) * block_edge);
    const float depth = float(bulk_depth / field_.cell_size());
    out.vertices.push_back({glm::vec3((first + glm::dvec3(point)) * cell_size), outward,
                            field_.sample(around_, point - outward * depth)});
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
  const SparseField::Around& around_;
  float iso_value_;
  float spacing_;
  Apron values_;
};

// One part of the mesh per block, null where there is no surface.
using BlockSurfaces = std::vector<std::unique_ptr<BlockSurface>>;

BlockSurfaces march_blocks(const SparseField& field, float iso_value, float spacing) {
  BlockSurfaces blocks(field.block_count());
#pragma omp parallel for schedule(dynamic, 4)
  for (std::size_t b = 0; b < blocks.size(); ++b) {
    const SparseField::Around around = field.around(std::uint32_t(b));
    if (!may_be_crossed(field, around))
      continue;
    blocks[b] = std::make_unique_for_overwrite<BlockSurface>();
    blocks[b]->around = around;
    BlockMarcher(field, around, iso_value, spacing).march(*blocks[b]);
  }
  return blocks;
}

// Returns the number in the whole mesh of the vertex on a grid edge that a block's triangle refers
// to.
std::uint32_t vertex_number(const GridEdge& edge, const SparseField::Around& around,
                            const BlockSurfaces& blocks,
                            const std::vector<std::uint32_t>& first_vertex) {
  const std::uint32_t owner =
      around[following((edge.x >> 3) | (edge.y >> 3) << 1 | (edge.z >> 3) << 2)];
  const int node = node_index(edge.x & 7, edge.y & 7, edge.z & 7);
  return first_vertex[owner] +
         blocks[owner]->vertex_on_edge[BlockSurface::edge_index(node, edge.axis)];
}

IsoSurface join(const BlockSurfaces& blocks) {
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
    std::size_t v = first_vertex[b];
    for (const BlockSurface::Vertex& vertex : block.vertices) {
      result.mesh.vertices[v] = vertex.position;
      result.mesh.normals[v] = vertex.normal;
      result.bulk[v] = vertex.bulk;
      ++v;
    }
    std::size_t t = first_triangle[b];
    for (const std::array<GridEdge, 3>& triangle : block.triangles) {
      glm::uvec3& corners = result.mesh.triangles[t++];
      for (int k = 0; k < 3; ++k)
        corners[k] = vertex_number(triangle[k], block.around, blocks, first_vertex);
    }
  }
  return result;
}

}  // namespace

IsoSurface march_cubes(const SparseField& field, float iso_value, float spacing) {
  return join(march_blocks(field, iso_value, spacing));
}

}  // namespace spindrift::surface
