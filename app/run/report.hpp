// The reports of a run: run.json for programs, and the table that is printed at its end for people.
#pragma once

#include <nlohmann/json.hpp>

#include "app/resources/run_options.hpp"
#include "app/run/run_record.hpp"
#include "app/scene/scene.hpp"

namespace spindrift::app {

/// What a run did, as the part of run.json that depends on it.
/// @param earlier the list of frames in the run.json of an earlier run of the same simulation; its
/// entries are kept for frames after those that this run reached
nlohmann::ordered_json report_json(const Scene& scene, const RunRecord& record,
                                   const nlohmann::ordered_json& earlier);

/// Prints the closing table of a run to standard output, with warnings where the density error is
/// large.
void print_table(const Scene& scene, const RenderOptions& options, const RunRecord& record);

/// The versions of the program, of its compiler and of its video encoder.
nlohmann::ordered_json versions_json();

/// The processor's name as the system gives it, or "unknown".
std::string processor_name();

/// One line with what timings depend on: processor, number of its threads, version and compiler.
std::string machine_text();

}  // namespace spindrift::app
