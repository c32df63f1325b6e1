// An OpenGL 4.5 core context on EGL, with no display, no window and no surface.
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
  /// @param cuda_device CUDA's number of the GPU that it computes on, if it does
  /// @throws std::runtime_error saying what is at fault: a limit of the system, a variable of the
  /// environment, or a library, with the Debian package that supplies it.
  explicit EglContext(std::optional<int> cuda_device);
  ~EglContext();
  EglContext(const EglContext&) = delete;
  EglContext& operator=(const EglContext&) = delete;

  /// The context is current on this thread for as long as the object lives.
  class Current {
   public:
    explicit Current(const EglContext& context);
    ~Current();
    Current(const Current&) = delete;
    Current& operator=(const Current&) = delete;

   private:
    EGLDisplay display_;
  };

  std::string vendor() const;
  /// Which device was taken, in words.
  const std::string& device() const { return device_; }

 private:
  /// Why this display cannot be used; empty when a context was made on it.
  std::string try_display(EGLDisplay display);

  EGLDisplay display_ = EGL_NO_DISPLAY;
  EGLContext context_ = EGL_NO_CONTEXT;
  std::string device_;
};

}  // namespace spindrift::gl
