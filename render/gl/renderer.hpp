// Headless renderer: draws a liquid (mesh or particles), obstacles and the stage with OpenGL on
// EGL.
#pragma once

#include <glm/glm.hpp>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "render/image.hpp"
#include "render/mesh.hpp"

namespace spindrift::gl {

/// Where the eye is. A pinhole camera, right-handed world, y up.
struct View {
  glm::vec3 position{0.f, 1.f, 4.f};  ///< m
  glm::vec3 target{0.f};              ///< m
  glm::vec3 up{0.f, 1.f, 0.f};
  float vertical_fov = 35.f;  ///< degrees, (5 ... 120)
};

/// A directional light with a soft sky fill; it casts the shadow on the floor.
struct LightSettings {
  glm::vec3 direction{-0.5f, -1.f, 0.3f};  ///< the way the light travels; normalised on use
  glm::vec3 color{1.f};                    ///< linear RGB
  float intensity = 0.8f;                  ///< relative
  float ambient = 0.5f;                    ///< sky fill, relative to the light
  bool shadows = true;
};

enum class Style { mesh, particles };
enum class ColorBy { speed, density, pressure };

/// How things look. Colours are sRGB in [0, 1]; they are linearised before shading.
struct LookSettings {
  Style style = Style::mesh;
  glm::vec3 liquid_color{0.16f, 0.47f, 0.72f};
  float shininess = 90.f;  ///< Phong exponent
  float specular = 0.5f;   ///< strength of the highlight, [0, 1]
  glm::vec3 background_top{0.93f, 0.95f, 0.97f};
  glm::vec3 background_bottom{0.80f, 0.84f, 0.88f};
  glm::vec3 floor_color{0.86f, 0.87f, 0.88f};
  bool floor = true;
  bool walls = true;  ///< edges of the domain box
  glm::vec3 obstacle_color{0.78f, 0.72f, 0.64f};
  ColorBy color_by = ColorBy::speed;  ///< for particles
  float color_min = 0.f;              ///< attribute value at the low end of the colour map
  float color_max = 0.f;         ///< value at the high end; equal to color_min: taken from the data
  float particle_radius = 0.5f;  ///< in particle spacings
};

/// The domain box whose edges and floor are drawn, m.
struct Stage {
  glm::vec3 min{-1.f, 0.f, -1.f};
  glm::vec3 max{1.f, 2.f, 1.f};
};

/// Particles as lit spheres, coloured by one attribute per particle.
struct ParticleCloud {
  std::span<const glm::vec3> positions;  ///< m
  std::span<const float> attribute;      ///< as many as positions
  float radius = 0.f;                    ///< m
};

/// Owns the EGL display, the context and everything drawn with. Use it from one thread at a time.
class Renderer {
 public:
  /// @param cuda_device CUDA's number of the GPU that it computes on: the one to draw with, if it
  /// can. None: the first that can
  /// @throws std::runtime_error with a sentence for people when no EGL device or no OpenGL 4.5 is
  /// there.
  Renderer(int width, int height, const LookSettings& look, const LightSettings& light,
           const Stage& stage, std::optional<int> cuda_device = {});
  ~Renderer();
  Renderer(const Renderer&) = delete;
  Renderer& operator=(const Renderer&) = delete;

  /// Solid obstacles, drawn in every picture until set again.
  /// @param reach points that they may come to when they are set again: the shadow's map covers
  /// those as well, so that it stays the same while obstacles move
  void set_obstacles(const Mesh& mesh, std::span<const glm::vec3> reach = {});

  /// One picture: the stage, the obstacles and the liquid.
  Image draw(const Mesh& liquid, const View& view);
  Image draw(const ParticleCloud& liquid, const View& view);

  /// What draws: GL renderer, version and EGL vendor, as strings of the driver, and which of the
  /// machine's EGL devices it is.
  struct Info {
    std::string renderer, version, egl_vendor, egl_device;
    bool software = false;  ///< Mesa's llvmpipe or softpipe
  };
  const Info& info() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace spindrift::gl
