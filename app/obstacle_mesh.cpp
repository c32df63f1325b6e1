#include "app/obstacle_mesh.hpp"

#include <cmath>
#include <numbers>
#include <variant>
#include <vector>

#include "sim/motion.hpp"
#include "sim/shapes.hpp"
#include "sim/shapes/mesh_body.hpp"

namespace spindrift::app {
namespace {

constexpr unsigned around = 64;  // pieces of a full circle

unsigned add_vertex(Mesh& mesh, const glm::vec3& position, const glm::vec3& normal) {
  mesh.vertices.push_back(position);
  mesh.normals.push_back(normal);
  return static_cast<unsigned>(mesh.vertices.size() - 1);
}

/// Two triangles; a, b, c, d run counter-clockwise seen from outside.
void add_quad(Mesh& mesh, unsigned a, unsigned b, unsigned c, unsigned d) {
  mesh.triangles.push_back({a, b, c});
  mesh.triangles.push_back({a, c, d});
}

float angle(unsigned piece) {
  return 2.f * std::numbers::pi_v<float> * static_cast<float>(piece) / static_cast<float>(around);
}

void add(Mesh& mesh, const sim::Box& box) {
  const glm::vec3 center = 0.5f * (box.min + box.max), half = 0.5f * (box.max - box.min);
  for (int axis = 0; axis < 3; ++axis) {
    for (const float side : {-1.f, 1.f}) {
      glm::vec3 normal{0.f}, u{0.f}, v{0.f};
      normal[axis] = side;
      u[(axis + 1) % 3] = side;  // u × v = the outward normal on both sides
      v[(axis + 2) % 3] = 1.f;
      const auto corner = [&](float a, float b) {
        return add_vertex(mesh, center + half * (normal + a * u + b * v), normal);
      };
      const unsigned a = corner(-1.f, -1.f), b = corner(1.f, -1.f), c = corner(1.f, 1.f),
                     d = corner(-1.f, 1.f);
      add_quad(mesh, a, b, c, d);
    }
  }
}

/// A ball that is cut in two at its equator and drawn apart along its axis: one half ball around
/// `top`, one around `bottom`, and the side between them where the two differ. The frame's second
/// column is the axis, from bottom to top.
void add_round(Mesh& mesh, const glm::vec3& bottom, const glm::vec3& top, float radius,
               const glm::mat3& frame) {
  constexpr unsigned rings = around / 2;
  const auto first = static_cast<unsigned>(mesh.vertices.size());
  const auto add_ring = [&](unsigned ring, const glm::vec3& center) {
    const float polar = angle(ring);  // 0 at the top, π at the bottom
    for (unsigned piece = 0; piece <= around; ++piece) {
      const glm::vec3 normal{std::sin(polar) * std::cos(angle(piece)), std::cos(polar),
                             -std::sin(polar) * std::sin(angle(piece))};
      add_vertex(mesh, center + radius * (frame * normal), frame * normal);
    }
  };
  unsigned last = rings;
  for (unsigned ring = 0; ring <= rings; ++ring) {
    add_ring(ring, ring <= rings / 2 ? top : bottom);
    if (ring == rings / 2 && top != bottom) {
      add_ring(ring, bottom);
      ++last;
    }
  }
  for (unsigned ring = 0; ring < last; ++ring) {
    for (unsigned piece = 0; piece < around; ++piece) {
      const unsigned high = first + ring * (around + 1) + piece, low = high + around + 1;
      if (ring > 0) {
        mesh.triangles.push_back({high, low, high + 1});
      }
      if (ring + 1 < last) {
        mesh.triangles.push_back({high + 1, low, low + 1});
      }
    }
  }
}

void add(Mesh& mesh, const sim::Sphere& sphere) {
  add_round(mesh, sphere.center, sphere.center, sphere.radius, glm::mat3(1.f));
}

/// Three directions at right angles, the second one along the axis.
glm::mat3 frame_along(const glm::vec3& axis) {
  const glm::vec3 aside = std::abs(axis.y) < 0.9f ? glm::vec3{0.f, 1.f, 0.f} : glm::vec3{1, 0, 0};
  const glm::vec3 u = glm::normalize(glm::cross(aside, axis));
  return {u, axis, glm::cross(u, axis)};
}

void add(Mesh& mesh, const sim::Capsule& capsule) {
  add_round(mesh, capsule.from, capsule.to, capsule.radius,
            frame_along(glm::normalize(capsule.to - capsule.from)));
}

void add(Mesh& mesh, const sim::Cylinder& cylinder) {
  const glm::vec3 axis = glm::normalize(cylinder.to - cylinder.from);
  const glm::mat3 frame = frame_along(axis);
  const glm::vec3 u = frame[0], v = -frame[2];
  const auto outward = [&](unsigned piece) {
    return std::cos(angle(piece)) * u + std::sin(angle(piece)) * v;
  };
  const float radius = cylinder.radius;
  for (unsigned piece = 0; piece < around; ++piece) {
    const glm::vec3 n0 = outward(piece), n1 = outward(piece + 1);
    add_quad(mesh, add_vertex(mesh, cylinder.from + radius * n0, n0),
             add_vertex(mesh, cylinder.from + radius * n1, n1),
             add_vertex(mesh, cylinder.to + radius * n1, n1),
             add_vertex(mesh, cylinder.to + radius * n0, n0));
    mesh.triangles.push_back({add_vertex(mesh, cylinder.to, axis),
                              add_vertex(mesh, cylinder.to + radius * n0, axis),
                              add_vertex(mesh, cylinder.to + radius * n1, axis)});
    mesh.triangles.push_back({add_vertex(mesh, cylinder.from, -axis),
                              add_vertex(mesh, cylinder.from + radius * n1, -axis),
                              add_vertex(mesh, cylinder.from + radius * n0, -axis)});
  }
}

/// cos of the largest angle between two faces that look like one round surface.
constexpr float smooth_cosine = 0.8f;

struct Face {
  glm::vec3 normal{0.f};  // unit
  glm::vec3 angles{0.f};  // at its corners
};

Face face_of(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c) {
  Face face;
  const glm::vec3 normal = glm::cross(b - a, c - a);
  const float length = glm::length(normal);
  if (length > 0.f) {
    face.normal = normal / length;
    const auto angle_at = [length](const glm::vec3& u, const glm::vec3& v) {
      return std::atan2(length, glm::dot(u, v));
    };
    face.angles = {angle_at(b - a, c - a), angle_at(c - b, a - b), angle_at(a - c, b - c)};
  }
  return face;
}

/// A vertex gets as many normals as there are round surfaces that meet there: for each face the
/// mean of the faces around the vertex that are not at a sharp angle to it, weighted by their
/// angles (Thürmer & Wüthrich 1998).
void add(Mesh& mesh, const sim::TriangleMesh& shape) {
  const sim::TriangleSurface& surface = shape.body->surface();
  struct Corner {
    std::size_t triangle;
    int number;
  };
  std::vector<std::vector<Corner>> corners(surface.vertices.size());
  std::vector<Face> faces;
  for (std::size_t i = 0; i < surface.triangles.size(); ++i) {
    const glm::uvec3& t = surface.triangles[i];
    faces.push_back(face_of(surface.vertices[t.x], surface.vertices[t.y], surface.vertices[t.z]));
    for (int k = 0; k < 3; ++k) {
      corners[t[k]].push_back({i, k});
    }
  }
  const std::size_t first_triangle = mesh.triangles.size();
  mesh.triangles.resize(first_triangle + surface.triangles.size());
  for (std::size_t v = 0; v < corners.size(); ++v) {
    const std::size_t first_vertex = mesh.vertices.size();
    for (const Corner& corner : corners[v]) {
      glm::vec3 sum{0.f};
      for (const Corner& other : corners[v]) {
        const Face& face = faces[other.triangle];
        if (glm::dot(face.normal, faces[corner.triangle].normal) > smooth_cosine) {
          sum += face.angles[other.number] * face.normal;
        }
      }
      const glm::vec3 normal =
          sum == glm::vec3{0.f} ? glm::vec3{0.f, 1.f, 0.f} : glm::normalize(sum);
      std::size_t vertex = first_vertex;
      while (vertex < mesh.vertices.size() && mesh.normals[vertex] != normal) {
        ++vertex;
      }
      if (vertex == mesh.vertices.size()) {
        add_vertex(mesh, surface.vertices[v], normal);
      }
      mesh.triangles[first_triangle + corner.triangle][corner.number] =
          static_cast<unsigned>(vertex);
    }
  }
}

}  // namespace

Mesh tessellate(std::span<const sim::Obstacle> obstacles) {
  Mesh mesh;
  for (const sim::Obstacle& obstacle : obstacles) {
    std::visit([&](const auto& shape) { add(mesh, shape); }, obstacle.shape);
  }
  return mesh;
}

ObstacleMeshes::ObstacleMeshes(std::span<const sim::Obstacle> obstacles) : moves_(false) {
  for (const sim::Obstacle& obstacle : obstacles) {
    parts_.push_back({obstacle, tessellate({&obstacle, 1})});
    moves_ = moves_ || obstacle.motion;
  }
}

Mesh ObstacleMeshes::at(double time) const {
  Mesh all;
  for (const Part& part : parts_) {
    const sim::Pose pose = sim::pose_at(part.obstacle, time);
    const auto first = static_cast<unsigned>(all.vertices.size());
    for (std::size_t i = 0; i < part.mesh.vertices.size(); ++i) {
      const glm::vec3 &vertex = part.mesh.vertices[i], &normal = part.mesh.normals[i];
      if (part.obstacle.motion) {
        add_vertex(all, glm::vec3(pose(vertex)), glm::vec3(pose.rotation * glm::dvec3(normal)));
      } else {
        add_vertex(all, vertex, normal);
      }
    }
    for (const glm::uvec3& triangle : part.mesh.triangles) {
      all.triangles.push_back(triangle + first);
    }
  }
  return all;
}

std::vector<glm::vec3> ObstacleMeshes::reach(std::span<const double> instants) const {
  glm::dvec3 low(1e30), high(-1e30);
  for (const Part& part : parts_) {
    if (!part.obstacle.motion) {
      continue;
    }
    const sim::Box box = sim::bounds_of(part.obstacle.shape);
    for (const double time : instants) {
      const sim::Pose pose = sim::pose_at(part.obstacle, time);
      for (int corner = 0; corner < 8; ++corner) {
        const glm::dvec3 p =
            pose({(corner & 1) ? box.max.x : box.min.x, (corner & 2) ? box.max.y : box.min.y,
                  (corner & 4) ? box.max.z : box.min.z});
        low = glm::min(low, p);
        high = glm::max(high, p);
      }
    }
  }
  if (!moves_ || instants.empty()) {
    return {};
  }
  const double rounding = 1e-4 * glm::distance(low, high);
  return {glm::vec3(low - rounding), glm::vec3(high + rounding)};
}

}  // namespace spindrift::app
