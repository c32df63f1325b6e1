// Owns an OpenGL 4.5 core context on EGL that needs no display server, no window and no surface.
#pragma once

#include <EGL/egl.h>

#include <optional>
#include <string>

namespace spindrift::gl {

/// Owns one context. The EGL device of the GPU that CUDA computes on is taken if it works, else
/// another GPU's, else Mesa's software device, else Mesa's surfaceless platform. The EGL display
/// itself belongs to the process: EGL hands the same one to whoever asks for the same device, so
/// that it is never terminated here.
class EglContext {
 public:
  /// Makes a context without making it current.
  /// @param cuda_device CUDA's number of the GPU that it computes on; none where it does not
  /// @throws std::runtime_error saying what is at fault: a limit of the system, a variable of the
  /// environment, or a library, with the Debian package that supplies it
  explicit EglContext(std::optional<int> cuda_device);
  ~EglContext();
  EglContext(const EglContext&) = delete;
  EglContext& operator=(const EglContext&) = delete;

  /// Makes a context current on this thread for as long as the object lives.
  class Current {
   public:
    /// @throws std::runtime_error where the context cannot be made current
    explicit Current(const EglContext& context);
    ~Current();
    Current(const Current&) = delete;
    Current& operator=(const Current&) = delete;

   private:
    EGLDisplay display_;
  };

  /// EGL's vendor as the driver names it.
  std::string vendor() const;
  /// Says in words which device was taken.
  const std::string& device() const { return device_; }

 private:
  /// Tries to make the context on a display. Returns why the display cannot be used, or an empty
  /// text when the context was made.
  std::string try_display(EGLDisplay display);

  EGLDisplay display_ = EGL_NO_DISPLAY;
  EGLContext context_ = EGL_NO_CONTEXT;
  std::string device_;
};

}  // namespace spindrift::gl
