#include "app/tables/table_reader.hpp"

#include <cmath>

#include "app/errors/shown_text.hpp"
#include "app/tables/frame_rate_text.hpp"

namespace spindrift::app {

std::string found_text(const Json& json) {
  const auto text = [&] {
    return shown(json.dump(-1, ' ', false, Json::error_handler_t::replace));
  };
  switch (json.type()) {
    case Json::value_t::null:
      return "null";
    case Json::value_t::object:
      return "an object";
    case Json::value_t::array:
      return "the list " + text();
    default:
      return text();
  }
}

namespace {

std::string range_text(const Range& range, std::string_view unit) {
  if (std::isinf(range.max))
    return "any";
  return fmt::format("{} ... {}{}{}", range.min, range.max, unit.empty() ? "" : " ", unit);
}

}  // namespace

bool TableReader::check_keys(const LocatedValue& value, const std::vector<std::string_view>& keys,
                             std::vector<std::string_view>& meant) {
  if (!value.json().is_object()) {
    complain(value,
             keys.empty()
                 ? fmt::format("expected an empty object {{}}, found {}", found_text(value.json()))
                 : fmt::format("expected an object {{...}} with keys out of {}, found {}",
                               fmt::join(keys, ", "), found_text(value.json())));
    return false;
  }
  value.for_each_member([&](const std::string& key, const LocatedValue& member) {
    const bool of_editors = value.is_root() && key == "$schema";
    if (of_editors || std::find(keys.begin(), keys.end(), key) != keys.end())
      return;
    complain(member, keys.empty() ? "unknown key; none is accepted here, write {}"
                                  : fmt::format("unknown key; {}", suggestion(key, keys)));
    meant.push_back(nearest_name(key, keys));
  });
  return true;
}

void TableReader::read(const LocatedValue& value, std::string& into, const Bounds&) {
  if (!value.json().is_string())
    return complain(value, fmt::format("expected text, found {}", found_text(value.json())));
  into = value.json().get<std::string>();
  if (holds_control_characters(into))
    complain(value, fmt::format("{} holds control characters", found_text(value.json())));
}

void TableReader::read(const LocatedValue& value, bool& into, const Bounds&) {
  if (!value.json().is_boolean())
    return complain(value,
                    fmt::format("expected true or false, found {}", found_text(value.json())));
  into = value.json().get<bool>();
}

std::optional<double> TableReader::read_number(const LocatedValue& value, const Bounds& bounds) {
  const std::string accepted = range_text(bounds.range, bounds.unit);
  if (!value.json().is_number()) {
    complain(value,
             fmt::format("expected a number ({}), found {}", accepted, found_text(value.json())));
    return std::nullopt;
  }
  const double number = value.json().get<double>();
  if (!(number >= bounds.range.min && number <= bounds.range.max)) {
    complain(value,
             fmt::format("{} is out of range; accepted: {}", found_text(value.json()), accepted));
    return std::nullopt;
  }
  return number;
}

void TableReader::read(const LocatedValue& value, double& into, const Bounds& bounds) {
  into = read_number(value, bounds).value_or(into);
}

void TableReader::read(const LocatedValue& value, float& into, const Bounds& bounds) {
  if (const auto number = read_number(value, bounds))
    into = static_cast<float>(*number);
}

void TableReader::read(const LocatedValue& value, int& into, const Bounds& bounds) {
  const auto number = read_number(value, bounds);
  if (!number)
    return;
  into = static_cast<int>(*number);
  if (into != *number)
    complain(value, fmt::format("{} is not a whole number; accepted: {}", found_text(value.json()),
                                range_text(bounds.range, bounds.unit)));
}

void TableReader::read(const LocatedValue& value, FrameRate& into, const Bounds& bounds) {
  std::optional<FrameRate> rate;
  if (value.json().is_string())
    rate = rate_of(value.json().get<std::string>());
  else if (const auto number = read_number(value, bounds))
    rate = rate_of(*number);
  else
    return;
  const std::string found = found_text(value.json()),
                    accepted = range_text(bounds.range, bounds.unit);
  if (!rate)
    complain(value, fmt::format("{} is no frame rate; accepted: a number with up to three decimal "
                                "places, or a fraction as text, such as \"30000/1001\" ({})",
                                found, accepted));
  else if (rate->per_second() < bounds.range.min || rate->per_second() > bounds.range.max)
    complain(value, fmt::format("{} is out of range; accepted: {}", found, accepted));
  else
    into = *rate;
}

void TableReader::read(const LocatedValue& value, glm::vec3& into, const Bounds& bounds) {
  if (!value.json().is_array() || value.json().size() != 3)
    return complain(value,
                    fmt::format("expected three numbers [x, y, z] ({}), found {}",
                                range_text(bounds.range, bounds.unit), found_text(value.json())));
  for (int i = 0; i < 3; ++i)
    read(value[static_cast<std::size_t>(i)], into[i], bounds);
}

}  // namespace spindrift::app
