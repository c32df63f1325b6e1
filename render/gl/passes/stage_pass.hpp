// Draws the stage: the backdrop, the floor, and the edges of the domain box.
#pragma once

#include <optional>

#include "render/gl/look/frame.hpp"
#include "render/gl/objects/canvas.hpp"

namespace spindrift::gl {

/// The backdrop and the floor, which fill the picture where nothing stands in front of them.
class Surroundings {
 public:
  /// @param floor whether there is a floor
  explicit Surroundings(bool floor);
  /// Fills the bound target, before anything else is drawn on it. `shadow` is the map of the light
  /// on the floor; where it is null, all of the light arrives.
  void draw(const Texture* shadow) const;
  /// Fills the picture with the same bytes as draw() would. As long as the view is still, only the
  /// part that `area` covers on the floor is drawn anew; the rest is kept.
  void draw_on(const Picture& picture, const FrameUniforms& frame, const Texture* shadow,
               const ShadowArea& area);

 private:
  Program program_;
  VertexArray no_attributes_;
  Texture no_shadow_;
  std::optional<FrameUniforms> last_;  ///< uniforms of the picture that was drawn last
  std::optional<Texture> kept_;        ///< that picture without a shadow
};

/// The edges of the domain box.
class Edges {
 public:
  Edges();
  /// Draws the edges on a finished picture, the bound target; `depth` is the depth of all that
  /// stands on the stage and may hide them.
  void draw(const MultisampleTexture& depth) const;

 private:
  Program program_;
  VertexArray no_attributes_;
};

}  // namespace spindrift::gl
