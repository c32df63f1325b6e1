#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>

#include "app/bench/bench.hpp"
#include "app/bench/bench_measure.hpp"
#include "app/bench/bench_report.hpp"
#include "app/bench/bench_table.hpp"
#include "app/errors/errors.hpp"
#include "app/files/folder_lock.hpp"
#include "app/run/report.hpp"
#include "app/system/interrupt.hpp"
#include "render/output/atomic_file.hpp"

namespace spindrift::app {
namespace {

/// Shows on the terminal what is running; prints nothing where stderr is not a terminal.
void show_status(const std::string& text, bool quiet) {
  if (quiet || !isatty(STDERR_FILENO))
    return;
  fmt::print(stderr, "\r\033[K{}", text);
  std::fflush(stderr);
}

std::vector<BenchRow> run_all(const std::vector<BenchRun>& runs, bool quiet) {
  std::vector<BenchRow> rows;
  for (const BenchRun& run : runs) {
    const sim::Settings& settings = run.scene.simulation;
    show_status(fmt::format("run {} of {}  {}  {}  spacing {:g} m  {} threads", rows.size() + 1,
                            runs.size(), run.scene.name, solver_name(run), settings.fluid.spacing,
                            run.threads),
                quiet);
    BenchRow row{run, measure_apart(run, InterruptGuard::requested())};
    if (InterruptGuard::requested())
      break;
    rows.push_back(std::move(row));
  }
  show_status("", quiet);
  mark_fronts(rows);
  return rows;
}

void print_tables(const std::vector<BenchRow>& rows) {
  for (const BenchSection& section : sections_of(rows)) {
    const auto shown = shown_columns(section.series);
    fmt::print("{}\n", section.title);
    for (const ShownColumn& column : shown)
      fmt::print(" {:>{}}", column.title, column.width);
    for (const BenchRow* row : section.rows) {
      fmt::print("\n");
      for (const ShownColumn& column : shown)
        fmt::print(" {:>{}}", column.text(*row), column.width);
    }
    fmt::print("\n\n");
  }
}

void write_results(const std::vector<BenchRow>& rows, const BenchOptions& options) {
  output::write_file(options.output / "bench.csv", csv_text(rows));
  output::write_file(options.output / "bench.html", report_html(rows));
}

}  // namespace

int run_bench(const BenchOptions& options) {
  const std::vector<BenchRun> runs = planned_runs(options.plan);
  const FolderLock lock(options.output, false);
  const InterruptGuard interrupt;
  const std::vector<BenchRow> rows = run_all(runs, options.quiet);
  const bool interrupted = InterruptGuard::requested();
  write_results(rows, options);
  if (options.json)
    fmt::print("{}\n", nlohmann::ordered_json{{"versions", versions_json()},
                                              {"machine", machine_text()},
                                              {"runs", rows_json(rows)}}
                           .dump(1));
  else if (!options.quiet)
    print_tables(rows);
  if (interrupted) {
    fmt::print(stderr, "spindrift: interrupted after {} of {} runs; they are in {}\n", rows.size(),
               runs.size(), (options.output / "bench.html").string());
    return run_failed;
  }
  if (std::all_of(rows.begin(), rows.end(),
                  [](const BenchRow& row) { return !row.result.failure.empty(); })) {
    fmt::print(stderr, "spindrift: no run reached its end; the first: {}\n",
               rows.front().result.failure);
    return run_failed;
  }
  if (!options.quiet && !options.json)
    fmt::print("{}\n", (options.output / "bench.html").string());
  return done;
}

}  // namespace spindrift::app
