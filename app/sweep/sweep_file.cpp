#include "app/sweep/sweep_file.hpp"

#include <algorithm>
#include <utility>

#include "app/checks/scene_reader.hpp"
#include "app/tables/schema.hpp"
#include "app/tables/table_reader.hpp"

namespace spindrift::app {
namespace {

/// Whether a document has a key of sweep files, none of which is a key of scenes.
bool is_sweep(const Json& root) {
  const auto keys = keys_of<SweepFile>();
  return root.is_object() &&
         std::any_of(keys.begin(), keys.end(), [&](const auto& key) { return root.contains(key); });
}

/// The alternatives of one key of the grid.
SweepAxis axis_of(const Keyed<NonEmpty<Placed<Json>>>& list) {
  SweepAxis axis;
  for (const auto& [value, place] : list.value)
    axis.push_back({{list.key, value, place}});
  return axis;
}

}  // namespace

std::optional<SweepRequest> read_sweep_file(const std::filesystem::path& file) {
  const SceneDocument document(scene_text(file), file.string());
  if (!is_sweep(document.root()))
    return std::nullopt;
  SweepFile sweep;
  read_document(document, sweep);
  SweepRequest request{.scene = file.parent_path() / sweep.scene,
                       .axes = {},
                       .reference = std::move(sweep.reference),
                       .targets = std::move(sweep.targets),
                       .times = std::move(sweep.times)};
  for (const SweepValue& value : sweep.set)
    request.axes.push_back({{value}});
  for (const auto& list : sweep.grid)
    request.axes.push_back(axis_of(list));
  if (!sweep.list.empty())
    request.axes.push_back(std::move(sweep.list));
  if (sweep.latin_hypercube)
    request.axes.push_back(samples_of(*sweep.latin_hypercube));
  return request;
}

Json sweep_schema() {
  return document_schema<SweepFile>(
      "Spindrift sweep",
      "A scene, and what of it is varied. Keys are those of scene files, as in fluid.viscosity or "
      "fluid.volumes[0].velocity.");
}

}  // namespace spindrift::app
