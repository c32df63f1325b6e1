// The benchmark's results as rows: which are best, and how they are written down.
#pragma once

#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <vector>

#include "app/bench/bench_measure.hpp"

namespace spindrift::app {

struct BenchRow {
  BenchRun run;
  Measurement result;
  bool on_mean_front = false;  ///< no other is both faster and of less mean compression
  bool on_max_front = false;   ///< the same for the largest compression
};

/// As in a scene file.
std::string solver_name(const BenchRun& run);

/// Wall seconds for a simulated one; 0 where nothing was simulated.
double wall_per_simulated_second(const Measurement& m);
/// Of the accepted steps, what the refused ones cost included; 0 where there was no step.
double nanoseconds_per_particle_step(const Measurement& m);
double iterations_per_step(const Measurement& m);
double bytes_per_particle(const Measurement& m);

struct CostAndError {
  double cost = 0;
  double error = 0;
};

/// The Pareto front: true for a point unless another costs no more and errs no more, and one of
/// both less.
std::vector<bool> pareto_front(std::span<const CostAndError> points);

/// Marks the fronts of the plane. Every spacing of a scene has fronts of its own, since a coarser
/// liquid is always faster at the same compression, and shows less. Runs that did not reach their
/// end are on none.
void mark_fronts(std::vector<BenchRow>& rows);

/// One header line and one line for each row; what a run has not is left empty.
std::string csv_text(const std::vector<BenchRow>& rows);

/// A list of objects with the columns' names as keys; what a run has not is null.
nlohmann::ordered_json rows_json(const std::vector<BenchRow>& rows);

/// Rows that are shown together: a scene's plane, or a scaling.
struct BenchSection {
  std::string title;
  BenchSeries series = BenchSeries::plane;
  std::vector<const BenchRow*> rows;
};

/// The rows in sections, in their order.
std::vector<BenchSection> sections_of(const std::vector<BenchRow>& rows);

/// A row's value as people read it, of those that a series shows.
struct ShownColumn {
  const char* title;
  int width;
  std::string (*text)(const BenchRow& row);
};
std::span<const ShownColumn> shown_columns(BenchSeries series);

}  // namespace spindrift::app
