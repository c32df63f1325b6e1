// An OpenGL 4.5 core context on EGL, with no display, no window and no surface.
#pragma once

#include <EGL/egl.h>

#include <string>

namespace spindrift::gl {

/// Owns one context. A GPU's EGL device is taken if one works, else Mesa's software device, else
/// Mesa's surfaceless platform. The EGL display itself belongs to the process: EGL hands the same
/// one to whoever asks for the same device, so that it is never terminated here.
class EglContext {
 public:
  /// @throws std::runtime_error saying what is missing and which Debian package supplies it.
  EglContext();
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

 private:
  /// Why this display cannot be used; empty when a context was made on it.
  std::string try_display(EGLDisplay display);

  EGLDisplay display_ = EGL_NO_DISPLAY;
  EGLContext context_ = EGL_NO_CONTEXT;
};

}  // namespace spindrift::gl
