// Tables of the keys of a file: one for each section of plain data, from which it is read, written
// and described.
#pragma once

#include <array>
#include <optional>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <variant>

#include "sim/geometry/keys.hpp"

namespace spindrift::app {

/// The fields of a section: given here for settings that do not state them themselves.
struct NoTable {};
template <class T>
inline constexpr NoTable table{};
template <class T>
requires requires {
  T::fields;
}
inline constexpr auto table<T> = T::fields;

template <class T>
concept Section = !std::is_same_v<decltype(table<T>), const NoTable>;

/// Calls f with every field of a section's table, in order.
template <Section T, class F>
void for_each_field(F&& f) {
  std::apply([&](const auto&... field) { (f(field), ...); }, table<T>);
}

/// A value that may be left out; it is then left out of the resolved scene as well.
template <class T>
inline constexpr bool is_optional = false;
template <class T>
inline constexpr bool is_optional<std::optional<T>> = true;

/// What one entry is called of a section that has a single field, a list, where it may be written
/// straight into the section: a still camera, for a list of keyframes. Empty for all others.
template <class T>
inline constexpr std::string_view lone_entry_name{};

/// Names of an enumeration's values, in the order of the values, which count from 0.
template <class E>
inline constexpr std::array<std::string_view, 0> value_names{};

/// What a variant is called in messages, and the keys of its alternatives, in its order.
template <class V>
inline constexpr std::string_view variant_name{};
template <class V>
inline constexpr std::array<std::string_view, 0> alternative_names{};
template <class... S>
requires(requires { S::name; } && ...) inline constexpr std::array<
    std::string_view, sizeof...(S)> alternative_names<std::variant<S...>>{S::name...};
template <class V>
concept Alternatives = !variant_name<V>.empty();

}  // namespace spindrift::app
