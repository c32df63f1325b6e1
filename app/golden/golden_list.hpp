// Reads lists of golden tests. Each test names frames of a scene that are compared with reference
// pictures.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/scene/scene.hpp"
#include "app/tables/table.hpp"
#include "render/compare/metrics.hpp"

namespace spindrift::app {

/// One golden test of a list. Sizes and limits that are absent here are those of the list.
struct Golden {
  std::string scene;                 ///< scene file, relative to the list's folder
  std::string name;                  ///< folder of its pictures; by default the scene file's stem
  NonEmpty<int> frames;              ///< frame numbers, from 0
  Overrides set;                     ///< values to set in the scene
  std::optional<int> width, height;  ///< size of the pictures, pixels, even
  std::optional<double> max_flip, max_changed;  ///< largest accepted values, as in Limits
  Scene resolved;  ///< the scene with these values and this size; not in the file
};

struct GoldenList {
  std::string references = "references";  ///< folder of the pictures, relative to the list's folder
  int width = 320;                        ///< of the pictures, pixels, even
  int height = 180;                       ///< of the pictures, pixels, even
  double max_flip = 0.02;                 ///< largest accepted mean of FLIP of a frame
  double max_changed = 0.005;             ///< largest accepted share of changed pixels of a frame
  int threshold = compare::default_threshold;  ///< a pixel has changed if a channel, 0 ... 255,
                                               ///< differs by more
  NonEmpty<Golden> goldens;
};

template <>
inline constexpr auto table<Golden> = std::tuple{
    Field{"scene",
          &Golden::scene,
          "the scene file, from the list's folder",
          {},
          {},
          Presence::required},
    Field{"frames",
          &Golden::frames,
          "numbers of the frames, from 0",
          Range{0, 1e6},
          {},
          Presence::required},
    Field{"name", &Golden::name, "names the pictures; the scene file's stem if left out"},
    Field{"set", &Golden::set, "values of the scene to change, as \"fluid.viscosity=0.05\""},
    Field{"width", &Golden::width, "of the pictures, even", Range{16, 8192}, "pixels"},
    Field{"height", &Golden::height, "of the pictures, even", Range{16, 8192}, "pixels"},
    Field{"max_flip", &Golden::max_flip, "largest mean of FLIP", Range{0, 1}},
    Field{"max_changed", &Golden::max_changed, "largest share of changed pixels", Range{0, 1}}};

template <>
inline constexpr auto table<GoldenList> = std::tuple{
    Field{"references", &GoldenList::references, "folder of the pictures, from the list's folder"},
    Field{"width", &GoldenList::width, "of the pictures, even", Range{16, 8192}, "pixels"},
    Field{"height", &GoldenList::height, "of the pictures, even", Range{16, 8192}, "pixels"},
    Field{"max_flip", &GoldenList::max_flip, "largest mean of FLIP", Range{0, 1}},
    Field{"max_changed", &GoldenList::max_changed, "largest share of changed pixels", Range{0, 1}},
    Field{"threshold", &GoldenList::threshold,
          "a pixel has changed where a channel is off by more, of 255", Range{0, 254}},
    Field{"goldens", &GoldenList::goldens, "what is rendered", {}, {}, Presence::required}};

/// Reads a list and all its scenes.
/// @param overrides values to set in every scene, after those that the list sets
/// @throws SceneError with every problem of the list and its scenes, each with its place in the
/// list
GoldenList read_golden_list(const std::filesystem::path& file, const Overrides& overrides = {});

}  // namespace spindrift::app
