// A tagged union of trivially copyable types that works on the host and on a device.
#pragma once

#include <algorithm>
#include <new>
#include <type_traits>

#include "sim/geometry/host_device.hpp"

namespace spindrift::geometry {

/// Holds a value of one of several trivially copyable types, like std::variant, whose visit()
/// cannot be called on a device. A visitor must accept every type; otherwise the call does not
/// compile.
template <class... Types>
class OneOf {
  static_assert((std::is_trivially_copyable_v<Types> && ...));

 public:
  template <class T>
  explicit OneOf(const T& value) : index_(index_of<T>()) {
    new (bytes_) T(value);
  }

  /// Calls `visitor` with the held value and returns the result.
  template <class Visitor>
  SPINDRIFT_HD decltype(auto) visit(const Visitor& visitor) const {
    return visit_from<0, Visitor, Types...>(visitor);
  }

 private:
  template <class T>
  static constexpr int index_of() {
    int index = -1, k = 0;
    ((index = std::is_same_v<T, Types> ? k : index, ++k), ...);
    return index;
  }

  template <int Index, class Visitor, class First, class... Rest>
  SPINDRIFT_HD decltype(auto) visit_from(const Visitor& visitor) const {
    const First& value = *std::launder(reinterpret_cast<const First*>(bytes_));
    if constexpr (sizeof...(Rest) == 0) {
      return visitor(value);
    } else {
      if (index_ == Index)
        return visitor(value);
      return visit_from<Index + 1, Visitor, Rest...>(visitor);
    }
  }

  alignas(Types...) unsigned char bytes_[std::max({sizeof(Types)...})];
  int index_;
};

}  // namespace spindrift::geometry
