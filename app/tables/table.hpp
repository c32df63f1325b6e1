// Tables of the keys of a JSON file, one for each struct of plain data (a section). The reader, the
// writer and the JSON schema of a section all work from its table.
#pragma once

#include <array>
#include <optional>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <variant>

#include "sim/geometry/keys.hpp"

namespace spindrift::app {

/// The type of table<T> where T has no table.
struct NoTable {};
/// The tuple of the Fields of a section. It is the struct's own static member `fields` where there
/// is one, and is specialised for other structs.
template <class T>
inline constexpr NoTable table{};
template <class T>
requires requires {
  T::fields;
}
inline constexpr auto table<T> = T::fields;

/// A struct that has a table of its keys.
template <class T>
concept Section = !std::is_same_v<decltype(table<T>), const NoTable>;

/// Calls f with every field of a section's table, in order.
template <Section T, class F>
void for_each_field(F&& f) {
  std::apply([&](const auto&... field) { (f(field), ...); }, table<T>);
}

/// Whether T is a std::optional: a value that may be left out, and that is then left out of the
/// resolved scene as well.
template <class T>
inline constexpr bool is_optional = false;
template <class T>
inline constexpr bool is_optional<std::optional<T>> = true;

/// For a section whose only field is a list, and into which the keys of a single entry may be
/// written directly: the name of such an entry in messages, as "a still camera" for a list of
/// camera keyframes. Empty for all other types.
template <class T>
inline constexpr std::string_view lone_entry_name{};

/// The names of an enumeration's values in files, in the order of the values, which count from 0.
template <class E>
inline constexpr std::array<std::string_view, 0> value_names{};

/// What a variant is called in messages.
template <class V>
inline constexpr std::string_view variant_name{};
/// The keys of a variant's alternatives, in the order of the alternatives: each alternative's own
/// static member `name`, or as specialised.
template <class V>
inline constexpr std::array<std::string_view, 0> alternative_names{};
template <class... S>
requires(requires { S::name; } && ...) inline constexpr std::array<
    std::string_view, sizeof...(S)> alternative_names<std::variant<S...>>{S::name...};
/// A variant of which a file gives exactly one alternative, by its key.
template <class V>
concept Alternatives = !variant_name<V>.empty();

}  // namespace spindrift::app
