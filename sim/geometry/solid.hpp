// Shapes as plain data that loops over particles can capture, on the host or on a device, and the
// collision of straight particle paths with them.
#pragma once

#include "sim/geometry/one_of.hpp"
#include "sim/geometry/shape.hpp"

namespace spindrift::geometry {

// Each of the following functions has a template for the convex shapes and an overload for meshes.

/// Whether a point (m) is inside a shape.
template <class Convex>
SPINDRIFT_HD bool is_in(const Convex& shape, const glm::vec3& p) {
  const glm::vec3 moved = shape.push_out(p) - p;
  return glm::dot(moved, moved) > 0;
}
SPINDRIFT_HD inline bool is_in(const MeshSolid& mesh, const glm::vec3& p) {
  return mesh.view->grid.at(p).distance < 0;
}

/// Where the straight path between two points enters the shape. Both points are outside it, up to
/// rounding errors.
template <class Convex>
SPINDRIFT_HD Entry entry_between(const Convex& shape, const glm::vec3& from, const glm::vec3& to) {
  const glm::vec3 begin = shape.push_out(from);
  return shape.entry(begin, to - begin);
}
SPINDRIFT_HD inline Entry entry_between(const MeshSolid& mesh, const glm::vec3& from,
                                        const glm::vec3& to) {
  return mesh.view->entry(from, to, 0);
}

/// Where a path from `from` to `to` ends if it must not enter a shape: at `to`, or, if it enters,
/// at the projection of `to` onto the plane that is parallel to the surface at the entry, a
/// distance `off` (m) outside it.
SPINDRIFT_HD inline glm::vec3 stopped_at(const Entry& entry, const glm::vec3& from,
                                         const glm::vec3& to, float off) {
  if (!entry.found)
    return to;
  const glm::vec3 surface = from + entry.part * (to - from);
  return to + (off - glm::dot(to - surface, entry.normal)) * entry.normal;
}

/// Where a path ends that must keep a margin (m) off the shape: at `to`, or, if it would come
/// nearer, at the projection of `to` onto the plane that is parallel to the surface at the entry
/// and one and a half margins off it, m.
template <class Convex>
SPINDRIFT_HD glm::vec3 end_outside(const Convex& shape, glm::vec3 from, const glm::vec3& to,
                                   float margin) {
  const float off = 0.5f * margin;
  const Convex thick = shape.thickened(margin);
  const glm::vec3 out = thick.push_out(from), push = out - from;
  if (push != glm::vec3(0.f))  // rounding errors alone have put it inside
    from = out + off * glm::normalize(push);
  return stopped_at(thick.entry(from, to - from), from, to, off);
}
SPINDRIFT_HD inline glm::vec3 end_outside(const MeshSolid& mesh, const glm::vec3& from,
                                          const glm::vec3& to, float margin) {
  return stopped_at(mesh.view->entry(from, to, margin), from, to, 1.5f * margin);
}

/// Whether the point `p` is certainly outside the shape and farther than `reach` (m) from its
/// surface; false says nothing.
template <class Convex>
SPINDRIFT_HD bool is_surely_clear(const Convex&, const glm::vec3&, float) {
  return false;  // being certain costs as much as computing the entry
}
SPINDRIFT_HD inline bool is_surely_clear(const MeshSolid& mesh, const glm::vec3& p, float reach) {
  return mesh.view->is_clear(p, reach);
}

/// The type that represents a shape in loops over particles: the shape itself, if it is plain data.
template <class S>
struct SeenByLoops {
  using Type = S;
};
template <>
struct SeenByLoops<TriangleMesh> {
  using Type = MeshSolid;
};
/// The OneOf type that holds the loops' representation of each alternative of a std::variant.
template <class Variant>
struct SolidOfOne;
template <class... S>
struct SolidOfOne<std::variant<S...>> {
  using Type = OneOf<typename SeenByLoops<S>::Type...>;
};

/// A shape of any kind, where the scene places it, as trivially copyable data. A mesh is referred
/// to by a pointer.
class Solid {
 public:
  Solid() : Solid(Box{}, Box{}) {}
  template <class Data>
  Solid(const Data& shape, const Box& bounds) : bounds_(bounds), shape_(shape) {}

  const Box& bounds() const { return bounds_; }

  /// The point on the surface nearest to `p`, if `p` is inside; otherwise `p` itself, m.
  SPINDRIFT_HD SPINDRIFT_APART glm::vec3 push_out(const glm::vec3& p) const {
    return shape_.visit(PushOut{p});
  }

  /// Whether a point (m) is inside.
  SPINDRIFT_HD bool contains(const glm::vec3& p) const { return shape_.visit(Contains{p}); }

  /// Whether a path may come nearer than the margin (m): whether the bounding boxes of the shape
  /// and of the path are no farther apart than that.
  SPINDRIFT_HD bool may_meet(const glm::vec3& from, const glm::vec3& to, float margin) const {
    const glm::vec3 low = glm::min(from, to), high = glm::max(from, to);
    return low.x <= bounds_.max.x + margin && low.y <= bounds_.max.y + margin &&
           low.z <= bounds_.max.z + margin && high.x >= bounds_.min.x - margin &&
           high.y >= bounds_.min.y - margin && high.z >= bounds_.min.z - margin;
  }

  /// Calls geometry::is_surely_clear() for the shape.
  SPINDRIFT_HD bool is_surely_clear(const glm::vec3& p, float reach) const {
    return shape_.visit(IsSurelyClear{p, reach});
  }
  /// Calls geometry::end_outside() for the shape.
  SPINDRIFT_HD SPINDRIFT_APART glm::vec3 end_outside(const glm::vec3& from, const glm::vec3& to,
                                                     float margin) const {
    return shape_.visit(EndOutside{from, to, margin});
  }
  /// Calls geometry::entry_between() for the shape.
  SPINDRIFT_HD Entry entry_between(const glm::vec3& from, const glm::vec3& to) const {
    return shape_.visit(EntryBetween{from, to});
  }

 private:
  // The visitors are named structs, since a device's compiler accepts no generic lambdas.
  struct PushOut {
    glm::vec3 p;
    template <class S>
    SPINDRIFT_HD glm::vec3 operator()(const S& shape) const {
      return shape.push_out(p);
    }
  };
  struct Contains {
    glm::vec3 p;
    template <class S>
    SPINDRIFT_HD bool operator()(const S& shape) const {
      return is_in(shape, p);
    }
  };
  struct IsSurelyClear {
    glm::vec3 p;
    float reach;
    template <class S>
    SPINDRIFT_HD bool operator()(const S& shape) const {
      return geometry::is_surely_clear(shape, p, reach);
    }
  };
  struct EndOutside {
    glm::vec3 from, to;
    float margin;
    template <class S>
    SPINDRIFT_HD glm::vec3 operator()(const S& shape) const {
      return geometry::end_outside(shape, from, to, margin);
    }
  };
  struct EntryBetween {
    glm::vec3 from, to;
    template <class S>
    SPINDRIFT_HD Entry operator()(const S& shape) const {
      return geometry::entry_between(shape, from, to);
    }
  };

  Box bounds_;  ///< m
  SolidOfOne<Shape>::Type shape_;
};

/// The solid of a shape for loops that find meshes where `meshes` puts them, such as in a device's
/// memory.
/// @param meshes has a member `const MeshView* view_of(const MeshBody&)`
template <class Meshes>
Solid solid_of(const Shape& shape, Meshes& meshes) {
  return std::visit(
      [&](const auto& s) {
        if constexpr (std::is_same_v<std::remove_cvref_t<decltype(s)>, TriangleMesh>)
          return Solid(MeshSolid{meshes.view_of(*s.body)}, s.bounds());
        else
          return Solid(s, s.bounds());
      },
      shape);
}

/// The solid of a shape for loops on the host. It refers to the mesh body that `shape` owns.
Solid solid_of(const Shape& shape);

}  // namespace spindrift::geometry
