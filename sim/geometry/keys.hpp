// What a member of plain data is called in a file, what it means and what it may be: the keys of a
// scene are described where their data is declared.
#pragma once

#include <string_view>
#include <tuple>

namespace spindrift {

/// Accepted numbers, both ends included; for vectors, each component.
struct Range {
  double min = 0.;
  double max = 0.;
};

enum class Presence { optional, required };

/// One key: its place in the settings, what it may be, and what it is. A field without a key puts
/// the keys of its own type (a struct's fields, or a variant's alternatives) into its owner's.
template <class Owner, class Value>
struct Field {
  using Member = Value Owner::*;
  std::string_view key;
  Member member;
  std::string_view about = {};
  Range range = {};
  std::string_view unit = {};
  Presence presence = Presence::optional;
};

template <class Owner, class Value>
Field(std::string_view, Value Owner::*, std::string_view = {}, Range = {}, std::string_view = {},
      Presence = Presence::optional) -> Field<Owner, Value>;

inline constexpr Range places{-1e5, 1e5};   ///< m
inline constexpr Range lengths{1e-6, 1e5};  ///< m
inline constexpr Range directions{-1e6, 1e6};

}  // namespace spindrift
