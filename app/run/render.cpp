#include <fmt/format.h>
#include <omp.h>

#include <exception>

#include "app/errors/error_report.hpp"
#include "app/errors/errors.hpp"
#include "app/resources/resource_check.hpp"
#include "app/run/pipeline.hpp"
#include "app/run/render.hpp"
#include "app/run/report.hpp"
#include "app/run/run_folder.hpp"
#include "app/system/machine_limits.hpp"
#include "app/system/threads.hpp"

namespace spindrift::app {
namespace {

/// Prints how far a run came that did not reach its end, and how to continue it.
void print_rest(const RenderOptions& options, const RunRecord& record, const char* reason) {
  const std::string video =
      record.video.empty() ? std::string() : fmt::format("; {} plays them", record.video.string());
  fmt::print(stderr, "spindrift: {} after {} of {} frames{}\n", reason, record.frames_finished,
             record.frames_wanted, video);
  if (options.cache && !options.from_particles)
    fmt::print(stderr, "The same command goes on from where it stopped: {}\n",
               options.command_line_hint);
}

void tell_about_probes(const Scene& scene, const RenderOptions& options, const RunRecord& record) {
  if (record.frames_read_once > 0 && !options.quiet)
    fmt::print(
        stderr,
        "spindrift: {} frames were kept from before without these probes, which are read once a "
        "frame there; --no-cache reads them {:g} times a second\n",
        record.frames_read_once, scene.probes_rate);
}

}  // namespace

int run_render(const Scene& scene, const RenderOptions& options) {
  require_resources(scene, options);
  const FolderLock lock(options.output, false);
  return run_render(scene, options, lock);
}

int run_render(const Scene& scene, const RenderOptions& options, const FolderLock&) {
  require_threads(threads_of_run(options.threads > 0 ? options.threads : omp_get_max_threads()));
  RunFolder folder(scene, options);
  folder.begin();
  RunRecord record;
  try {
    run_pipeline(scene, options, record);
  } catch (const std::exception& error) {
    tell_error(run_failed, reason_of(error), options.json);
    print_rest(options, record, "stopped");
    try {
      folder.write_probes(record);
      folder.finish(record);
    } catch (const std::exception&) {
      // What stopped the run, a full disk say, may keep the report from being written as well; the
      // reason has been told.
    }
    return run_failed;
  }
  folder.write_probes(record);
  const nlohmann::ordered_json report = folder.finish(record);
  tell_about_probes(scene, options, record);
  if (record.interrupted) {
    print_rest(options, record, "interrupted");
    if (options.json)
      print_error_json(run_failed, "interrupted");
    return run_failed;
  }
  if (options.json)
    fmt::print("{}\n", report.dump(1));
  else if (!options.quiet)
    print_table(scene, options, record);
  return done;
}

}  // namespace spindrift::app
