#include "sim/geometry/vector_text.hpp"

#include <fmt/format.h>

namespace spindrift::geometry {

std::string vector_text(const glm::vec3& v) {
  return fmt::format("[{:g}, {:g}, {:g}]", v.x, v.y, v.z);
}

}  // namespace spindrift::geometry
