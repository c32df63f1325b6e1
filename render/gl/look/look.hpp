// What a picture shows and how: camera, light, colours, stage and particles, as plain data.
#pragma once

#include <glm/glm.hpp>
#include <span>

namespace spindrift::gl {

/// A pinhole camera, in a right-handed world with y pointing up.
struct View {
  glm::vec3 position{0.f, 1.f, 4.f};  ///< of the eye, m
  glm::vec3 target{0.f};              ///< point in the picture's middle, m
  glm::vec3 up{0.f, 1.f, 0.f};        ///< direction that points up in the picture
  float vertical_fov = 35.f;          ///< vertical field of view, degrees, 5 ... 120
};

/// A directional light with a soft sky fill; it casts the shadow on the floor.
struct LightSettings {
  glm::vec3 direction{-0.5f, -1.f, 0.3f};  ///< the way the light travels; normalised on use
  glm::vec3 color{1.f};                    ///< linear RGB
  float intensity = 0.8f;                  ///< factor of `color`, without unit
  float ambient = 0.5f;                    ///< sky fill, relative to the light
  bool shadows = true;                     ///< whether a shadow falls on the floor
};

/// How the liquid is drawn: as the mesh of its surface, or as its particles.
enum class Style { mesh, particles };
/// The attribute of particles that gives them their colours.
enum class ColorBy { speed, density, pressure };

/// The look of everything in the picture. Colours are sRGB in [0, 1]; they are linearised before
/// shading.
struct LookSettings {
  Style style = Style::mesh;
  glm::vec3 liquid_color{0.16f, 0.47f, 0.72f};
  float shininess = 90.f;  ///< Phong exponent
  float specular = 0.5f;   ///< strength of the highlight, [0, 1]
  /// Colours of the backdrop at the picture's top and bottom edges.
  glm::vec3 background_top{0.93f, 0.95f, 0.97f};
  glm::vec3 background_bottom{0.80f, 0.84f, 0.88f};
  glm::vec3 floor_color{0.86f, 0.87f, 0.88f};
  bool floor = true;  ///< whether the floor of the domain box is drawn
  bool walls = true;  ///< whether the edges of the domain box are drawn
  glm::vec3 obstacle_color{0.78f, 0.72f, 0.64f};
  ColorBy color_by = ColorBy::speed;  ///< for particles
  float color_min = 0.f;              ///< attribute value at the low end of the colour map
  /// Attribute value at the high end; if it equals color_min, both are taken from the data.
  float color_max = 0.f;
  float particle_radius = 0.5f;  ///< radius of particles as drawn, in particle spacings
};

/// The domain box whose edges and floor are drawn, m.
struct Stage {
  glm::vec3 min{-1.f, 0.f, -1.f};
  glm::vec3 max{1.f, 2.f, 1.f};
};

/// Particles as lit spheres, coloured by one attribute per particle.
struct ParticleCloud {
  std::span<const glm::vec3> positions;  ///< m
  std::span<const float> attribute;      ///< value to colour by, one per position
  float radius = 0.f;                    ///< of the spheres, m
};

}  // namespace spindrift::gl
