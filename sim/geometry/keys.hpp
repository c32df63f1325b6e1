// Describes how a member of a plain struct is written in a scene file: its key, its meaning and the
// accepted values. Scene files are read, written and described from the lists of such fields.
#pragma once

#include <string_view>
#include <tuple>

namespace spindrift {

/// The accepted range of a number, or of each component of a vector; both ends are included.
struct Range {
  double min = 0.;
  double max = 0.;
};

/// Whether a scene file must give the key.
enum class Presence { optional, required };

/// One key of a scene file and the member of `Owner` that it sets. A field with an empty key puts
/// the keys of its own type (a struct's fields, or a variant's alternatives) among its owner's.
template <class Owner, class Value>
struct Field {
  using Member = Value Owner::*;
  std::string_view key;
  Member member;
  std::string_view about = {};  ///< the key's meaning, for people
  Range range = {};             ///< the accepted values; unused for members that are not numbers
  std::string_view unit = {};   ///< empty: dimensionless
  Presence presence = Presence::optional;
};

template <class Owner, class Value>
Field(std::string_view, Value Owner::*, std::string_view = {}, Range = {}, std::string_view = {},
      Presence = Presence::optional) -> Field<Owner, Value>;

inline constexpr Range places{-1e5, 1e5};      ///< accepted coordinates, m
inline constexpr Range lengths{1e-6, 1e5};     ///< accepted lengths, m
inline constexpr Range directions{-1e6, 1e6};  ///< accepted components of direction vectors

}  // namespace spindrift
