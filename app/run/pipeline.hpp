// From particles to files: simulate → keep → mesh → draw → write, in four threads, so that the next
// frame is simulated while the last one is kept, drawn and written.
#pragma once

#include "app/kept/run_options.hpp"
#include "app/run/run_record.hpp"
#include "app/scene/scene.hpp"

namespace spindrift::app {

/// Runs the scene as the options say. What is finished when an error or Ctrl-C comes stays, and the
/// video is closed so that it plays. @throws what the failing stage threw
void run_pipeline(const Scene& scene, const RenderOptions& options, RunRecord& record);

}  // namespace spindrift::app
