// Reads the vertices and faces of PLY files (Turk 1994, "The PLY polygon file format").
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "app/errors/shown_text.hpp"
#include "app/mesh_files/mesh_readers.hpp"
#include "sim/geometry/mesh/polygon.hpp"

namespace spindrift::app {
namespace {

enum class PlyEncoding { text, little_endian, big_endian };

/// A number type of the format.
struct PlyType {
  std::string_view name, other_name;
  std::size_t bytes;     ///< size in binary files
  bool whole, negative;  ///< whether it holds whole numbers only, and whether negative ones

  /// The largest value of a type of whole numbers; min() is the least.
  double max() const { return std::exp2(8. * double(bytes) - (negative ? 1. : 0.)) - 1.; }
  double min() const { return negative ? -max() - 1. : 0.; }
};
constexpr std::array<PlyType, 8> ply_types{{{"char", "int8", 1, true, true},
                                            {"uchar", "uint8", 1, true, false},
                                            {"short", "int16", 2, true, true},
                                            {"ushort", "uint16", 2, true, false},
                                            {"int", "int32", 4, true, true},
                                            {"uint", "uint32", 4, true, false},
                                            {"float", "float32", 4, false, true},
                                            {"double", "float64", 8, false, true}}};

struct PlyProperty {
  std::string_view name;
  const PlyType* type;
  const PlyType* count;  ///< type of a list's length; null for a single number
};

/// A kind of record, such as vertex or face.
struct PlyElement {
  std::string_view name;
  std::uint64_t count = 0;  ///< number of records in the file
  std::vector<PlyProperty> properties = {};

  /// The least number of bytes that one record takes.
  std::size_t least_bytes(PlyEncoding encoding) const {
    std::size_t sum = 0;
    for (const PlyProperty& p : properties) {
      const PlyType& first = p.count ? *p.count : *p.type;
      sum += encoding == PlyEncoding::text ? 2 : first.bytes;  // a digit and a space
    }
    return sum;
  }
};

struct PlyHeader {
  PlyEncoding encoding = PlyEncoding::text;
  std::vector<PlyElement> elements;
};

/// Reads the header's lines, up to end_header, and removes them from the front of the bytes.
class PlyHeaderReader {
 public:
  explicit PlyHeaderReader(std::string_view& bytes) : bytes_(bytes) {}

  PlyHeader read() {
    if (std::string_view line = take_line(bytes_); take_word(line) != "ply")
      throw MeshError("is not a PLY: its first line is not \"ply\"");
    for (line_ = 2; bytes_.find('\n') != std::string_view::npos; ++line_) {
      std::string_view line = take_line(bytes_);
      const std::string_view keyword = take_word(line);
      if (keyword == "end_header") {
        if (!has_format_)
          fail("there is no line \"format\" before it");
        return std::move(header_);
      }
      read(keyword, line);
    }
    throw MeshError("is cut short: its header has no end (end_header)");
  }

  /// The number of the line that was read last, counted from 1.
  std::size_t line() const { return line_; }

 private:
  [[noreturn]] void fail(const std::string& message) const {
    throw MeshError(fmt::format("line {}: {}", line_, message));
  }

  void read(std::string_view keyword, std::string_view rest) {
    if (keyword == "format")
      read_format(rest);
    else if (keyword == "element")
      read_element(rest);
    else if (keyword == "property")
      read_property(rest);
    else if (keyword != "comment" && keyword != "obj_info")
      fail(fmt::format("\"{}\" is not a line of a PLY's header", shown(keyword)));
  }

  void read_format(std::string_view rest) {
    constexpr std::array<std::string_view, 3> names{"ascii", "binary_little_endian",
                                                    "binary_big_endian"};
    const std::string_view name = take_word(rest), version = take_word(rest);
    const auto found = std::find(names.begin(), names.end(), name);
    if (found == names.end() || version != "1.0") {
      fail(
          fmt::format("unknown format \"{} {}\"; accepted: ascii, binary_little_endian and "
                      "binary_big_endian 1.0",
                      shown(name), shown(version)));
    }
    header_.encoding = static_cast<PlyEncoding>(found - names.begin());
    has_format_ = true;
  }

  void read_element(std::string_view rest) {
    const std::string_view name = take_word(rest), count = take_word(rest);
    const auto number = number_of<std::uint64_t>(count);
    if (name.empty() || !number)
      fail(fmt::format("\"{}\" is not a number of elements", shown(count)));
    header_.elements.push_back({name, *number});
  }

  void read_property(std::string_view rest) {
    if (header_.elements.empty())
      fail("a property before the first element");
    PlyProperty property{};
    std::string_view word = take_word(rest);
    if (word == "list") {
      property.count = type(take_word(rest));
      if (!property.count->whole)
        fail("a list's length must be of a type of whole numbers");
      word = take_word(rest);
    }
    property.type = type(word);
    property.name = take_word(rest);
    header_.elements.back().properties.push_back(property);
  }

  const PlyType* type(std::string_view name) const {
    for (const PlyType& type : ply_types)
      if (name == type.name || name == type.other_name)
        return &type;
    fail(
        fmt::format("unknown type \"{}\"; accepted: char, uchar, short, ushort, int, uint, float "
                    "and double",
                    shown(name)));
  }

  std::string_view& bytes_;
  PlyHeader header_;
  std::size_t line_ = 1;
  bool has_format_ = false;
};

/// Reads the part of a file after the header, number by number.
class PlyBody {
 public:
  /// @param bytes the part after the header
  /// @param offset position of that part in the file, in bytes from 0
  /// @param line number of its first line in the file, from 1
  PlyBody(std::string_view bytes, PlyEncoding encoding, std::size_t offset, std::size_t line)
      : bytes_(bytes), rest_(bytes), encoding_(encoding), offset_(offset), line_(line) {}

  /// Whether the rest of the file is long enough for `count` items of at least `least_bytes` each.
  bool has(std::uint64_t count, std::size_t least_bytes) const {
    const std::size_t last_space = encoding_ == PlyEncoding::text ? 1 : 0;
    return least_bytes == 0 || count <= (rest_.size() + last_space) / least_bytes;
  }

  double next(const PlyType& type) {
    return encoding_ == PlyEncoding::text ? next_in_text(type) : next_in_binary(type);
  }

  /// Reads the length of a list, and checks that the rest of the file can hold its entries.
  std::uint64_t next_length(const PlyProperty& list) {
    const double length = next(*list.count);
    if (length < 0)
      fail(fmt::format("a list of {} entries", length));
    const auto count = static_cast<std::uint64_t>(length);
    if (!has(count, encoding_ == PlyEncoding::text ? 2 : list.type->bytes))
      fail_short(fmt::format("a list of {} entries", count));
    return count;
  }

  [[noreturn]] void fail_short(const std::string& what) const {
    fail(fmt::format("is cut short: there are only {} bytes left for {}", rest_.size(), what));
  }

  [[noreturn]] void fail(const std::string& message) const {
    const bool text = encoding_ == PlyEncoding::text;
    throw MeshError(fmt::format("{} {}: {}", text ? "line" : "byte",
                                text ? line_ : offset_ + bytes_.size() - rest_.size(), message));
  }

 private:
  double next_in_text(const PlyType& type) {
    constexpr std::string_view spaces = " \t\r\n\v\f";
    const std::size_t start = std::min(rest_.find_first_not_of(spaces), rest_.size());
    line_ += static_cast<std::size_t>(std::count(rest_.begin(), rest_.begin() + start, '\n'));
    rest_.remove_prefix(start);
    const std::string_view word = rest_.substr(0, rest_.find_first_of(spaces));
    if (word.empty())
      fail_short("a number");
    const auto number = number_of<double>(word);
    if (!number)
      fail(fmt::format("\"{}\" is not a number", shown(word)));
    const bool fits = !type.whole || (*number >= type.min() && *number <= type.max() &&
                                      std::floor(*number) == *number);
    if (!fits)
      fail(fmt::format("{} is not of the type {}", shown(word), type.name));
    rest_.remove_prefix(word.size());
    return *number;
  }

  double next_in_binary(const PlyType& type) {
    std::array<char, 8> bytes{};
    if (rest_.size() < type.bytes)
      fail_short("a number");
    std::copy_n(rest_.begin(), type.bytes, bytes.begin());
    rest_.remove_prefix(type.bytes);
    const bool little = std::endian::native == std::endian::little;
    if ((encoding_ == PlyEncoding::little_endian) != little)
      std::reverse(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(type.bytes));
    const auto as = [&]<class Number>(Number number) {
      std::memcpy(&number, bytes.data(), sizeof number);
      return static_cast<double>(number);
    };
    switch (&type - ply_types.data()) {
      case 0:
        return as(std::int8_t{});
      case 1:
        return as(std::uint8_t{});
      case 2:
        return as(std::int16_t{});
      case 3:
        return as(std::uint16_t{});
      case 4:
        return as(std::int32_t{});
      case 5:
        return as(std::uint32_t{});
      case 6:
        return as(float{});
      default:
        return as(double{});
    }
  }

  std::string_view bytes_, rest_;
  PlyEncoding encoding_;
  std::size_t offset_, line_;
};

/// Reads the elements of a file in their order, and keeps the vertices and the triangles of faces.
class PlySurfaceReader {
 public:
  PlySurfaceReader(PlyBody body, PlyEncoding encoding) : body_(body), encoding_(encoding) {}

  geometry::TriangleSurface read(const std::vector<PlyElement>& elements) {
    for (const PlyElement& element : elements) {
      const std::size_t least = element.least_bytes(encoding_);
      if (element.count > 0 && least == 0)
        body_.fail(fmt::format("elements \"{}\" without a property", shown(element.name)));
      if (!body_.has(element.count, least)) {
        body_.fail_short(fmt::format("{} elements \"{}\" of at least {} each", element.count,
                                     shown(element.name), least));
      }
      read(element);
    }
    return std::move(surface_);
  }

 private:
  void read(const PlyElement& element) {
    if (element.name == "vertex") {
      read_vertices(element);
    } else if (element.name == "face") {
      read_faces(element);
    } else {
      for (std::uint64_t i = 0; i < element.count; ++i)
        for (const PlyProperty& property : element.properties)
          skip(property);
    }
  }

  void skip(const PlyProperty& property) {
    for (std::uint64_t k = property.count ? body_.next_length(property) : 1; k > 0; --k)
      body_.next(*property.type);
  }

  void read_vertices(const PlyElement& element) {
    std::vector<int> axes;  // axis of each property, or -1 for one that is no coordinate
    for (const PlyProperty& p : element.properties) {
      const bool is_axis = !p.count && p.name.size() == 1 && p.name[0] >= 'x' && p.name[0] <= 'z';
      axes.push_back(is_axis ? p.name[0] - 'x' : -1);
    }
    for (int axis = 0; axis < 3; ++axis)
      if (std::count(axes.begin(), axes.end(), axis) != 1)
        body_.fail("its vertices need properties x, y and z, each once");
    if (!surface_.vertices.empty() || element.count > std::numeric_limits<std::uint32_t>::max())
      body_.fail("it needs vertices once, and no more than can be counted in 32 bits");
    surface_.vertices.resize(element.count);
    for (glm::vec3& vertex : surface_.vertices) {
      for (std::size_t k = 0; k < axes.size(); ++k) {
        if (axes[k] < 0) {
          skip(element.properties[k]);
        } else {
          const double number = body_.next(*element.properties[k].type);
          placed([&] { vertex[axes[k]] = coordinate(number); });
        }
      }
    }
  }

  void read_faces(const PlyElement& element) {
    const auto is_face = [](const PlyProperty& p) {
      return p.count && (p.name == "vertex_indices" || p.name == "vertex_index");
    };
    const auto& properties = element.properties;
    if (std::count_if(properties.begin(), properties.end(), is_face) != 1)
      body_.fail("its faces need a list \"vertex_indices\"");
    std::vector<std::uint32_t> corners;
    for (std::uint64_t i = 0; i < element.count; ++i) {
      for (const PlyProperty& property : properties) {
        if (!is_face(property)) {
          skip(property);
          continue;
        }
        read_corners(property, i, corners);
        placed([&] { geometry::cut_polygon(surface_.vertices, corners, surface_.triangles); });
      }
    }
  }

  void read_corners(const PlyProperty& property, std::uint64_t face,
                    std::vector<std::uint32_t>& corners) {
    corners.resize(body_.next_length(property));
    for (std::uint32_t& corner : corners) {
      const double index = body_.next(*property.type);
      if (!(index >= 0 && index < static_cast<double>(surface_.vertices.size())) ||
          index != std::floor(index)) {
        body_.fail(surface_.vertices.empty()
                       ? fmt::format("face {} stands before the vertices", face)
                       : fmt::format("face {} has the vertex {}; accepted: 0 ... {}", face, index,
                                     surface_.vertices.size() - 1));
      }
      corner = static_cast<std::uint32_t>(index);
    }
  }

  /// Calls f.
  /// @throws MeshError when f does, with the place in the file in front of the message
  template <class F>
  void placed(F f) {
    try {
      f();
    } catch (const MeshError& error) {
      body_.fail(error.what());
    }
  }

  PlyBody body_;
  PlyEncoding encoding_;
  geometry::TriangleSurface surface_;
};

}  // namespace

geometry::TriangleSurface read_ply(std::string_view bytes) {
  const std::size_t size = bytes.size();
  PlyHeaderReader reader(bytes);
  const PlyHeader header = reader.read();
  const PlyBody body(bytes, header.encoding, size - bytes.size(), reader.line() + 1);
  return PlySurfaceReader(body, header.encoding).read(header.elements);
}

}  // namespace spindrift::app
