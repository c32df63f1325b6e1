#include <fmt/format.h>
#include <omp.h>

#include <algorithm>
#include <cstdio>

#include "app/compare/compare.hpp"
#include "app/compare/comparison.hpp"
#include "app/compare/picture_source.hpp"
#include "app/errors/errors.hpp"
#include "app/files/folder_lock.hpp"
#include "app/files/json_file.hpp"
#include "app/system/threads.hpp"
#include "app/tables/document.hpp"
#include "render/output/atomic_file.hpp"

namespace spindrift::app {
namespace {

namespace fs = std::filesystem;

/// Appends a sentence for each value that differs between two scenes, with its key path and both
/// values.
void list_differences(const Json& a, const Json& b, const std::string& path,
                      std::vector<std::string>& into) {
  if (a == b)
    return;
  if (a.is_object() && b.is_object()) {
    for (const auto& [key, value] : a.items())
      list_differences(value, b.contains(key) ? b.at(key) : Json(), child_path(path, key), into);
    for (const auto& [key, value] : b.items())
      if (!a.contains(key))
        list_differences(Json(), value, child_path(path, key), into);
  } else if (a.is_array() && b.is_array() && a.size() == b.size() && !a.empty() &&
             a.front().is_structured()) {
    for (std::size_t k = 0; k < a.size(); ++k)
      list_differences(a[k], b[k], child_path(path, k), into);
  } else {
    into.push_back(fmt::format("{}: {} and {}", path, a.dump(), b.dump()));
  }
}

/// The resolved scene of a folder that `render` made; null for other folders.
Json scene_of_run(const fs::path& folder) {
  const Json run = json_in(folder / "run.json");
  return run.is_object() ? run.value("scene", Json()) : Json();
}

std::vector<std::string> scene_differences(const fs::path& a, const fs::path& b) {
  std::vector<std::string> differences;
  const Json first = scene_of_run(a), second = scene_of_run(b);
  if (!first.is_null() && !second.is_null())
    list_differences(first, second, "", differences);
  return differences;
}

void require_same_size(const PictureSource& a, const Picture& p, const PictureSource& b,
                       const Picture& q) {
  if (p.image.width != q.image.width || p.image.height != q.image.height)
    throw InputError(fmt::format(
        "{}, picture {}: {}x{} pixels; {}, picture {}: {}x{} pixels; pictures must be of one size",
        a.path().string(), p.name, p.image.width, p.image.height, b.path().string(), q.name,
        q.image.width, q.image.height));
}

/// Keeps the pictures of the last pair for the report if it is among the `most` pairs with the
/// largest mean FLIP, and drops those of the pair that it pushes out.
void show_worst(std::vector<ComparedPair>& pairs, const Picture& p, const Picture& q,
                const std::vector<float>& flip, int most) {
  const auto mean = [](const ComparedPair& pair) { return pair.metrics.flip.mean; };
  std::vector<ComparedPair*> shown;
  for (ComparedPair& pair : pairs)
    if (pair.shown)
      shown.push_back(&pair);
  if (static_cast<int>(shown.size()) >= most) {
    const auto least = std::min_element(shown.begin(), shown.end(),
                                        [&](auto* x, auto* y) { return mean(*x) < mean(*y); });
    if (least == shown.end() || mean(**least) >= mean(pairs.back()))
      return;
    (*least)->shown.reset();
  }
  pairs.back().shown = shown_pair(p.image, q.image, flip);
}

ComparisonReport compared(PictureSource& a, PictureSource& b, const CompareOptions& options) {
  const fs::path differences = options.output / "differences";
  for (const PictureSource* source : {&a, &b})
    if (fs::exists(differences) && fs::equivalent(source->path(), differences))
      throw InputError(fmt::format(
          "{}: the differences would take the place of these pictures; give another folder by -o",
          source->path().string()));
  output::make_folders(differences);
  output::remove_part_files(differences);
  remove_pictures(differences);
  ComparisonReport comparison{.title = "Spindrift comparison",
                              .a = a.path().string(),
                              .b = b.path().string(),
                              .frames = true,
                              .threshold = options.threshold};
  for (;;) {
    const std::optional<Picture> p = a.next(), q = b.next();
    if (!p && !q)
      return comparison;
    if (!p || !q)
      throw InputError(fmt::format("{} ends after {} picture{}, {} goes on",
                                   (p ? b : a).path().string(), comparison.pairs.size(),
                                   comparison.pairs.size() == 1 ? "" : "s",
                                   (p ? a : b).path().string()));
    require_same_size(a, *p, b, *q);
    const compare::Comparison pair = compare::compare(p->image, q->image, options.threshold);
    const compare::Metrics metrics = pair.tally.metrics();
    comparison.all.add(pair.tally);
    const fs::path difference =
        fs::path("differences") / fs::path(p->name).replace_extension(".png");
    comparison.pairs.push_back(
        {p->name, metrics, broken_limits(metrics, options.limits), difference});
    show_worst(comparison.pairs, *p, *q, pair.flip, options.shown_pairs);
    output::write_png(options.output / difference,
                      compare::magma(pair.flip, p->image.width, p->image.height));
  }
}

}  // namespace

int run_compare(const CompareOptions& options) {
  PictureSource a(options.a), b(options.b);
  require_same_names(a, b);
  require_threads(omp_get_max_threads() - 1);
  const FolderLock lock(options.output, false);
  ComparisonReport comparison = compared(a, b, options);
  if (comparison.pairs.empty())
    throw InputError(
        fmt::format("{} and {} have no pictures", options.a.string(), options.b.string()));
  comparison.notes = scene_differences(options.a, options.b);
  write_comparison(comparison, options.output, "compare");
  if (options.json)
    fmt::print("{}\n", comparison_json(comparison).dump(1));
  else if (!options.quiet)
    fmt::print("{}{}\n", comparison_text(comparison), (options.output / "compare.html").string());
  fmt::print(stderr, "{}", broken_text(comparison));
  return comparison.passes() ? done : check_failed;
}

}  // namespace spindrift::app
