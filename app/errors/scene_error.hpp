// The error for a scene file, or another file read in the same way, that can't be used. It carries
// all problems found in the file, each with its place.
#pragma once

#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

namespace spindrift::app {

/// The place where a value was written.
struct Place {
  std::string source;        ///< a file's name, or "--set KEY=VALUE"; empty where it is unknown
  std::uint32_t line = 0;    ///< counted from 1; 0 where the source has no lines
  std::uint32_t column = 0;  ///< in characters, counted from 1

  /// "scene.json:3:14", or the source alone where there is no line.
  std::string text() const;
};

/// One thing that is wrong with a scene.
struct Problem {
  Place place;
  std::string path;     ///< key path of the value, such as fluid.volumes[0]; empty for the document
  std::string message;  ///< what was found and what is accepted

  /// "PLACE: PATH: MESSAGE" on one line; parts that are empty are left out.
  std::string text() const;
};

/// Thrown for a scene that can't be used. Its text has a line for each of the first 20 problems, in
/// the order of the file, and a line that counts the rest; control characters are escaped.
class SceneError : public std::runtime_error {
 public:
  explicit SceneError(const std::string& message);
  explicit SceneError(Problem problem);
  /// @param problems at least one, in any order
  explicit SceneError(std::vector<Problem> problems);

  /// The problems that are reported one by one, at most 20, in the order of the file.
  const std::vector<Problem>& problems() const { return problems_; }
  /// The number of problems beyond those in problems().
  std::size_t more() const { return more_; }

 private:
  struct Told {
    std::vector<Problem> problems;
    std::size_t more = 0;
  };
  static Told told(std::vector<Problem> problems);
  static std::string text_of(const Told& told);
  explicit SceneError(Told told);

  std::vector<Problem> problems_;
  std::size_t more_ = 0;
};

/// Throws the problems together, if there are any.
/// @throws SceneError
void throw_if_any(std::vector<Problem> problems);

}  // namespace spindrift::app
