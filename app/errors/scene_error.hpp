// What is wrong with a scene, or with a file in the manner of scenes: all of it at once.
#pragma once

#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

namespace spindrift::app {

/// Where a value was written.
struct Place {
  std::string source;        ///< a file, or "--set KEY=VALUE"; empty: nowhere in particular
  std::uint32_t line = 0;    ///< from 1; 0: the source has no lines
  std::uint32_t column = 0;  ///< letters, from 1

  /// "scene.json:3:14", or the source alone.
  std::string text() const;
};

/// One thing that is wrong.
struct Problem {
  Place place;
  std::string path;     ///< of the value, such as fluid.volumes[0]; empty: the whole document
  std::string message;  ///< what was found and what is accepted

  /// "PLACE: PATH: MESSAGE" without the parts that are empty, on one line.
  std::string text() const;
};

/// A scene that can't be used. Its text has a line for each problem, in the order of the file, and
/// one that counts the rest where there are very many; no line has a control character.
class SceneError : public std::runtime_error {
 public:
  explicit SceneError(const std::string& message);
  explicit SceneError(Problem problem);
  /// @param problems at least one, in any order
  explicit SceneError(std::vector<Problem> problems);

  /// Those that are told.
  const std::vector<Problem>& problems() const { return problems_; }
  /// How many more there are.
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

/// @throws SceneError with all of them, if there are any
void throw_if_any(std::vector<Problem> problems);

}  // namespace spindrift::app
