// Shapes as plain data, which loops over particles carry with them, on the processor or on a
// device.
#pragma once

#include "sim/geometry/one_of.hpp"
#include "sim/geometry/shape.hpp"

namespace spindrift::geometry {

// What a way meets of any convex shape; of a mesh, the overloads below.

/// Whether a point is inside.
template <class Convex>
SPINDRIFT_HD bool is_in(const Convex& shape, const glm::vec3& p) {
  const glm::vec3 moved = shape.push_out(p) - p;
  return glm::dot(moved, moved) > 0;
}
SPINDRIFT_HD inline bool is_in(const MeshSolid& mesh, const glm::vec3& p) {
  return mesh.view->grid.at(p).distance < 0;
}

/// Where a way between two places that are outside, but for rounding, enters the shape.
template <class Convex>
SPINDRIFT_HD Entry entry_between(const Convex& shape, const glm::vec3& from, const glm::vec3& to) {
  const glm::vec3 begin = shape.push_out(from);
  return shape.entry(begin, to - begin);
}
SPINDRIFT_HD inline Entry entry_between(const MeshSolid& mesh, const glm::vec3& from,
                                        const glm::vec3& to) {
  return mesh.view->entry(from, to, 0);
}

/// The end of a way that touches a surface, moved off it along its normal: `off` m before it.
SPINDRIFT_HD inline glm::vec3 stopped_at(const Entry& entry, const glm::vec3& from,
                                         const glm::vec3& to, float off) {
  if (!entry.found)
    return to;
  const glm::vec3 surface = from + entry.part * (to - from);
  return to + (off - glm::dot(to - surface, entry.normal)) * entry.normal;
}

/// Where a way ends that is not to enter the shape: at its end, or, where it would enter, that far
/// along the plane that touches the surface there, one and a half margins off it; m.
template <class Convex>
SPINDRIFT_HD glm::vec3 end_outside(const Convex& shape, glm::vec3 from, const glm::vec3& to,
                                   float margin) {
  const float off = 0.5f * margin;
  const Convex thick = shape.thickened(margin);
  const glm::vec3 out = thick.push_out(from), push = out - from;
  if (push != glm::vec3(0.f))  // but for rounding it was outside
    from = out + off * glm::normalize(push);
  return stopped_at(thick.entry(from, to - from), from, to, off);
}
SPINDRIFT_HD inline glm::vec3 end_outside(const MeshSolid& mesh, const glm::vec3& from,
                                          const glm::vec3& to, float margin) {
  return stopped_at(mesh.view->entry(from, to, margin), from, to, 1.5f * margin);
}

/// Whether the surface is surely farther from a place outside than a distance, m.
template <class Convex>
SPINDRIFT_HD bool is_surely_clear(const Convex&, const glm::vec3&, float) {
  return false;  // to be sure costs as much as to look
}
SPINDRIFT_HD inline bool is_surely_clear(const MeshSolid& mesh, const glm::vec3& p, float reach) {
  return mesh.view->is_clear(p, reach);
}

/// What loops see of a shape: the shape itself, if it is plain data.
template <class S>
struct SeenByLoops {
  using Type = S;
};
template <>
struct SeenByLoops<TriangleMesh> {
  using Type = MeshSolid;
};
template <class Variant>
struct SolidOfOne;
template <class... S>
struct SolidOfOne<std::variant<S...>> {
  using Type = OneOf<typename SeenByLoops<S>::Type...>;
};

/// A shape of any kind, where the scene puts it.
class Solid {
 public:
  Solid() : Solid(Box{}, Box{}) {}
  template <class Data>
  Solid(const Data& shape, const Box& bounds) : bounds_(bounds), shape_(shape) {}

  const Box& bounds() const { return bounds_; }

  /// The nearest point on the surface for a point inside; a point outside comes back as it is.
  SPINDRIFT_HD SPINDRIFT_APART glm::vec3 push_out(const glm::vec3& p) const {
    return shape_.visit(PushOut{p});
  }

  /// Whether a point is inside.
  SPINDRIFT_HD bool contains(const glm::vec3& p) const { return shape_.visit(Contains{p}); }

  /// Whether a way may come nearer than the margin: the shape's box and that of the way overlap.
  SPINDRIFT_HD bool may_meet(const glm::vec3& from, const glm::vec3& to, float margin) const {
    const glm::vec3 low = glm::min(from, to), high = glm::max(from, to);
    return low.x <= bounds_.max.x + margin && low.y <= bounds_.max.y + margin &&
           low.z <= bounds_.max.z + margin && high.x >= bounds_.min.x - margin &&
           high.y >= bounds_.min.y - margin && high.z >= bounds_.min.z - margin;
  }

  /// As the function of this name, for a shape of any kind.
  SPINDRIFT_HD bool is_surely_clear(const glm::vec3& p, float reach) const {
    return shape_.visit(IsSurelyClear{p, reach});
  }
  SPINDRIFT_HD SPINDRIFT_APART glm::vec3 end_outside(const glm::vec3& from, const glm::vec3& to,
                                                     float margin) const {
    return shape_.visit(EndOutside{from, to, margin});
  }
  SPINDRIFT_HD Entry entry_between(const glm::vec3& from, const glm::vec3& to) const {
    return shape_.visit(EntryBetween{from, to});
  }

 private:
  // Named, since a device's compiler takes no generic lambdas.
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

/// As loops look at a shape that find meshes elsewhere.
/// @param meshes has `const MeshView* view_of(const MeshBody&)`
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

/// As loops on the processor look at it.
Solid solid_of(const Shape& shape);

}  // namespace spindrift::geometry
