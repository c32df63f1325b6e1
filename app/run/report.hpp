// What a run leaves to read: run.json for machines, a closing table for people.
#pragma once

#include <nlohmann/json.hpp>

#include "app/kept/run_options.hpp"
#include "app/run/run_record.hpp"
#include "app/scene/scene.hpp"

namespace spindrift::app {

/// What a run did, for run.json.
/// @param earlier the entries of an earlier run of the same simulation for each frame: a run of the
/// first frames alone keeps what is known of those after them
nlohmann::ordered_json report_json(const Scene& scene, const RunRecord& record,
                                   const nlohmann::ordered_json& earlier);
void print_table(const Scene& scene, const RenderOptions& options, const RunRecord& record);

/// Version of the program, of its compiler and of what it writes with.
nlohmann::ordered_json versions_json();

/// The processor's name, or "unknown".
std::string processor_name();

/// What timings depend on, in a line: processor, threads, version and compiler.
std::string machine_text();

}  // namespace spindrift::app
