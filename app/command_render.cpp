#include <fmt/format.h>

#include <exception>
#include <functional>

#include "app/commands.hpp"
#include "app/error_report.hpp"
#include "app/pipeline.hpp"
#include "app/report.hpp"
#include "render/output/atomic_file.hpp"

namespace spindrift::app {
namespace {

/// Says what is left of a run that did not reach its end, and how to go on.
void print_rest(const RenderOptions& options, const RunRecord& record, const char* reason) {
  const std::string video =
      options.simulate_only || record.frames_finished == 0
          ? std::string()
          : fmt::format("; {} plays them", (options.output / "video.mp4").string());
  fmt::print(stderr, "spindrift: {} after {} of {} frames{}\n", reason, record.frames_finished,
             record.frames_wanted, video);
  if (options.cache && !options.from_particles)
    fmt::print(stderr, "The same command goes on from where it stopped: {}\n",
               options.command_line_hint);
}

void write_probes(const Scene& scene, const RenderOptions& options, const RunRecord& record) {
  output::write_file(options.output / "probes.csv", probes_csv(scene, record.probe_readings));
  PlotDrawer draw;
  output::write_file(options.output / "probes.html",
                     probes_html(scene, record.probe_readings, std::ref(draw)));
  if (!draw.failure().empty())
    fmt::print(stderr, "spindrift: {}; probes.html is without plots\n", draw.failure());
  if (record.frames_read_once > 0 && !options.quiet)
    fmt::print(
        stderr,
        "spindrift: {} frames were kept from before without these probes, which are read once a "
        "frame there; --no-cache reads them {:g} times a second\n",
        record.frames_read_once, scene.probes_rate);
}

void write_report(const Scene& scene, const RenderOptions& options, const RunRecord& record) {
  if (!scene.probes.empty())
    write_probes(scene, options, record);
  output::write_file(options.output / "run.json", report_json(scene, record).dump(1) + "\n");
}

}  // namespace

int run_render(const Scene& scene, const RenderOptions& options) {
  std::filesystem::create_directories(options.output);
  RunRecord record;
  try {
    run_pipeline(scene, options, record);
  } catch (const std::exception& error) {
    tell_error(run_failed, error.what(), options.json);
    print_rest(options, record, "stopped");
    try {
      write_report(scene, options, record);
    } catch (const std::exception&) {
      // What stopped the run, a full disk say, may keep the report from being written as well; the
      // reason has been told.
    }
    return run_failed;
  }
  write_report(scene, options, record);
  if (record.interrupted) {
    print_rest(options, record, "interrupted");
    if (options.json)
      print_error_json(run_failed, "interrupted");
    return run_failed;
  }
  if (options.json)
    fmt::print("{}\n", report_json(scene, record).dump(1));
  else if (!options.quiet)
    print_table(scene, options, record);
  return done;
}

}  // namespace spindrift::app
