// Formatting of vectors for messages.
#pragma once

#include <glm/glm.hpp>
#include <string>

namespace spindrift::geometry {

/// A vector as scene files write it, such as "[0, 0.5, 1]".
std::string vector_text(const glm::vec3& v);

}  // namespace spindrift::geometry
