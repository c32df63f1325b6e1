#include "app/sweep_file.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <span>

#include "app/nearest_name.hpp"
#include "app/scene_reader.hpp"

namespace spindrift::app {
namespace {

constexpr std::array<std::string_view, 9> file_keys{
    "$schema", "scene", "set", "grid", "list", "latin_hypercube", "reference", "targets", "times"};
constexpr std::array<std::string_view, 3> hypercube_keys{"samples", "seed", "ranges"};
constexpr std::array<std::string_view, 4> range_keys{"min", "max", "scale", "whole"};
constexpr std::array<std::string_view, 2> scales{"linear", "logarithmic"};

class SweepReader {
 public:
  SweepReader(const SceneDocument& document, std::filesystem::path folder)
      : document_(document), folder_(std::move(folder)) {}

  SweepRequest read() const {
    const Json& root = document_.root();
    check_keys(root, "", file_keys);
    if (!root.contains("scene"))
      fail("", "\"scene\" is missing (the scene file, its path from the sweep file's folder)");
    SweepRequest request;
    request.scene = folder_ / text(root.at("scene"), "scene");
    if (root.contains("set"))
      read_fixed(root.at("set"), request.axes);
    if (root.contains("grid"))
      read_grid(root.at("grid"), request.axes);
    if (root.contains("list"))
      request.axes.push_back(read_list(root.at("list")));
    if (root.contains("latin_hypercube"))
      request.axes.push_back(read_hypercube(root.at("latin_hypercube")));
    if (root.contains("reference"))
      request.reference = text(root.at("reference"), "reference");
    if (root.contains("targets"))
      for (const auto& [metric, value] : object(root.at("targets"), "targets").items())
        request.targets.push_back({metric, number(value, child_path("targets", metric))});
    if (root.contains("times"))
      for (const Json& time : list(root.at("times"), "times"))
        request.times.push_back(number(time, "times"));
    return request;
  }

 private:
  [[noreturn]] void fail(const std::string& path, const std::string& message) const {
    throw SceneError(fmt::format("{}: {}{}{}", document_.place_of(path), path,
                                 path.empty() ? "" : ": ", message));
  }

  [[noreturn]] void expected(const char* what, const Json& found, const std::string& path) const {
    std::string shown = found.dump(-1, ' ', false, Json::error_handler_t::replace);
    if (shown.size() > 40)
      shown = shown.substr(0, 37) + "...";
    fail(path, fmt::format("expected {}, found {}", what, shown));
  }

  const Json& object(const Json& json, const std::string& path) const {
    if (!json.is_object())
      expected("an object {...}", json, path);
    return json;
  }

  const Json& list(const Json& json, const std::string& path) const {
    if (!json.is_array() || json.empty())
      expected("a list [...] of at least one entry", json, path);
    return json;
  }

  std::string text(const Json& json, const std::string& path) const {
    if (!json.is_string())
      expected("text", json, path);
    return json.get<std::string>();
  }

  double number(const Json& json, const std::string& path) const {
    if (!json.is_number())
      expected("a number", json, path);
    return json.get<double>();
  }

  int whole_number(const Json& json, const std::string& path, int min, int max) const {
    const double value = number(json, path);
    if (value < min || value > max || value != static_cast<int>(value))
      fail(path, fmt::format("{} is out of range; accepted: whole numbers, {} ... {}", json.dump(),
                             min, max));
    return static_cast<int>(value);
  }

  void check_keys(const Json& json, const std::string& path,
                  std::span<const std::string_view> keys) const {
    for (const auto& [key, value] : object(json, path).items())
      if (std::find(keys.begin(), keys.end(), key) == keys.end())
        fail(child_path(path, key), fmt::format("unknown key; {}", suggestion(key, keys)));
  }

  SweepValue value_of(const std::string& key, const Json& value, const std::string& path) const {
    return {key, value, fmt::format("{}: {}", document_.place_of(path), path)};
  }

  /// {"fluid.viscosity": 0.1, ...}
  SweepValues row_of(const Json& json, const std::string& path) const {
    SweepValues row;
    for (const auto& [key, value] : object(json, path).items())
      row.push_back(value_of(key, value, child_path(path, key)));
    return row;
  }

  void read_fixed(const Json& json, std::vector<SweepAxis>& axes) const {
    for (const SweepValue& value : row_of(json, "set"))
      axes.push_back({{value}});
  }

  void read_grid(const Json& json, std::vector<SweepAxis>& axes) const {
    for (const auto& [key, values] : object(json, "grid").items()) {
      const std::string path = child_path("grid", key);
      SweepAxis axis;
      for (const Json& value : list(values, path))
        axis.push_back({value_of(key, value, child_path(path, axis.size()))});
      axes.push_back(std::move(axis));
    }
  }

  SweepAxis read_list(const Json& json) const {
    SweepAxis axis;
    for (const Json& row : list(json, "list"))
      axis.push_back(row_of(row, child_path("list", axis.size())));
    return axis;
  }

  SampledRange read_range(const std::string& key, const Json& json, const std::string& path) const {
    check_keys(json, path, range_keys);
    for (const char* end : {"min", "max"})
      if (!json.contains(end))
        fail(path, fmt::format("\"{}\" is missing", end));
    SampledRange range{.key = key,
                       .min = number(json.at("min"), child_path(path, "min")),
                       .max = number(json.at("max"), child_path(path, "max")),
                       .place = fmt::format("{}: {}", document_.place_of(path), path)};
    if (range.min >= range.max)
      fail(child_path(path, "max"), "must be above min");
    if (json.contains("whole") && !json.at("whole").is_boolean())
      expected("true or false", json.at("whole"), child_path(path, "whole"));
    range.whole = json.value("whole", false);
    if (range.whole)
      for (const char* end : {"min", "max"})
        whole_number(json.at(end), child_path(path, end), -1'000'000, 1'000'000);
    const std::string scale =
        json.contains("scale") ? text(json.at("scale"), child_path(path, "scale")) : "linear";
    if (std::find(scales.begin(), scales.end(), scale) == scales.end())
      fail(child_path(path, "scale"),
           fmt::format("unknown value \"{}\"; {}", scale, suggestion(scale, scales)));
    range.logarithmic = scale == "logarithmic";
    if (range.logarithmic && (range.min <= 0 || range.whole))
      fail(child_path(path, "scale"),
           "logarithmic needs a min above 0, and numbers that need not be whole");
    return range;
  }

  SweepAxis read_hypercube(const Json& json) const {
    const std::string path = "latin_hypercube";
    check_keys(json, path, hypercube_keys);
    for (const char* key : {"samples", "ranges"})
      if (!json.contains(key))
        fail(path, fmt::format("\"{}\" is missing", key));
    const int samples = whole_number(json.at("samples"), child_path(path, "samples"), 2, 10'000);
    const int seed = json.contains("seed")
                         ? whole_number(json.at("seed"), child_path(path, "seed"), 0, 2'000'000'000)
                         : 1;
    const std::string ranges_path = child_path(path, "ranges");
    std::vector<SampledRange> ranges;
    for (const auto& [key, range] : object(json.at("ranges"), ranges_path).items())
      ranges.push_back(read_range(key, range, child_path(ranges_path, key)));
    return latin_hypercube(ranges, samples, static_cast<unsigned>(seed));
  }

  const SceneDocument& document_;
  std::filesystem::path folder_;
};

/// No scene has any of these keys.
bool is_sweep(const Json& root) {
  return root.is_object() && (root.contains("scene") || root.contains("grid") ||
                              root.contains("list") || root.contains("latin_hypercube"));
}

/// {"KEY": VALUE, ...} with values of one kind.
Json object_of(const char* about, const Json& values) {
  return {{"description", about}, {"type", "object"}, {"additionalProperties", values}};
}

Json hypercube_schema() {
  const Json number{{"type", "number"}};
  Json range{{"type", "object"},
             {"properties",
              {{"min", number},
               {"max", number},
               {"scale",
                {{"description", "in what the parts of the range are equal"},
                 {"enum", scales},
                 {"default", "linear"}}},
               {"whole",
                {{"description", "whole numbers only"}, {"type", "boolean"}, {"default", false}}}}},
             {"required", Json::array({"min", "max"})},
             {"additionalProperties", false}};
  return {{"description", "values drawn so that each part of each range is met once"},
          {"type", "object"},
          {"properties",
           {{"samples", {{"type", "integer"}, {"minimum", 2}, {"maximum", 10'000}}},
            {"seed", {{"type", "integer"}, {"minimum", 0}, {"default", 1}}},
            {"ranges", object_of("by key of the scene", range)}}},
          {"required", Json::array({"samples", "ranges"})},
          {"additionalProperties", false}};
}

}  // namespace

std::optional<SweepRequest> read_sweep_file(const std::filesystem::path& file) {
  const SceneDocument document(scene_text(file), file.string());
  if (!is_sweep(document.root()))
    return std::nullopt;
  return SweepReader(document, file.parent_path()).read();
}

nlohmann::ordered_json sweep_schema() {
  const Json number{{"type", "number"}};
  Json properties{
      {"$schema", {{"type", "string"}}},
      {"scene",
       {{"description", "scene file; its path from the sweep file's folder"}, {"type", "string"}}},
      {"set", object_of("values of all runs, by key, as in \"video.duration\": 2", Json::object())},
      {"grid", object_of("lists of values by key; every combination runs",
                         {{"type", "array"}, {"minItems", 1}})},
      {"list",
       {{"description", "one run for each entry"},
        {"type", "array"},
        {"minItems", 1},
        {"items", object_of("values by key", Json::object())}}},
      {"latin_hypercube", hypercube_schema()},
      {"reference",
       {{"description", "the run that all are compared with: its name, or values of it alone"},
        {"type", "string"}}},
      {"targets",
       object_of("values of figures that runs are ranked by their closeness to", number)},
      {"times",
       {{"description", "of the pictures that are set side by side (s); five if left out"},
        {"type", "array"},
        {"minItems", 1},
        {"items", {{"type", "number"}, {"minimum", 0}}}}}};
  return {{"$schema", "http://json-schema.org/draft-07/schema#"},
          {"title", "Spindrift sweep"},
          {"description",
           "A scene, and what of it is varied. Keys are those of scene files, as in "
           "fluid.viscosity or fluid.volumes[0].velocity."},
          {"type", "object"},
          {"properties", properties},
          {"required", Json::array({"scene"})},
          {"additionalProperties", false}};
}

}  // namespace spindrift::app
