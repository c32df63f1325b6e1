#include "render/gl/egl/egl_context.hpp"

#include <EGL/eglext.h>
#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <iterator>
#include <stdexcept>
#include <string_view>
#include <vector>

#include "render/gl/egl/egl_devices.hpp"
#include "render/gl/egl/egl_failure.hpp"
#include "render/shortage.hpp"

namespace spindrift::gl {

namespace {

/// Returns whether `name` is one of the words of an extension string, which may be null.
bool has_extension(const char* extensions, std::string_view name) {
  std::string_view rest = extensions ? extensions : "";
  while (!rest.empty()) {
    const auto end = std::min(rest.find(' '), rest.size());
    if (rest.substr(0, end) == name)
      return true;
    rest.remove_prefix(std::min(end + 1, rest.size()));
  }
  return false;
}

template <typename Function>
Function egl_function(const char* name) {
  return reinterpret_cast<Function>(eglGetProcAddress(name));
}

/// Address space without which Mesa is not started, bytes; it crashed with 310 MiB.
constexpr std::size_t mesa_address_space = std::size_t{512} << 20;

/// An EGL display, and the words in which reports name it.
struct Display {
  EGLDisplay display;
  std::string name;
};

/// Returns all EGL devices of this machine.
std::vector<EGLDeviceEXT> devices() {
  const char* client = eglQueryString(EGL_NO_DISPLAY, EGL_EXTENSIONS);
  const bool enumerable = has_extension(client, "EGL_EXT_device_enumeration") ||
                          has_extension(client, "EGL_EXT_device_base");
  if (!enumerable || !has_extension(client, "EGL_EXT_platform_device"))
    return {};
  const auto query_devices = egl_function<PFNEGLQUERYDEVICESEXTPROC>("eglQueryDevicesEXT");
  EGLint count = 0;
  if (!query_devices || !query_devices(0, nullptr, &count) || count <= 0)
    return {};
  std::vector<EGLDeviceEXT> found(static_cast<std::size_t>(count));
  query_devices(count, found.data(), &count);
  found.resize(static_cast<std::size_t>(count));
  return found;
}

EglDevice described(EGLDeviceEXT device) {
  const auto query_string = egl_function<PFNEGLQUERYDEVICESTRINGEXTPROC>("eglQueryDeviceStringEXT");
  const auto query_number = egl_function<PFNEGLQUERYDEVICEATTRIBEXTPROC>("eglQueryDeviceAttribEXT");
  const char* extensions = query_string ? query_string(device, EGL_EXTENSIONS) : nullptr;
  EglDevice result{.software = has_extension(extensions, "EGL_MESA_device_software")};
  EGLAttrib number = 0;
  if (has_extension(extensions, "EGL_NV_device_cuda") && query_number &&
      query_number(device, EGL_CUDA_DEVICE_NV, &number))
    result.cuda_device = static_cast<int>(number);
  return result;
}

/// Returns the displays to try, best first.
std::vector<Display> displays(std::optional<int> cuda_device) {
  const auto get_display =
      egl_function<PFNEGLGETPLATFORMDISPLAYEXTPROC>("eglGetPlatformDisplayEXT");
  if (!get_display)
    return {};
  const std::vector<EGLDeviceEXT> all = devices();
  std::vector<EglDevice> descriptions;
  std::transform(all.begin(), all.end(), std::back_inserter(descriptions), described);
  std::vector<Display> found;
  for (const std::size_t k : order_to_try(descriptions, cuda_device)) {
    found.push_back({get_display(EGL_PLATFORM_DEVICE_EXT, all[k], nullptr),
                     name_of(descriptions, k, cuda_device)});
  }
  if (has_extension(eglQueryString(EGL_NO_DISPLAY, EGL_EXTENSIONS),
                    "EGL_MESA_platform_surfaceless")) {
    found.push_back({get_display(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr),
                     "Mesa's surfaceless platform"});
  }
  std::erase_if(found, [](const Display& d) { return d.display == EGL_NO_DISPLAY; });
  return found;
}

}  // namespace

EglContext::EglContext(std::optional<int> cuda_device) {
  // Mesa warns on stderr about devices it cannot open, although the next one then works. Whoever
  // wants to see that sets the variable.
  setenv("EGL_LOG_LEVEL", "fatal", 0);

  // Mesa does not survive its start without memory for the code that it makes and for its threads'
  // stacks.
  if (const auto short_of = shortage(mesa_address_space))
    throw std::runtime_error(fmt::format("there is nothing to draw with: {}", *short_of));
  std::string reason;
  for (const Display& candidate : displays(cuda_device)) {
    reason = try_display(candidate.display);
    if (reason.empty()) {
      device_ = candidate.name;
      return;
    }
  }
  throw std::runtime_error(egl_failure(reason));
}

std::string EglContext::try_display(EGLDisplay display) {
  if (!eglInitialize(display, nullptr, nullptr))
    return "eglInitialize failed";
  const char* extensions = eglQueryString(display, EGL_EXTENSIONS);
  if (!has_extension(extensions, "EGL_KHR_surfaceless_context"))
    return "EGL_KHR_surfaceless_context is missing";
  if (!eglBindAPI(EGL_OPENGL_API))
    return "desktop OpenGL is missing";
  const EGLint config_attributes[] = {EGL_SURFACE_TYPE, 0, EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT,
                                      EGL_NONE};
  EGLConfig config = nullptr;
  EGLint count = 0;
  if (!eglChooseConfig(display, config_attributes, &config, 1, &count) || count == 0)
    config = nullptr;  // this is EGL_NO_CONFIG_KHR, allowed where contexts need no config
  const EGLint context_attributes[] = {EGL_CONTEXT_MAJOR_VERSION,
                                       4,
                                       EGL_CONTEXT_MINOR_VERSION,
                                       5,
                                       EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                       EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                                       EGL_NONE};
  const EGLContext context = eglCreateContext(display, config, EGL_NO_CONTEXT, context_attributes);
  if (context == EGL_NO_CONTEXT)
    return "its driver has no OpenGL 4.5 core profile";
  if (!eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context)) {
    eglDestroyContext(display, context);
    return "its context cannot be made current";
  }
  eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
  display_ = display;
  context_ = context;
  return {};
}

EglContext::~EglContext() {
  eglDestroyContext(display_, context_);
}

std::string EglContext::vendor() const {
  const char* vendor = eglQueryString(display_, EGL_VENDOR);
  return vendor ? vendor : "";
}

EglContext::Current::Current(const EglContext& context) : display_(context.display_) {
  if (!eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context.context_))
    throw std::runtime_error("the OpenGL context cannot be made current on this thread");
}

EglContext::Current::~Current() {
  eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
}

}  // namespace spindrift::gl
