// The stages of a run from particles to files: simulate → keep → mesh → draw → write. They run in
// four threads, so that the next frame is simulated while the last one is kept, drawn and written.
#pragma once

#include "app/resources/run_options.hpp"
#include "app/run/run_record.hpp"
#include "app/scene/scene.hpp"

namespace spindrift::app {

/// Runs the scene as the options say. Files that are finished when an error or Ctrl-C comes stay,
/// and the video is closed so that it can be played.
/// @param record receives what the run did, also where it fails
/// @throws what the failing stage threw
void run_pipeline(const Scene& scene, const RenderOptions& options, RunRecord& record);

}  // namespace spindrift::app
