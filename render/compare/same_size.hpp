// What every metric asks of its pictures.
#pragma once

#include "render/image.hpp"

namespace spindrift::compare {

/// @throws std::invalid_argument naming the sizes, for pictures that are empty or differ in size
void require_same_size(const Image& a, const Image& b);

}  // namespace spindrift::compare
