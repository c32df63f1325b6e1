// Checks what every metric requires of its pictures.
#pragma once

#include "render/image.hpp"

namespace spindrift::compare {

/// Throws for pictures that are empty or differ in size.
/// @throws std::invalid_argument naming the sizes
void require_same_size(const Image& a, const Image& b);

}  // namespace spindrift::compare
