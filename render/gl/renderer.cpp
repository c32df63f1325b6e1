#include "render/gl/renderer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <stdexcept>

#include "render/gl/egl/egl_context.hpp"
#include "render/gl/look/frame.hpp"
#include "render/gl/objects/canvas.hpp"
#include "render/gl/objects/mesh_buffers.hpp"
#include "render/gl/passes/liquid_pass.hpp"
#include "render/gl/passes/particle_pass.hpp"
#include "render/gl/passes/shadow_pass.hpp"
#include "render/gl/passes/stage_pass.hpp"
#include "shaders.hpp"

namespace spindrift::gl {

namespace {

std::string driver_string(GLenum name) {
  const GLubyte* text = glGetString(name);
  return text ? reinterpret_cast<const char*>(text) : "";
}

struct Obstacles {
  Program program = make_program(shaders::obstacle_vert, shaders::obstacle_frag);
  MeshBuffers mesh;
  Mesh shape;
};

struct Liquid {
  Liquid(int width, int height)
      : behind(width, height), pass(width, height), tiles(width, height) {}
  MeshBuffers mesh;
  Behind behind;
  LiquidPass pass;
  Tiles tiles;
};

struct Particles {
  Particles(int width, int height) : samples(GL_SRGB8_ALPHA8, width, height) {}
  Samples samples;
  ParticleBuffers buffers;
  ParticlePass pass;
};

/// Draws pictures with all that lives in the OpenGL context. What a scene does not use is never
/// made.
class Drawing {
 public:
  Drawing(int width, int height, const LookSettings& look, const LightSettings& light,
          const Stage& stage)
      : look_(look),
        light_(light),
        stage_(stage),
        casters_{stage.min, stage.max},
        picture_(width, height) {
    if (look.walls)
      edges_.emplace();
  }

  void set_obstacles(const Mesh& mesh, std::span<const glm::vec3> reach) {
    const Bounds before = casters_;
    casters_ = {stage_.min, stage_.max};
    for (const std::span<const glm::vec3> points :
         {std::span<const glm::vec3>(mesh.vertices), reach}) {
      for (const glm::vec3& point : points) {
        casters_.min = glm::min(casters_.min, point);
        casters_.max = glm::max(casters_.max, point);
      }
    }
    if (casters_.min != before.min || casters_.max != before.max)
      shadow_.reset();  // the area that its map covers changes
    if (mesh.triangles.empty()) {
      obstacles_.reset();
      return;
    }
    if (!obstacles_)
      obstacles_.emplace();
    obstacles_->mesh.set(mesh);
    obstacles_->shape = mesh;
  }

  Image draw(const Mesh& mesh, const View& view) {
    begin(view);
    if (!liquid_)
      liquid_.emplace(picture_.width(), picture_.height());
    const MeshBuffers* obstacles = obstacles_ ? &obstacles_->mesh : nullptr;
    liquid_->mesh.set(mesh);
    const Texture* shadow = draw_shadow(mesh.triangles.empty() ? nullptr : &mesh, nullptr);
    liquid_->pass.measure(liquid_->mesh, obstacles);
    liquid_->pass.outline(liquid_->mesh, obstacles, floor_is_seen(view));

    surroundings(view).draw_on(picture_, uniforms_, shadow, shadow_area(light_, stage_, casters_));
    liquid_->behind.begin(picture_);
    draw_obstacles(view);
    liquid_->tiles.clear();
    liquid_->tiles.add(mesh, uniforms_.world_to_clip);
    if (obstacles_)
      liquid_->tiles.add(obstacles_->shape, uniforms_.world_to_clip);
    liquid_->pass.shade(picture_, liquid_->behind.encoded(), obstacles_.has_value(),
                        liquid_->tiles);
    return finish(liquid_->pass.depth());
  }

  Image draw(const ParticleCloud& cloud, const View& view) {
    if (cloud.positions.empty())
      return draw(Mesh{}, view);
    begin(view);
    if (!particles_)
      particles_.emplace(picture_.width(), picture_.height());
    particles_->buffers.set(cloud);
    const Texture* shadow = draw_shadow(nullptr, &particles_->buffers);
    particles_->samples.begin();
    surroundings(view).draw(shadow);
    draw_obstacles(view);
    float low = look_.color_min, high = look_.color_max;
    if (low == high) {
      const auto [least, most] = std::ranges::minmax(cloud.attribute);
      low = least;
      high = most;
    }
    particles_->pass.draw(particles_->buffers, low, high);
    particles_->samples.resolve(picture_);
    return finish(particles_->samples.depth());
  }

 private:
  void begin(const View& view) {
    uniforms_ =
        frame_uniforms(view, look_, light_, stage_, casters_, picture_.width(), picture_.height());
    upload(frame_, std::span<const FrameUniforms>(&uniforms_, 1));
    glBindBufferBase(GL_UNIFORM_BUFFER, 0, frame_);
    glEnable(GL_FRAMEBUFFER_SRGB);
    glEnable(GL_DEPTH_TEST);
  }

  /// Draws the map of the light on the floor and returns it, or null when nothing shades the floor.
  const Texture* draw_shadow(const Mesh* liquid, const ParticleBuffers* particles) {
    const ShadowArea area = shadow_area(light_, stage_, casters_);
    const bool casts = liquid || particles || obstacles_;
    if (!light_.shadows || !look_.floor || !casts || area.empty())
      return nullptr;
    if (!shadow_)
      shadow_.emplace(area, glm::normalize(light_.direction), stage_.min.y);
    shadow_->begin(liquid);
    if (particles)
      shadow_->add_particles(*particles);
    if (obstacles_)
      shadow_->add_obstacles(obstacles_->mesh);
    return &shadow_->finish();
  }

  bool floor_is_seen(const View& view) const {
    return look_.floor && view.position.y > stage_.min.y;
  }

  Surroundings& surroundings(const View& view) {
    std::optional<Surroundings>& wanted = floor_is_seen(view) ? floor_ : backdrop_;
    if (!wanted)
      wanted.emplace(floor_is_seen(view));
    return *wanted;
  }

  /// Draws the obstacles, without what is under a floor that can be seen.
  void draw_obstacles(const View& view) const {
    if (obstacles_) {
      if (floor_is_seen(view))
        glEnable(GL_CLIP_DISTANCE0);
      glUseProgram(obstacles_->program);
      obstacles_->mesh.draw();
      glDisable(GL_CLIP_DISTANCE0);
    }
  }

  /// Draws the edges of the domain box over all else, where nothing of a smaller `depth` hides
  /// them, and reads the picture.
  Image finish(const MultisampleTexture& depth) {
    if (edges_) {
      picture_.bind();
      edges_->draw(depth);
    }
    return picture_.read();
  }

  LookSettings look_;
  LightSettings light_;
  Stage stage_;
  Bounds casters_;
  Picture picture_;
  Buffer frame_;
  FrameUniforms uniforms_{};
  std::optional<Surroundings> backdrop_, floor_;
  std::optional<Edges> edges_;
  std::optional<Obstacles> obstacles_;
  std::optional<ShadowPass> shadow_;
  std::optional<Liquid> liquid_;
  std::optional<Particles> particles_;
};

}  // namespace

struct Renderer::Impl {
  explicit Impl(std::optional<int> cuda_device) : context(cuda_device) {}

  EglContext context;
  Info info;
  std::optional<Drawing> drawing;

  ~Impl() {
    const EglContext::Current current(context);
    drawing.reset();
  }
};

Renderer::Renderer(int width, int height, const LookSettings& look, const LightSettings& light,
                   const Stage& stage, std::optional<int> cuda_device) {
  if (width <= 0 || height <= 0)
    throw std::invalid_argument(fmt::format("a picture cannot have {} x {} pixels", width, height));
  impl_ = std::make_unique<Impl>(cuda_device);
  const EglContext::Current current(impl_->context);
  impl_->info = {driver_string(GL_RENDERER), driver_string(GL_VERSION), impl_->context.vendor(),
                 impl_->context.device(), false};
  impl_->info.software = impl_->info.renderer.find("llvmpipe") != std::string::npos ||
                         impl_->info.renderer.find("softpipe") != std::string::npos;
  GLint largest = 0;
  glGetIntegerv(GL_MAX_RENDERBUFFER_SIZE, &largest);
  if (std::max(width, height) > largest) {
    throw std::invalid_argument(
        fmt::format("a picture of {} x {} pixels is too large: {} draws at most {} x {}", width,
                    height, impl_->info.renderer, largest, largest));
  }
  impl_->drawing.emplace(width, height, look, light, stage);
}

Renderer::~Renderer() = default;

void Renderer::set_obstacles(const Mesh& mesh, std::span<const glm::vec3> reach) {
  const EglContext::Current current(impl_->context);
  impl_->drawing->set_obstacles(mesh, reach);
}

Image Renderer::draw(const Mesh& liquid, const View& view) {
  const EglContext::Current current(impl_->context);
  return impl_->drawing->draw(liquid, view);
}

Image Renderer::draw(const ParticleCloud& liquid, const View& view) {
  const EglContext::Current current(impl_->context);
  return impl_->drawing->draw(liquid, view);
}

const Renderer::Info& Renderer::info() const {
  return impl_->info;
}

}  // namespace spindrift::gl
