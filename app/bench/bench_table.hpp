// The benchmark's results as rows of a table: which of them are best, and how they are written as
// CSV, as JSON and for people.
#pragma once

#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <vector>

#include "app/bench/bench_measure.hpp"

namespace spindrift::app {

/// A run and its results.
struct BenchRow {
  BenchRun run;
  Measurement result;
  bool on_mean_front = false;  ///< no comparable run is both faster and of less mean compression
  bool on_max_front = false;   ///< no comparable run is both faster and of less largest compression
};

/// The name of a run's solver as in a scene file.
std::string solver_name(const BenchRun& run);

/// Wall-clock time per simulated time; 0 where nothing was simulated.
double wall_per_simulated_second(const Measurement& m);
/// Wall-clock time per particle and accepted step, ns, with the cost of rejected steps included; 0
/// where there was no step.
double nanoseconds_per_particle_step(const Measurement& m);
double iterations_per_step(const Measurement& m);
double bytes_per_particle(const Measurement& m);

/// A point in the plane of cost and error.
struct CostAndError {
  double cost = 0;
  double error = 0;
};

/// Whether each point is on the Pareto front. It is unless another point has no more cost and no
/// more error, and less of one of both.
std::vector<bool> pareto_front(std::span<const CostAndError> points);

/// Sets on_mean_front and on_max_front of the rows of the plane. Every particle spacing of a scene
/// has fronts of its own, since a coarser liquid is always faster at the same compression, and
/// shows less. Runs that did not reach their end are on none.
void mark_fronts(std::vector<BenchRow>& rows);

/// The rows as CSV: one header line and one line for each row, with empty fields for values that a
/// run does not have.
std::string csv_text(const std::vector<BenchRow>& rows);

/// A list of objects with the names of the CSV columns as keys; values that a run does not have are
/// null.
nlohmann::ordered_json rows_json(const std::vector<BenchRow>& rows);

/// Rows that are shown together: the plane of a scene, or a scaling.
struct BenchSection {
  std::string title;
  BenchSeries series = BenchSeries::plane;
  std::vector<const BenchRow*> rows;
};

/// The rows in sections, in their order. The sections point to the rows, which must outlive them.
std::vector<BenchSection> sections_of(const std::vector<BenchRow>& rows);

/// A column of the tables that people read.
struct ShownColumn {
  const char* title;
  int width;                                 ///< in characters, on the terminal
  std::string (*text)(const BenchRow& row);  ///< the column's text of a row
};
/// The columns that are shown for a series.
std::span<const ShownColumn> shown_columns(BenchSeries series);

}  // namespace spindrift::app
