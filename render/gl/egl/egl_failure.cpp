#include "render/gl/egl/egl_failure.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <string_view>
#include <system_error>

#include "render/shortage.hpp"

namespace spindrift::gl {
namespace {

namespace fs = std::filesystem;

/// Returns whether a file in this folder names a driver's EGL library to libglvnd (the dispatcher
/// behind libEGL.so.1).
bool names_a_vendor(const char* folder) {
  std::error_code none;
  return std::any_of(fs::directory_iterator(folder, none), fs::directory_iterator(),
                     [](const auto& entry) { return entry.path().extension() == ".json"; });
}

}  // namespace

std::vector<std::string> steering_variables(const char* const* environment) {
  static constexpr std::array<std::string_view, 5> prefixes{"__EGL_", "EGL_", "GALLIUM_", "LIBGL_",
                                                            "MESA_"};
  std::vector<std::string> found;
  for (; *environment != nullptr; ++environment) {
    const std::string_view variable = *environment;
    const bool steers = std::any_of(prefixes.begin(), prefixes.end(),
                                    [&](auto prefix) { return variable.starts_with(prefix); });
    if (steers && !variable.starts_with("EGL_LOG_LEVEL="))
      found.emplace_back(variable);
  }
  std::sort(found.begin(), found.end());
  return found;
}

std::string egl_failure(const std::string& reason) {
  if (const auto short_of = shortage())
    return fmt::format("there is nothing to draw with: {}", *short_of);
  std::string text =
      reason.empty() ? "there is no EGL device to draw with"
                     : fmt::format("no EGL device gives OpenGL 4.5 without a display ({})", reason);
  const std::vector<std::string> variables = steering_variables(environ);
  if (!variables.empty())
    return fmt::format("{}; the environment decides what EGL and Mesa use: unset {}", text,
                       fmt::join(variables, ", "));
  if (!names_a_vendor("/usr/share/glvnd/egl_vendor.d") &&
      !names_a_vendor("/etc/glvnd/egl_vendor.d"))
    return text +
           "; libEGL.so.1 finds no driver's library: install the Debian package libegl-mesa0";
  return text + "; install the Debian package libgl1-mesa-dri, Mesa's drivers";
}

}  // namespace spindrift::gl
