#include "app/errors/scene_error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <tuple>
#include <utility>

#include "app/errors/shown_text.hpp"

namespace spindrift::app {
namespace {

constexpr std::size_t most_problems = 20;      // reported one by one; the rest are only counted
constexpr std::size_t longest_source = 300;    // characters of a file's name or a --set
constexpr std::size_t longest_path = 160;      // characters
constexpr std::size_t longest_message = 1500;  // characters

/// Whether problem a is reported before b. Problems from --set have no line and come after those of
/// the file.
bool stands_before(const Problem& a, const Problem& b) {
  const auto key = [](const Problem& p) {
    return std::tuple(p.place.line == 0, p.place.line, p.place.column);
  };
  return key(a) < key(b);
}

Problem without_place(const std::string& message) {
  Problem problem;
  problem.message = message;
  return problem;
}

}  // namespace

std::string Place::text() const {
  const std::string name = shown(source, longest_source);
  return line == 0 ? name : fmt::format("{}:{}:{}", name, line, column);
}

std::string Problem::text() const {
  std::string result;
  for (const std::string& part : {place.text(), shown(path, longest_path)})
    if (!part.empty())
      result += part + ": ";
  return result + shown(message, longest_message);
}

SceneError::Told SceneError::told(std::vector<Problem> problems) {
  std::stable_sort(problems.begin(), problems.end(), stands_before);
  const std::size_t all = problems.size();
  problems.resize(std::min(all, most_problems));
  return {std::move(problems), all - std::min(all, most_problems)};
}

std::string SceneError::text_of(const Told& told) {
  std::string lines;
  for (const Problem& problem : told.problems)
    lines += fmt::format("{}{}", lines.empty() ? "" : "\n", problem.text());
  if (told.more > 0)
    lines += fmt::format("\nand {} more", told.more);
  return lines;
}

SceneError::SceneError(Told told)
    : std::runtime_error(text_of(told)), problems_(std::move(told.problems)), more_(told.more) {}

SceneError::SceneError(std::vector<Problem> problems) : SceneError(told(std::move(problems))) {}

SceneError::SceneError(Problem problem) : SceneError(std::vector<Problem>{std::move(problem)}) {}

SceneError::SceneError(const std::string& message) : SceneError(without_place(message)) {}

void throw_if_any(std::vector<Problem> problems) {
  if (!problems.empty())
    throw SceneError(std::move(problems));
}

}  // namespace spindrift::app
