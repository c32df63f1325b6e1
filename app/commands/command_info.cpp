#include <fmt/core.h>
#include <omp.h>

#include <exception>
#include <string>
#include <utility>

#include "app/commands/commands.hpp"
#include "app/errors/errors.hpp"
#include "app/run/report.hpp"
#include "render/gl/renderer.hpp"
#include "render/output/output.hpp"
#include "sim/run/backend_choice.hpp"

namespace spindrift::app {
namespace {

/// Whether pictures can be drawn, and the renderer that draws them or the reason why none can.
std::pair<bool, std::string> renderer() {
  try {
    const gl::Renderer probe(16, 16, {}, {}, {});
    const auto& info = probe.info();
    return {true,
            fmt::format("{}, OpenGL {} ({}, EGL by {}; {})", info.renderer, info.version,
                        info.software ? "software" : "hardware", info.egl_vendor, info.egl_device)};
  } catch (const std::exception& error) {
    return {false, error.what()};
  }
}

std::string encoder() {
  try {
    return output::encoder_info();
  } catch (const std::exception& error) {
    return error.what();
  }
}

}  // namespace

int run_info(bool json) {
  const auto [can_draw, drawn_by] = renderer();
  const nlohmann::ordered_json info{
      {"version", SPINDRIFT_VERSION},  {"compiler", SPINDRIFT_COMPILER},
      {"processor", processor_name()}, {"threads", omp_get_max_threads()},
      {"cuda", sim::cuda_device()},    {"can_draw", can_draw},
      {"renderer", drawn_by},          {"encoder", encoder()}};
  if (json) {
    fmt::print("{}\n", info.dump(2));
    return done;
  }
  fmt::print("spindrift   {}, {}\n", SPINDRIFT_VERSION, SPINDRIFT_COMPILER);
  fmt::print("processor   {}, {} threads\n", processor_name(), omp_get_max_threads());
  fmt::print("cuda        {}\n", sim::cuda_device());
  fmt::print("renderer    {}{}\n", can_draw ? "" : "none: ", drawn_by);
  fmt::print("encoder     {}\n", info["encoder"].get<std::string>());
  return done;
}

}  // namespace spindrift::app
