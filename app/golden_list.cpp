#include "app/golden_list.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "app/scene_document.hpp"
#include "app/scene_reader.hpp"
#include "sim/backend_choice.hpp"

namespace spindrift::app {
namespace {

bool names_a_folder(const std::string& name) {
  const char* accepted = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-";
  return !name.empty() && name.find_first_not_of(accepted) == std::string::npos;
}

/// Completes and checks the list's entries in their order.
class Completion {
 public:
  Completion(const SceneDocument& document, const std::filesystem::path& folder, GoldenList& list)
      : document_(document), folder_(folder), list_(list) {}

  void complete(std::size_t k, const Overrides& overrides) {
    path_ = child_path("goldens", k);
    name(k);
    read(overrides);
    check_frames();
  }

 private:
  /// A value that the list lays over a scene, as after `--set`, and its own place in the list.
  struct Assignment {
    std::string text, path;
  };

  [[noreturn]] void fail_at(const std::string& path, std::string_view message) const {
    throw SceneError(fmt::format("{}: {}: {}", document_.place_of(path), path, message));
  }

  [[noreturn]] void fail(std::string_view key, std::string_view message) const {
    fail_at(child_path(path_, key), message);
  }

  void name(std::size_t k) {
    Golden& golden = list_.goldens[k];
    golden_ = &golden;
    if (golden.name.empty())
      golden.name = std::filesystem::path(golden.scene).stem().string();
    if (!names_a_folder(golden.name))
      fail("name", fmt::format("\"{}\" can't name a folder; accepted: letters, digits, _ and -",
                               golden.name));
    for (std::size_t other = 0; other < k; ++other)
      if (list_.goldens[other].name == golden.name)
        fail("name", fmt::format("\"{}\" is the name of {} already", golden.name,
                                 child_path("goldens", other)));
  }

  void read(const Overrides& overrides) {
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
      const std::string_view message = error.what();
      for (const auto& [text, path] : own)
        if (const auto begin = fmt::format("--set {}: ", text); message.starts_with(begin))
          fail_at(path, message.substr(begin.size()));
      fail("scene", message);
    }
    if (const std::string refused = sim::why_refused(golden_->resolved.simulation);
        !refused.empty())
      fail("scene", refused);
  }

  void check_frames() const {
    if (golden_->frames.empty())
      fail("frames", "empty; give the number of a frame at least");
    const int last = golden_->resolved.video.frame_count() - 1;
    for (const int frame : golden_->frames)
      if (frame > last)
        fail("frames", fmt::format("{} is beyond the scene's last frame, {}", frame, last));
    std::sort(golden_->frames.begin(), golden_->frames.end());
    const auto twice = std::adjacent_find(golden_->frames.begin(), golden_->frames.end());
    if (twice != golden_->frames.end())
      fail("frames", fmt::format("{} is there twice", *twice));
  }

  const SceneDocument& document_;
  const std::filesystem::path& folder_;
  GoldenList& list_;
  Golden* golden_ = nullptr;
  std::string path_;
};

}  // namespace

GoldenList read_golden_list(const std::filesystem::path& file, const Overrides& overrides) {
  const SceneDocument document(scene_text(file), file.string());
  GoldenList list;
  read_section(document, list);
  if (list.goldens.empty())
    throw SceneError(
        fmt::format("{}: goldens: empty; give a scene at least", document.place_of("goldens")));
  const std::filesystem::path folder = file.parent_path();
  Completion completion(document, folder, list);
  for (std::size_t k = 0; k < list.goldens.size(); ++k)
    completion.complete(k, overrides);
  return list;
}

}  // namespace spindrift::app
