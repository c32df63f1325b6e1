#include "sim/geometry/round.hpp"

namespace spindrift::geometry {

glm::mat3 frame_along(const glm::vec3& axis) {
  const glm::vec3 u = -across(axis);
  return {u, axis, glm::cross(u, axis)};
}

std::vector<glm::vec3> points_on_capsule(const glm::vec3& center, const glm::mat3& frame,
                                         float length, float radius, float spacing) {
  const double half = length / (2. * radius);  // half the length, in radii
  const double area = 4 * std::numbers::pi * radius * radius * (1 + half);
  const int n = std::max(1, static_cast<int>(std::lround(area / (spacing * spacing))));
  const double golden_angle = std::numbers::pi * (3 - std::sqrt(5.0));
  std::vector<glm::vec3> points;
  for (int k = 0; k < n; ++k) {
    const double y = (1 + half) * (1 - (2 * k + 1) / static_cast<double>(n));
    const double beyond = std::max(0., std::abs(y) - half);
    const double ring = std::sqrt(1 - beyond * beyond), angle = golden_angle * k;
    const glm::vec3 place(ring * std::cos(angle), y, ring * std::sin(angle));
    points.push_back(center + radius * (frame * place));
  }
  return points;
}

std::vector<glm::vec3> points_on_cone(const glm::vec3& from, const glm::vec3& to,
                                      const glm::vec2& radii, float spacing) {
  const glm::vec3 axis = glm::normalize(to - from), u = across(axis), v = glm::cross(axis, u);
  std::vector<glm::vec3> points;
  const auto add_ring = [&](glm::vec3 center, float r) {
    const int n = std::max(1, static_cast<int>(std::lround(2 * std::numbers::pi * r / spacing)));
    for (int k = 0; k < n; ++k) {
      const float angle =
          2 * std::numbers::pi_v<float> * static_cast<float>(k) / static_cast<float>(n);
      points.push_back(center + r * (std::cos(angle) * u + std::sin(angle) * v));
    }
  };
  const float widening = radii.y - radii.x;
  const float side =
      widening == 0 ? glm::length(to - from) : std::hypot(glm::length(to - from), widening);
  const int layers = std::max(1, static_cast<int>(std::lround(side / spacing)));
  for (int k = 0; k <= layers; ++k) {
    const float part = static_cast<float>(k) / static_cast<float>(layers);
    add_ring(from + (to - from) * part, radii.x + widening * part);
  }
  const glm::ivec2 rings(std::lround(radii.x / spacing), std::lround(radii.y / spacing));
  for (int k = 0; k < std::max(rings.x, rings.y); ++k) {
    if (k < rings.x)
      add_ring(from, radii.x * static_cast<float>(k) / static_cast<float>(rings.x));
    if (k < rings.y)
      add_ring(to, radii.y * static_cast<float>(k) / static_cast<float>(rings.y));
  }
  return points;
}

void tessellate_capsule(Tessellation& into, const glm::vec3& bottom, const glm::vec3& top,
                        float radius, const glm::mat3& frame) {
  constexpr unsigned around = pieces_of_circle, rings = around / 2;
  const auto first = static_cast<unsigned>(into.vertices.size());
  const auto add_ring = [&](unsigned ring, const glm::vec3& center) {
    const float polar = angle_of_piece(ring);  // 0 at the top, π at the bottom
    for (unsigned piece = 0; piece <= around; ++piece) {
      const float angle = angle_of_piece(piece);
      const glm::vec3 normal{std::sin(polar) * std::cos(angle), std::cos(polar),
                             -std::sin(polar) * std::sin(angle)};
      into.add_vertex(center + radius * (frame * normal), frame * normal);
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
  for (unsigned ring = 0; ring < last; ++ring)
    for (unsigned piece = 0; piece < around; ++piece) {
      const unsigned high = first + ring * (around + 1) + piece, low = high + around + 1;
      if (ring > 0)
        into.add_triangle(high, low, high + 1);
      if (ring + 1 < last)
        into.add_triangle(high + 1, low, low + 1);
    }
}

void tessellate_cone(Tessellation& into, const glm::vec3& from, const glm::vec3& to,
                     const glm::vec2& radii) {
  const glm::vec3 axis = glm::normalize(to - from);
  const glm::mat3 frame = frame_along(axis);
  const glm::vec3 u = frame[0], v = -frame[2];
  const float slope = (radii.x - radii.y) / glm::length(to - from);
  const auto outward = [&](unsigned piece) {
    return std::cos(angle_of_piece(piece)) * u + std::sin(angle_of_piece(piece)) * v;
  };
  const auto normal = [&](const glm::vec3& out) {
    return slope == 0 ? out : glm::normalize(out + slope * axis);
  };
  for (unsigned piece = 0; piece < pieces_of_circle; ++piece) {
    const glm::vec3 n0 = outward(piece), n1 = outward(piece + 1);
    into.add_quad(into.add_vertex(from + radii.x * n0, normal(n0)),
                  into.add_vertex(from + radii.x * n1, normal(n1)),
                  into.add_vertex(to + radii.y * n1, normal(n1)),
                  into.add_vertex(to + radii.y * n0, normal(n0)));
    if (radii.y > 0)
      into.add_triangle(into.add_vertex(to, axis), into.add_vertex(to + radii.y * n0, axis),
                        into.add_vertex(to + radii.y * n1, axis));
    if (radii.x > 0)
      into.add_triangle(into.add_vertex(from, -axis), into.add_vertex(from + radii.x * n1, -axis),
                        into.add_vertex(from + radii.x * n0, -axis));
  }
}

}  // namespace spindrift::geometry
