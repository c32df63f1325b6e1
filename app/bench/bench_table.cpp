#include "app/bench/bench_table.hpp"

#include <fmt/format.h>

#include <cstdlib>
#include <map>
#include <utility>

#include "app/files/csv.hpp"
#include "app/scene/scene_fields.hpp"
#include "app/tables/values.hpp"

namespace spindrift::app {
namespace {

double ratio(double a, double b) {
  return b > 0 ? a / b : 0;
}

/// The value with six digits; further ones are noise.
Json rounded(double value) {
  return std::strtod(fmt::format("{:.6g}", value).c_str(), nullptr);
}

/// A positive value, or null where a run has not measured it.
Json known(double value) {
  return value > 0 ? rounded(value) : Json();
}

/// An error of a run, which may be 0, or null where no frame was measured.
Json measured(const Measurement& m, double value) {
  return m.simulated_seconds > 0 ? rounded(value) : Json();
}

struct Column {
  std::string_view name;
  Json (*value)(const BenchRow&);
};

using Row = BenchRow;

const sim::SolverSettings& solver(const Row& row) {
  return row.run.scene.simulation.solver;
}

// The columns of bench.csv and the keys of --json.
constexpr Column columns[] = {
    {"series",
     [](const Row& r) {
       constexpr const char* names[] = {"plane", "particles", "threads"};
       return Json(names[static_cast<int>(r.run.series)]);
     }},
    {"scene", [](const Row& r) { return Json(r.run.scene.name); }},
    {"solver", [](const Row& r) { return Json(solver_name(r.run)); }},
    {"spacing_m", [](const Row& r) { return json_of(r.run.scene.simulation.fluid.spacing); }},
    {"mean_tolerance", [](const Row& r) { return json_of(solver(r).mean_compression); }},
    {"max_tolerance", [](const Row& r) { return json_of(solver(r).max_compression); }},
    {"speed_of_sound_m_per_s", [](const Row& r) { return json_of(solver(r).speed_of_sound); }},
    {"cfl", [](const Row& r) { return json_of(solver(r).cfl); }},
    {"max_time_step_s", [](const Row& r) { return json_of(solver(r).max_time_step); }},
    {"threads", [](const Row& r) { return Json(r.run.threads); }},
    {"repetitions", [](const Row& r) { return Json(r.run.repetitions); }},
    {"particles", [](const Row& r) { return Json(r.result.particles); }},
    {"boundary_particles", [](const Row& r) { return Json(r.result.boundary_particles); }},
    {"simulated_s", [](const Row& r) { return rounded(r.result.simulated_seconds); }},
    {"wall_s", [](const Row& r) { return rounded(r.result.wall_seconds); }},
    {"wall_s_per_simulated_s",
     [](const Row& r) { return known(wall_per_simulated_second(r.result)); }},
    {"steps", [](const Row& r) { return Json(r.result.steps); }},
    {"refused_steps", [](const Row& r) { return Json(r.result.rejected_steps); }},
    {"iterations_per_step",
     [](const Row& r) { return measured(r.result, iterations_per_step(r.result)); }},
    {"ns_per_particle_step",
     [](const Row& r) { return known(nanoseconds_per_particle_step(r.result)); }},
    {"bytes_per_particle", [](const Row& r) { return known(bytes_per_particle(r.result)); }},
    {"peak_bytes",
     [](const Row& r) { return r.result.peak_bytes > 0 ? Json(r.result.peak_bytes) : Json(); }},
    {"mean_compression",
     [](const Row& r) { return measured(r.result, r.result.mean_compression); }},
    {"max_compression", [](const Row& r) { return measured(r.result, r.result.max_compression); }},
    {"energy_ratio", [](const Row& r) { return known(r.result.energy_ratio); }},
    {"max_speed_m_per_s", [](const Row& r) { return measured(r.result, r.result.max_speed); }},
    {"on_mean_front", [](const Row& r) { return Json(r.on_mean_front); }},
    {"on_max_front", [](const Row& r) { return Json(r.on_max_front); }},
    {"failure", [](const Row& r) { return Json(r.result.failure); }},
};

/// A value as a cell of bench.csv.
std::string cell_of(const Json& value) {
  if (value.is_null())
    return "";
  return value.is_string() ? value.get<std::string>() : value.dump();
}

// The columns that are shown to people follow.

std::string percent(double fraction) {
  return fmt::format("{:.3g}", 100 * fraction);
}
std::string spacing_text(const Row& r) {
  return fmt::format("{:g}", r.run.scene.simulation.fluid.spacing);
}
/// The tolerance of a run: for PCISPH the mean one, as the largest is varied with it; for basic SPH
/// the speed of sound.
std::string tolerance_text(const Row& r) {
  if (solver(r).type == sim::SolverType::pcisph)
    return percent(solver(r).mean_compression) + " %";
  return solver(r).speed_of_sound > 0 ? fmt::format("{:.3g} m/s", solver(r).speed_of_sound)
                                      : "auto";
}
std::string step_limit_text(const Row& r) {
  return fmt::format("{:g}", 1e3f * solver(r).max_time_step);
}
std::string front_text(const Row& r) {
  if (!r.result.failure.empty())
    return r.result.failure;
  return r.on_mean_front ? (r.on_max_front ? "both" : "mean") : (r.on_max_front ? "max" : "");
}

constexpr ShownColumn particles_shown{
    "particles", 9, [](const Row& r) { return fmt::format("{}", r.result.particles); }};
constexpr ShownColumn threads_shown{"threads", 7,
                                    [](const Row& r) { return fmt::format("{}", r.run.threads); }};
constexpr ShownColumn wall_shown{
    "wall s/s", 8,
    [](const Row& r) { return fmt::format("{:.3g}", wall_per_simulated_second(r.result)); }};
constexpr ShownColumn steps_shown{"steps", 6,
                                  [](const Row& r) { return fmt::format("{}", r.result.steps); }};
constexpr ShownColumn refused_shown{
    "refused", 7, [](const Row& r) { return fmt::format("{}", r.result.rejected_steps); }};
constexpr ShownColumn iterations_shown{
    "iterations", 10,
    [](const Row& r) { return fmt::format("{:.2f}", iterations_per_step(r.result)); }};
constexpr ShownColumn nanoseconds_shown{
    "ns/p/step", 9,
    [](const Row& r) { return fmt::format("{:.0f}", nanoseconds_per_particle_step(r.result)); }};
constexpr ShownColumn bytes_shown{
    "bytes/p", 7, [](const Row& r) { return fmt::format("{:.0f}", bytes_per_particle(r.result)); }};
constexpr ShownColumn peak_shown{"peak MB", 7, [](const Row& r) {
                                   return fmt::format("{:.0f}", double(r.result.peak_bytes) / 1e6);
                                 }};
constexpr ShownColumn mean_shown{"mean %", 7,
                                 [](const Row& r) { return percent(r.result.mean_compression); }};
constexpr ShownColumn max_shown{"max %", 6,
                                [](const Row& r) { return percent(r.result.max_compression); }};

constexpr ShownColumn plane_shown[] = {
    {"solver", 6, [](const Row& r) { return solver_name(r.run); }},
    {"spacing m", 9, spacing_text},
    {"tolerance", 9, tolerance_text},
    {"cfl", 5, [](const Row& r) { return fmt::format("{:g}", solver(r).cfl); }},
    {"step ms", 7, step_limit_text},
    particles_shown,
    wall_shown,
    steps_shown,
    refused_shown,
    iterations_shown,
    nanoseconds_shown,
    bytes_shown,
    peak_shown,
    mean_shown,
    max_shown,
    {"energy", 6, [](const Row& r) { return fmt::format("{:.3f}", r.result.energy_ratio); }},
    {"fastest", 7, [](const Row& r) { return fmt::format("{:.1f}", r.result.max_speed); }},
    {"front", 5, front_text}};

constexpr ShownColumn scaling_shown[] = {
    particles_shown,
    threads_shown,
    {"runs", 4, [](const Row& r) { return fmt::format("{}", r.run.repetitions); }},
    {"wall s", 7, [](const Row& r) { return fmt::format("{:.2f}", r.result.wall_seconds); }},
    steps_shown,
    refused_shown,
    iterations_shown,
    nanoseconds_shown,
    bytes_shown,
    peak_shown,
    mean_shown,
    max_shown,
    {"", 0, [](const Row& r) { return r.result.failure; }}};

}  // namespace

std::string solver_name(const BenchRun& run) {
  return json_of(run.scene.simulation.solver.type).get<std::string>();
}

double wall_per_simulated_second(const Measurement& m) {
  return ratio(m.wall_seconds, m.simulated_seconds);
}
double nanoseconds_per_particle_step(const Measurement& m) {
  return ratio(1e9 * m.wall_seconds, static_cast<double>(m.particles) * double(m.steps));
}
double iterations_per_step(const Measurement& m) {
  return ratio(double(m.iterations), double(m.steps));
}
double bytes_per_particle(const Measurement& m) {
  return ratio(static_cast<double>(m.simulation_bytes), static_cast<double>(m.particles));
}

std::vector<bool> pareto_front(std::span<const CostAndError> points) {
  std::vector<bool> front;
  for (const CostAndError& p : points) {
    bool best = true;
    for (const CostAndError& q : points)
      best = best &&
             !(q.cost <= p.cost && q.error <= p.error && (q.cost < p.cost || q.error < p.error));
    front.push_back(best);
  }
  return front;
}

void mark_fronts(std::vector<BenchRow>& rows) {
  std::map<std::pair<std::string, float>, std::vector<BenchRow*>> groups;
  for (BenchRow& row : rows) {
    row.on_mean_front = row.on_max_front = false;
    if (row.run.series == BenchSeries::plane && row.result.failure.empty())
      groups[{row.run.scene.name, row.run.scene.simulation.fluid.spacing}].push_back(&row);
  }
  for (const auto& [key, group] : groups) {
    std::vector<CostAndError> mean, max;
    for (const BenchRow* row : group) {
      mean.push_back({wall_per_simulated_second(row->result), row->result.mean_compression});
      max.push_back({wall_per_simulated_second(row->result), row->result.max_compression});
    }
    const auto mean_front = pareto_front(mean), max_front = pareto_front(max);
    for (std::size_t i = 0; i < group.size(); ++i) {
      group[i]->on_mean_front = mean_front[i];
      group[i]->on_max_front = max_front[i];
    }
  }
}

std::string csv_text(const std::vector<BenchRow>& rows) {
  std::vector<std::string> cells;
  for (const Column& column : columns)
    cells.emplace_back(column.name);
  std::string text = csv_row(cells);
  for (const BenchRow& row : rows) {
    cells.clear();
    for (const Column& column : columns)
      cells.push_back(cell_of(column.value(row)));
    text += csv_row(cells);
  }
  return text;
}

nlohmann::ordered_json rows_json(const std::vector<BenchRow>& rows) {
  auto list = Json::array();
  for (const BenchRow& row : rows) {
    auto object = Json::object();
    for (const Column& column : columns)
      object[std::string(column.name)] = column.value(row);
    list.push_back(object);
  }
  return list;
}

std::vector<BenchSection> sections_of(const std::vector<BenchRow>& rows) {
  std::vector<BenchSection> sections;
  for (const BenchRow& row : rows) {
    const BenchSeries series = row.run.series;
    const std::string title =
        series == BenchSeries::plane       ? row.run.scene.name + ": speed against error"
        : series == BenchSeries::particles ? "built-in dam break: scaling over particles"
                                           : "built-in dam break: scaling over threads";
    if (sections.empty() || sections.back().title != title)
      sections.push_back({title, series, {}});
    sections.back().rows.push_back(&row);
  }
  return sections;
}

std::span<const ShownColumn> shown_columns(BenchSeries series) {
  if (series == BenchSeries::plane)
    return plane_shown;
  return scaling_shown;
}

}  // namespace spindrift::app
