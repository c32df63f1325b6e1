#include <fmt/format.h>

#include <algorithm>
#include <cstdio>

#include "app/compare/comparison.hpp"
#include "app/errors/errors.hpp"
#include "app/errors/nearest_name.hpp"
#include "app/golden/golden.hpp"
#include "app/golden/golden_list.hpp"
#include "app/run/render.hpp"
#include "app/system/interrupt.hpp"
#include "render/output/atomic_file.hpp"
#include "render/output/output.hpp"

namespace spindrift::app {
namespace {

namespace fs = std::filesystem;

/// Checks that the list has a golden test of each name.
/// @throws InputError for a name that is not in the list
void require_names(const std::vector<std::string>& only, const GoldenList& list) {
  std::vector<std::string_view> names;
  for (const Golden& golden : list.goldens)
    names.push_back(golden.name);
  for (const std::string& name : only)
    if (std::find(names.begin(), names.end(), name) == names.end())
      throw InputError(fmt::format("--only {}: there is no such golden test; {}", name,
                                   suggestion(name, names)));
}

/// Renders the golden tests of a list one after the other, and collects their results.
class GoldenRun {
 public:
  GoldenRun(const GoldenOptions& options, const GoldenList& list)
      : options_(options),
        list_(list),
        references_(options.list.parent_path() / list.references),
        report_{.title = "Spindrift golden tests",
                .a = "the reference in " + references_.string(),
                .b = "the result in " + options.output.string(),
                .threshold = list.threshold} {}

  void run(const Golden& golden) {
    const fs::path folder = options_.output / golden.name;
    const FolderLock lock(folder, false);
    for (const char* name : {"reference", "difference"}) {
      remove_pictures(folder / name);
      output::remove_part_files(folder / name);
    }
    RenderOptions render;
    render.output = folder;
    render.frames = FrameRange{golden.frames.front(), golden.frames.back()};
    render.cache = false;   // cached particles would hide a change of the solver
    render.replace = true;  // the folder belongs to this golden test, whatever scene was there
    render.quiet = true;
    Scene scene = golden.resolved;
    if (scene.probes_rate == 0)
      scene.probes.clear();  // pictures depend on probes only where time steps end at readings
    if (run_render(scene, render, lock) != done || InterruptGuard::requested()) {
      report_.not_compared.push_back(fmt::format("{}: it could not be rendered", golden.name));
      not_rendered_ = true;
      return;
    }
    for (const int frame : golden.frames) {
      const std::string file = fmt::format("{:04}.png", frame);
      const Image result = output::read_png(folder / "frames" / file);
      const fs::path reference = references_ / golden.name / file;
      if (options_.action == GoldenAction::update)
        update(reference, result);
      else
        check(golden, reference, result);
    }
  }

  int finish() {
    if (options_.action == GoldenAction::check) {
      write_comparison(report_, options_.output, "golden");
      print();
    } else {
      if (options_.json)
        fmt::print("{}\n", nlohmann::ordered_json{{"references", updated_}}.dump(1));
      fmt::print(stderr, "{}", broken_text(report_));
    }
    return not_rendered_ ? run_failed : report_.passes() ? done : check_failed;
  }

 private:
  void update(const fs::path& file, const Image& result) {
    const bool existed = fs::exists(file);
    if (existed && has_pixels(file, result))
      return say(file, "as before");
    output::make_folders(file.parent_path());
    output::write_png(file, result);
    say(file, existed ? "changed" : "new");
  }

  static bool has_pixels(const fs::path& file, const Image& image) {
    try {
      return output::read_png(file).pixels == image.pixels;
    } catch (const std::exception&) {
      return false;  // a file that can't be read is to be replaced
    }
  }

  void check(const Golden& golden, const fs::path& file, const Image& result) {
    if (!fs::exists(file))
      return unusable(file, "there is no such reference");
    Image reference;
    try {
      reference = output::read_png(file);
    } catch (const std::exception& error) {
      return unusable(file, error.what());
    }
    if (reference.width != result.width || reference.height != result.height)
      return unusable(
          file, fmt::format("the reference has {}x{} pixels, the result {}x{}", reference.width,
                            reference.height, result.width, result.height));
    const compare::Comparison pair = compare::compare(reference, result, list_.threshold);
    const compare::Metrics metrics = pair.tally.metrics();
    const Limits limits{.max_flip = golden.max_flip.value_or(list_.max_flip),
                        .max_changed = golden.max_changed.value_or(list_.max_changed)};
    report_.all.add(pair.tally);
    report_.pairs.push_back({golden.name + "/" + file.filename().string(), metrics,
                             broken_limits(metrics, limits),
                             fs::path(golden.name) / "difference" / file.filename()});
    if (!report_.pairs.back().broken.empty())
      keep(golden, file, reference, result, pair.flip);
  }

  /// Keeps the reference and the difference of a failed frame in the output folder, for people to
  /// see beside the result.
  void keep(const Golden& golden, const fs::path& file, const Image& reference, const Image& result,
            const std::vector<float>& flip) {
    report_.pairs.back().shown = shown_pair(reference, result, flip);
    const auto write = [&](const fs::path& name, const Image& image) {
      output::make_folders((options_.output / name).parent_path());
      output::write_png(options_.output / name, image);
    };
    write(fs::path(golden.name) / "reference" / file.filename(), reference);
    write(report_.pairs.back().difference, compare::magma(flip, result.width, result.height));
  }

  void unusable(const fs::path& file, const std::string& reason) {
    report_.not_compared.push_back(
        fmt::format("{}: {}; `spindrift golden update {}` makes it from the result, which is in {}",
                    file.string(), reason, options_.list.string(), options_.output.string()));
  }

  void say(const fs::path& file, const char* what) {
    updated_.push_back({{"file", file.string()}, {"result", what}});
    if (!options_.quiet && !options_.json)
      fmt::print("{:<10} {}\n", what, file.string());
  }

  void print() const {
    const std::string page = (options_.output / "golden.html").string();
    if (options_.json)
      fmt::print("{}\n", comparison_json(report_).dump(1));
    else if (!options_.quiet)
      fmt::print("{}{}\n", comparison_text(report_), page);
    fmt::print(stderr, "{}", broken_text(report_));
    if (report_.broken_pairs() > 0)
      fmt::print(stderr, "spindrift: the pictures and their differences are in {}\n", page);
  }

  const GoldenOptions& options_;
  const GoldenList& list_;
  fs::path references_;
  ComparisonReport report_;
  nlohmann::ordered_json updated_ = nlohmann::ordered_json::array();
  bool not_rendered_ = false;
};

}  // namespace

int run_golden(const GoldenOptions& options) {
  if (options.action == GoldenAction::update && !options.overrides.empty())
    throw InputError(
        "--set is for `golden check`; values that references are to have belong in the list, as "
        "\"set\" of a golden test");
  const GoldenList list = read_golden_list(options.list, options.overrides);
  require_names(options.only, list);
  const FolderLock lock(options.output, false);
  GoldenRun run(options, list);
  for (const Golden& golden : list.goldens) {
    if (options.only.empty() ||
        std::find(options.only.begin(), options.only.end(), golden.name) != options.only.end())
      run.run(golden);
    if (InterruptGuard::requested())
      break;
  }
  return run.finish();
}

}  // namespace spindrift::app
