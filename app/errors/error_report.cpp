#include "app/errors/error_report.hpp"

#include <fmt/format.h>

#include <cstdio>
#include <nlohmann/json.hpp>
#include <string_view>
#include <vector>

#include "app/errors/errors.hpp"
#include "app/errors/shown_text.hpp"

namespace spindrift::app {
namespace {

constexpr std::size_t longest_line = 2000;  // characters of a message's line; the rest is cut off

void print_lines(const std::string& begin, std::string_view message) {
  std::fflush(stdout);
  while (!message.empty()) {
    const auto end = message.find('\n');
    fmt::print(stderr, "{}{}\n", begin, shown(message.substr(0, end), longest_line));
    message.remove_prefix(end == std::string_view::npos ? message.size() : end + 1);
  }
}

nlohmann::ordered_json problem_json(const Problem& problem) {
  nlohmann::ordered_json json;
  if (!problem.place.source.empty())
    json["source"] = problem.place.source;
  if (problem.place.line > 0) {
    json["line"] = problem.place.line;
    json["column"] = problem.place.column;
  }
  if (!problem.path.empty())
    json["path"] = problem.path;
  json["message"] = problem.message;
  return json;
}

void print_json(ExitCode code, const std::vector<Problem>& problems, std::size_t more) {
  nlohmann::ordered_json errors = nlohmann::ordered_json::array();
  for (const Problem& problem : problems)
    errors.push_back(problem_json(problem));
  nlohmann::ordered_json json{{"errors", errors}};
  if (more > 0)
    json["more"] = more;
  json["exit_code"] = static_cast<int>(code);
  fmt::print("{}\n", json.dump(1, ' ', false, nlohmann::ordered_json::error_handler_t::replace));
}

}  // namespace

ExitCode tell_error(ExitCode code, const std::string& message, bool json) {
  print_lines("spindrift: ", message);
  if (json)
    print_error_json(code, message);
  return code;
}

ExitCode tell_error(const SceneError& error, bool json) {
  print_lines("spindrift: ", error.what());
  if (json)
    print_json(bad_usage, error.problems(), error.more());
  return bad_usage;
}

void print_error_json(ExitCode code, const std::string& message) {
  print_json(code, SceneError(message).problems(), 0);
}

void tell_warning(const std::string& message) {
  print_lines("spindrift: warning: ", message);
}

}  // namespace spindrift::app
