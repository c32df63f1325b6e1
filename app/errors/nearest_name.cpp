#include "app/errors/nearest_name.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

namespace spindrift::app {

int edit_distance(std::string_view a, std::string_view b) {
  // cost[i][j] is the cost of turning the first i letters of a into the first j letters of b.
  std::vector<std::vector<int>> cost(a.size() + 1, std::vector<int>(b.size() + 1));
  for (std::size_t i = 0; i <= a.size(); ++i) {
    for (std::size_t j = 0; j <= b.size(); ++j) {
      if (i == 0 || j == 0) {
        cost[i][j] = static_cast<int>(i + j);
        continue;
      }
      const int replaced = cost[i - 1][j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
      cost[i][j] = std::min({cost[i - 1][j] + 1, cost[i][j - 1] + 1, replaced});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
        cost[i][j] = std::min(cost[i][j], cost[i - 2][j - 2] + 1);
    }
  }
  return cost[a.size()][b.size()];
}

std::string_view nearest_name(std::string_view typed, std::span<const std::string_view> names) {
  std::string_view best;
  int best_distance = 1 + static_cast<int>(std::max<std::size_t>(1, typed.size() / 3 + 1));
  for (const std::string_view name : names) {
    const int distance = edit_distance(typed, name);
    if (distance < best_distance) {
      best = name;
      best_distance = distance;
    }
  }
  return best;
}

std::string suggestion(std::string_view typed, std::span<const std::string_view> names) {
  const std::string_view best = nearest_name(typed, names);
  if (!best.empty())
    return fmt::format("did you mean \"{}\"?", best);
  return fmt::format("accepted: {}", fmt::join(names, ", "));
}

}  // namespace spindrift::app
