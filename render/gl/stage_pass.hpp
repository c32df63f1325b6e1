// The stage: backdrop, floor, edges of the domain box.
#pragma once

#include <optional>

#include "render/gl/canvas.hpp"
#include "render/gl/frame.hpp"

namespace spindrift::gl {

/// Backdrop and floor: what fills the picture where nothing stands in front of it.
class Surroundings {
 public:
  explicit Surroundings(bool floor);
  /// Fills what is being drawn on; to be drawn first. `shadow` is the light on the floor; null: all
  /// of it arrives.
  void draw(const Texture* shadow) const;
  /// Fills the picture with the same bytes. As long as the view is still, only the part that
  /// `area` covers on the floor is drawn anew, the rest is kept.
  void draw_on(const Picture& picture, const FrameUniforms& frame, const Texture* shadow,
               const ShadowArea& area);

 private:
  Program program_;
  VertexArray no_attributes_;
  Texture no_shadow_;
  std::optional<FrameUniforms> last_;  ///< of the picture drawn last
  std::optional<Texture> kept_;        ///< how `last_` looks without a shadow
};

class Edges {
 public:
  Edges();
  /// Draws them on a finished picture; `depth` is that of all that stands on the stage.
  void draw(const MultisampleTexture& depth) const;

 private:
  Program program_;
  VertexArray no_attributes_;
};

}  // namespace spindrift::gl
