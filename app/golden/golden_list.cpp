#include "app/golden/golden_list.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <utility>

#include "app/checks/scene_reader.hpp"
#include "app/errors/shown_text.hpp"
#include "app/tables/table_reader.hpp"
#include "sim/run/backend_choice.hpp"

namespace spindrift::app {
namespace {

bool names_a_folder(const std::string& name) {
  const char* accepted = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-";
  return !name.empty() && name.find_first_not_of(accepted) == std::string::npos;
}

/// Fills in and checks the list's entries in their order, and collects their problems.
class Completion {
 public:
  Completion(const SceneDocument& document, const std::filesystem::path& folder, GoldenList& list)
      : document_(document), folder_(folder), list_(list) {}

  void complete(std::size_t k, const Overrides& overrides) {
    path_ = child_path("goldens", k);
    golden_ = &list_.goldens[k];
    name(k);
    if (read(overrides))
      check_frames();
  }

  std::vector<Problem> problems() && { return std::move(problems_); }

 private:
  /// A value that the list sets in a scene, in the form KEY=VALUE, and its key path in the list.
  struct Assignment {
    std::string text, path;
  };

  void complain(std::string_view key, std::string message) {
    problems_.push_back(document_.problem(child_path(path_, key), std::move(message)));
  }

  void name(std::size_t k) {
    if (golden_->name.empty())
      golden_->name = std::filesystem::path(golden_->scene).stem().string();
    if (!names_a_folder(golden_->name))
      complain("name", fmt::format("\"{}\" can't name a folder; accepted: letters, digits, _ and -",
                                   shown(golden_->name)));
    if (const auto [first, is_new] = names_.emplace(golden_->name, k); !is_new)
      complain("name", fmt::format("\"{}\" is the name of {} already", shown(golden_->name),
                                   child_path("goldens", first->second)));
  }

  /// Reads the scene of the current entry.
  /// @return whether the scene can be used
  bool read(const Overrides& overrides) {
    const auto size = [&](const char* key, std::optional<int> own, int all) {
      return Assignment{fmt::format("video.{}={}", key, own.value_or(all)),
                        own ? child_path(path_, key) : key};
    };
    std::vector<Assignment> own;
    for (std::size_t k = 0; k < golden_->set.size(); ++k)
      own.push_back({golden_->set[k], child_path(child_path(path_, "set"), k)});
    own.push_back(size("width", golden_->width, list_.width));
    own.push_back(size("height", golden_->height, list_.height));
    Overrides all;
    for (const Assignment& assignment : own)
      all.push_back(assignment.text);
    all.insert(all.end(), overrides.begin(), overrides.end());
    try {
      golden_->resolved = read_scene(folder_ / golden_->scene, all);
    } catch (const SceneError& error) {
      for (const Problem& problem : error.problems())
        problems_.push_back(in_the_list(problem, own));
      return false;
    }
    const std::string refused = sim::why_refused(golden_->resolved.simulation);
    if (!refused.empty())
      complain("scene", refused);
    return refused.empty();
  }

  /// The problem of a scene, with the place in the list that causes it.
  Problem in_the_list(Problem problem, const std::vector<Assignment>& own) const {
    for (const auto& [text, path] : own)
      if (problem.place.source == "--set " + text) {
        problem.place = {};
        return document_.problem(path, problem.text());
      }
    return document_.problem(child_path(path_, "scene"), problem.text());
  }

  void check_frames() {
    const int last = golden_->resolved.video.frame_count() - 1;
    std::sort(golden_->frames.begin(), golden_->frames.end());
    if (golden_->frames.back() > last)
      complain("frames", fmt::format("{} is beyond the scene's last frame, {}",
                                     golden_->frames.back(), last));
    const auto twice = std::adjacent_find(golden_->frames.begin(), golden_->frames.end());
    if (twice != golden_->frames.end())
      complain("frames", fmt::format("{} is there twice", *twice));
  }

  const SceneDocument& document_;
  const std::filesystem::path& folder_;
  GoldenList& list_;
  Golden* golden_ = nullptr;
  std::string path_;
  std::map<std::string, std::size_t> names_;
  std::vector<Problem> problems_;
};

}  // namespace

GoldenList read_golden_list(const std::filesystem::path& file, const Overrides& overrides) {
  const SceneDocument document(scene_text(file), file.string());
  GoldenList list;
  read_document(document, list);
  const std::filesystem::path folder = file.parent_path();
  Completion completion(document, folder, list);
  for (std::size_t k = 0; k < list.goldens.size(); ++k)
    completion.complete(k, overrides);
  throw_if_any(std::move(completion).problems());
  return list;
}

}  // namespace spindrift::app
