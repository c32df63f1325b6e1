// The headless renderer, judged by its pixels.
#include <catch2/catch.hpp>
#include <stdexcept>

#include "gl_support.hpp"
#include "render/gl/egl/egl_devices.hpp"
#include "render/gl/egl/egl_failure.hpp"

namespace gl_tests {

using namespace spindrift;
using namespace spindrift::gl;
using namespace spindrift::gl::test;

namespace {

constexpr int width = 160, height = 120;
const glm::vec2 size(width, height);

View front_view() {
  View view;
  view.position = {0.f, 1.f, 4.f};
  view.target = {0.f, 1.f, 0.f};
  return view;
}

View view_from_above() {
  View view;
  view.position = {0.f, 5.f, 0.01f};
  view.target = {0.f, 0.f, 0.f};
  return view;
}

LookSettings plain_look() {
  LookSettings look;
  look.floor = look.walls = false;
  return look;
}

int encode(float linear) {
  const float c =
      linear <= 0.0031308f ? 12.92f * linear : 1.055f * std::pow(linear, 1.f / 2.4f) - 0.055f;
  return static_cast<int>(std::lround(255.f * std::min(c, 1.f)));
}

float decode(float srgb) {
  return srgb <= 0.04045f ? srgb / 12.92f : std::pow((srgb + 0.055f) / 1.055f, 2.4f);
}

}  // namespace

TEST_CASE("variables that steer EGL and Mesa are found, those that only tell more are not") {
  const char* const environment[] = {"HOME=/",
                                     "MESA_GL_VERSION_OVERRIDE=3.3",
                                     "EGL_LOG_LEVEL=fatal",
                                     "GALLIUM_DRIVER=none",
                                     "MY_EGL_X=1",
                                     nullptr};
  CHECK(gl::steering_variables(environment) ==
        std::vector<std::string>{"GALLIUM_DRIVER=none", "MESA_GL_VERSION_OVERRIDE=3.3"});
}

TEST_CASE("the driver says what it is") {
  const Renderer renderer(8, 8, {}, {}, {});
  CHECK_FALSE(renderer.info().renderer.empty());
  CHECK_FALSE(renderer.info().egl_vendor.empty());
  CHECK_FALSE(renderer.info().egl_device.empty());
  CHECK(renderer.info().version >= "4.5");
}

TEST_CASE("the GPU that CUDA computes on draws, then another, then the processor") {
  using Order = std::vector<std::size_t>;
  // As a machine with Mesa's software, Mesa's driver of a GPU and two GPUs of NVIDIA's lists them.
  const std::vector<EglDevice> machine{
      {.software = true}, {}, {.cuda_device = 1}, {.cuda_device = 0}};
  CHECK(order_to_try(machine, std::nullopt) == Order{1, 2, 3, 0});
  CHECK(order_to_try(machine, 0) == Order{3, 1, 2, 0});
  CHECK(order_to_try(machine, 1) == Order{2, 1, 3, 0});
  CHECK(order_to_try(machine, 2) == Order{1, 2, 3, 0});
  CHECK(order_to_try({}, 0).empty());
  CHECK(name_of(machine, 3, 0) == "EGL device 4 of 4, CUDA device 0");
  CHECK(name_of(machine, 1, 0) == "EGL device 2 of 4; CUDA computes on its device 0");
  CHECK(name_of(machine, 0, std::nullopt) == "EGL device 1 of 4, software");
}

TEST_CASE("a GPU that is not there is no reason not to draw") {
  const Renderer renderer(8, 8, {}, {}, {}, 63);
  CHECK_FALSE(renderer.info().renderer.empty());
  CHECK_FALSE(renderer.info().egl_device.empty());
}

TEST_CASE("a picture without width or height is refused") {
  CHECK_THROWS_AS(Renderer(0, 10, {}, {}, {}), std::invalid_argument);
  CHECK_THROWS_AS(Renderer(10, 0, {}, {}, {}), std::invalid_argument);
  CHECK_THROWS_AS(Renderer(-1, 10, {}, {}, {}), std::invalid_argument);
  CHECK_THROWS_AS(Renderer(1 << 20, 10, {}, {}, {}), std::invalid_argument);
}

TEST_CASE("an incomplete mesh or cloud is refused, and the renderer goes on") {
  Renderer renderer(width, height, plain_look(), {}, {});
  Mesh mesh = box({-1.f, 0.f, -1.f}, {1.f, 1.f, 1.f});
  const Image good = renderer.draw(mesh, front_view());
  mesh.triangles.push_back({0, 1, 1000});
  CHECK_THROWS_AS(renderer.draw(mesh, front_view()), std::invalid_argument);
  mesh.triangles.pop_back();
  const auto normals = mesh.normals;
  mesh.normals.clear();
  CHECK_THROWS_AS(renderer.draw(mesh, front_view()), std::invalid_argument);
  const std::vector<glm::vec3> positions(3);
  CHECK_THROWS_AS(renderer.draw(ParticleCloud{positions, {}, 0.1f}, front_view()),
                  std::invalid_argument);
  mesh.normals = normals;
  CHECK(renderer.draw(mesh, front_view()).pixels == good.pixels);
}

TEST_CASE("an empty scene is the backdrop: its gradient ends in exactly the colours asked for") {
  LookSettings look = plain_look();
  look.background_top = glm::vec3(200.f, 100.f, 50.f) / 255.f;
  look.background_bottom = glm::vec3(10.f, 20.f, 240.f) / 255.f;
  Renderer renderer(width, height, look, {}, {});
  const Image image = renderer.draw(Mesh{}, front_view());
  REQUIRE(image.width == width);
  REQUIRE(image.height == height);
  for (int x = 0; x < width; ++x) {
    REQUIRE(pixel(image, x, 0) == Pixel(200, 100, 50));
    REQUIRE(pixel(image, x, height - 1) == Pixel(10, 20, 240));
  }
  for (int y = 1; y < height; ++y) {
    REQUIRE(pixel(image, 5, y).x <= pixel(image, 5, y - 1).x);
    REQUIRE(pixel(image, 5, y).z >= pixel(image, 5, y - 1).z);
  }
  CHECK(renderer.draw(ParticleCloud{}, front_view()).pixels == image.pixels);
}

TEST_CASE("a liquid box covers the pixels that projection predicts, and no others") {
  Renderer renderer(width, height, plain_look(), {}, {});
  const View view = front_view();
  const Image empty = renderer.draw(Mesh{}, view);
  const Image image = renderer.draw(box({-0.4f, 0.6f, -0.5f}, {0.5f, 1.2f, 0.5f}), view);
  // The near face at z = 0.5 hides all else of it.
  const glm::vec2 low = project({-0.4f, 1.2f, 0.5f}, view, size);
  const glm::vec2 high = project({0.5f, 0.6f, 0.5f}, view, size);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const glm::vec2 p(x, y);
      const bool inside =
          glm::all(glm::greaterThan(p, low)) && glm::all(glm::lessThan(p + 1.f, high));
      const bool outside =
          glm::any(glm::lessThan(p + 1.f, low)) || glm::any(glm::greaterThan(p, high));
      const bool drawn = pixel(image, x, y) != pixel(empty, x, y);
      CAPTURE(x, y);
      if (inside)
        REQUIRE(drawn);
      else if (outside)
        REQUIRE_FALSE(drawn);
    }
  }
}

TEST_CASE("thick liquid is darker than thin liquid") {
  Renderer renderer(width, height, plain_look(), {}, {});
  Mesh mesh = box({-0.8f, 0.6f, -0.1f}, {-0.2f, 1.4f, 0.f});
  append(mesh, box({0.2f, 0.6f, -1.f}, {0.8f, 1.4f, 0.f}));
  const Image image = renderer.draw(mesh, front_view());
  const Pixel thin = pixel(image, width / 2 - 18, height / 2);
  const Pixel thick = pixel(image, width / 2 + 18, height / 2);
  CHECK(sum(thin) > sum(thick) + 60);
  CHECK(thick.z > thick.x);  // and blue
}

TEST_CASE("the floor has exactly its colour times the light that falls on it") {
  LookSettings look;
  look.walls = false;
  look.floor_color = {0.8f, 0.5f, 0.3f};
  LightSettings light;
  light.direction = {0.f, -1.f, 1.f};
  light.color = {1.f, 0.9f, 0.8f};
  light.intensity = 0.7f;
  light.ambient = 0.25f;
  Renderer renderer(width, height, look, light, {});
  const Image image = renderer.draw(Mesh{}, view_from_above());
  const float share = light.intensity * (std::sqrt(0.5f) + light.ambient);
  const Pixel expected(encode(decode(0.8f) * 1.0f * share), encode(decode(0.5f) * 0.9f * share),
                       encode(decode(0.3f) * 0.8f * share));
  CHECK(difference(pixel(image, width / 2, height / 2), expected) <= 1);
}

TEST_CASE("an obstacle in the sky's light alone has exactly the colour of the hemisphere") {
  LightSettings light;
  light.intensity = 0.8f;
  light.direction = {0.f, 1.f, 0.f};  // from below: the top sees only the sky
  Renderer renderer(width, height, plain_look(), light, {});
  renderer.set_obstacles(box({-0.5f, 0.f, -0.5f}, {0.5f, 0.5f, 0.5f}));
  const Image image = renderer.draw(Mesh{}, view_from_above());
  const glm::vec3 color = LookSettings().obstacle_color;
  const float share = light.intensity * light.ambient;
  const Pixel expected(encode(decode(color.x) * share), encode(decode(color.y) * share),
                       encode(decode(color.z) * share));
  CHECK(difference(pixel(image, width / 2, height / 2), expected) <= 1);
}

TEST_CASE("what is near hides what is far") {
  Renderer renderer(width, height, plain_look(), {}, {});
  const Mesh liquid = box({-0.8f, 0.4f, -0.5f}, {0.8f, 1.6f, 0.f});
  const Image free = renderer.draw(liquid, front_view());
  renderer.set_obstacles(box({-0.3f, 0.8f, 0.5f}, {0.3f, 1.2f, 0.7f}));
  const Image alone = renderer.draw(Mesh{}, front_view());
  const Image hidden = renderer.draw(liquid, front_view());
  CHECK(pixel(hidden, width / 2, height / 2) == pixel(alone, width / 2, height / 2));
  CHECK(pixel(hidden, width / 2 - 25, height / 2) == pixel(free, width / 2 - 25, height / 2));

  renderer.set_obstacles(box({-0.3f, 0.8f, -1.5f}, {0.3f, 1.2f, -1.3f}));
  const Image behind = renderer.draw(liquid, front_view());
  const Image bare = renderer.draw(Mesh{}, front_view());
  CHECK(pixel(behind, width / 2, height / 2) != pixel(bare, width / 2, height / 2));

  renderer.set_obstacles(Mesh{});
  CHECK(renderer.draw(liquid, front_view()).pixels == free.pixels);
}

TEST_CASE("an obstacle within the liquid ends what counts as thick") {
  Renderer renderer(width, height, plain_look(), {}, {});
  const Mesh liquid = box({-1.f, 0.f, -3.f}, {1.f, 2.f, 0.f});
  renderer.set_obstacles(box({-0.4f, 0.6f, -1.f}, {0.4f, 1.4f, -0.05f}));
  const Image image = renderer.draw(liquid, front_view());
  const Pixel near = pixel(image, width / 2, height / 2);
  const Pixel deep = pixel(image, width / 2 - 30, height / 2);
  CHECK(near.x > deep.x + 30);  // the obstacle shines through 5 cm of liquid, 3 m swallow the red
}

TEST_CASE("a particle's silhouette is the sphere's") {
  Renderer renderer(width, height, plain_look(), {}, {});
  const View view = front_view();
  const std::vector<glm::vec3> centre{view.target};
  const std::vector<float> value{1.f};
  const float radius = 0.4f;
  const Image empty = renderer.draw(Mesh{}, view);
  const Image image = renderer.draw(ParticleCloud{centre, value, radius}, view);
  // The tangent cone of a sphere of radius r at distance d has the slope r / sqrt(d^2 - r^2).
  const float slope = radius / std::sqrt(16.f - radius * radius);
  const float expected = 0.5f * size.y * slope / std::tan(0.5f * glm::radians(view.vertical_fov));
  int covered = 0;
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const bool drawn = pixel(image, x, y) != pixel(empty, x, y);
      const float distance = glm::distance(glm::vec2(x, y) + 0.5f, 0.5f * size);
      covered += drawn;
      CAPTURE(x, y, distance, expected);
      if (distance < expected - 1.f)
        REQUIRE(drawn);
      else if (distance > expected + 1.f)
        REQUIRE_FALSE(drawn);
    }
  }
  CHECK(std::sqrt(static_cast<float>(covered) / 3.14159265f) == Approx(expected).margin(1.f));
}

TEST_CASE("particles follow the colour map: a higher value is lighter") {
  LookSettings look = plain_look();
  Renderer renderer(width, height, look, {}, {});
  std::vector<glm::vec3> positions;
  std::vector<float> values;
  for (int i = 0; i < 9; ++i) {
    positions.push_back({0.2f * static_cast<float>(i - 4), 1.f, 0.f});
    values.push_back(3.f + static_cast<float>(i));
  }
  View view = front_view();
  const ParticleCloud cloud{positions, values, 0.09f};
  const Image image = renderer.draw(cloud, view);
  int last = -1;
  for (const glm::vec3& position : positions) {
    const glm::vec2 place = project(position, view, size);
    const Pixel p = pixel(image, static_cast<int>(place.x), static_cast<int>(place.y));
    CHECK(2 * p.x + 7 * p.y + p.z > last);
    last = 2 * p.x + 7 * p.y + p.z;
  }

  look.color_min = 0.f;
  look.color_max = 3.f;  // all are at the high end or above
  Renderer fixed(width, height, look, {}, {});
  const Image same = fixed.draw(cloud, view);
  const glm::vec2 first = project(positions.front(), view, size);
  CHECK(sum(pixel(same, static_cast<int>(first.x), static_cast<int>(first.y))) >
        sum(pixel(image, static_cast<int>(first.x), static_cast<int>(first.y))) + 100);
}

TEST_CASE("spheres intersect by their true depth") {
  Renderer renderer(width, height, plain_look(), {}, {});
  // The second particle's centre is farther away, but its surface is nearer at its own middle.
  const std::vector<glm::vec3> positions{{0.f, 1.f, 0.f}, {0.35f, 1.f, -0.1f}};
  const std::vector<float> values{0.f, 1.f};
  const std::vector<glm::vec3> swapped_positions{positions[1], positions[0]};
  const std::vector<float> swapped_values{1.f, 0.f};
  const Image image = renderer.draw(ParticleCloud{positions, values, 0.4f}, front_view());
  const Image swapped =
      renderer.draw(ParticleCloud{swapped_positions, swapped_values, 0.4f}, front_view());
  const glm::vec2 place = project({0.4f, 1.f, 0.25f}, front_view(), size);
  const Pixel p = pixel(image, static_cast<int>(place.x), static_cast<int>(place.y));
  CHECK(p.x > p.z);  // the yellow one
  int different = 0;
  for (int i = 0; i < width * height; ++i) {
    different +=
        difference(pixel(image, i % width, i / width), pixel(swapped, i % width, i / width)) > 8;
  }
  CHECK(different < 60);  // only softened rims may depend on the order
}

TEST_CASE("two draws give the same bytes, whatever was drawn in between") {
  const Mesh mesh = ball({0.f, 0.7f, 0.f}, 0.6f);
  const std::vector<glm::vec3> positions{{0.f, 0.5f, 0.f}, {0.3f, 0.5f, 0.2f}};
  const std::vector<float> values{0.f, 1.f};
  const ParticleCloud cloud{positions, values, 0.2f};
  Renderer renderer(width, height, {}, {}, {});
  const Image first = renderer.draw(mesh, front_view());
  const Image particles = renderer.draw(cloud, front_view());
  CHECK(renderer.draw(mesh, front_view()).pixels == first.pixels);
  CHECK(renderer.draw(cloud, front_view()).pixels == particles.pixels);
  Renderer other(width, height, {}, {}, {});
  CHECK(other.draw(cloud, front_view()).pixels == particles.pixels);
  CHECK(other.draw(mesh, front_view()).pixels == first.pixels);
  CHECK(renderer.draw(mesh, front_view()).pixels == first.pixels);
}

TEST_CASE("a box darkens the floor in its shadow and nowhere else") {
  LookSettings look;
  look.walls = false;
  LightSettings light;
  light.direction = {-1.f, -1.f, 0.f};
  const bool as_liquid = GENERATE(false, true);
  CAPTURE(as_liquid);
  const Mesh solid = box({-0.2f, 0.8f, -0.4f}, {0.4f, 1.f, 0.4f});
  const auto draw = [&](bool shadows) {
    light.shadows = shadows;
    Renderer renderer(width, height, look, light, {});
    if (!as_liquid)
      renderer.set_obstacles(solid);
    return renderer.draw(as_liquid ? solid : Mesh{}, view_from_above());
  };
  const Image with = draw(true), without = draw(false);
  const auto darker = [&](glm::vec3 p) {
    const glm::vec2 place = project(p, view_from_above(), size);
    const int x = static_cast<int>(place.x), y = static_cast<int>(place.y);
    return sum(pixel(without, x, y)) - sum(pixel(with, x, y));
  };
  // The box's middle is 0.9 m above the floor; the light carries its shadow 0.9 m towards -x.
  CHECK(darker({-0.8f, 0.f, 0.f}) > (as_liquid ? 15 : 100));
  CHECK(darker({-0.8f, 0.f, 0.8f}) == 0);
  CHECK(darker({-0.8f, 0.f, -0.8f}) == 0);
  CHECK(darker({0.9f, 0.f, 0.f}) == 0);
}

TEST_CASE("nothing stands on the stage when floor and walls are off") {
  LookSettings look = plain_look();
  const View view = front_view();
  Renderer bare(width, height, look, {}, {});
  const Image empty = bare.draw(Mesh{}, view);
  for (int y = 0; y < height; ++y)
    for (int x = 1; x < width; ++x)
      REQUIRE(pixel(empty, x, y) == pixel(empty, 0, y));
  look.walls = true;
  Renderer walled(width, height, look, {}, {});
  const Image walls = walled.draw(Mesh{}, view);
  const glm::vec2 edge = project({1.f, 0.5f, 1.f}, view, size);
  CHECK(sum(pixel(walls, static_cast<int>(edge.x), static_cast<int>(edge.y))) <
        sum(pixel(empty, static_cast<int>(edge.x), static_cast<int>(edge.y))) - 50);
  CHECK(pixel(walls, width / 2, height / 2) == pixel(empty, width / 2, height / 2));

  look.walls = false;
  look.floor = true;
  look.floor_color = {0.2f, 0.2f, 0.2f};
  Renderer floored(width, height, look, {}, {});
  const Image floor = floored.draw(Mesh{}, view);
  CHECK(sum(pixel(floor, width / 2, height - 1)) < sum(pixel(empty, width / 2, height - 1)) - 100);
  CHECK(pixel(floor, width / 2, 0) == pixel(empty, width / 2, 0));
}

TEST_CASE("a floor seen from below is not there") {
  LookSettings look = plain_look();
  View view = front_view();
  view.position.y = -1.f;
  Renderer bare(width, height, look, {}, {});
  look.floor = true;
  Renderer floored(width, height, look, {}, {});
  CHECK(floored.draw(Mesh{}, view).pixels == bare.draw(Mesh{}, view).pixels);
}

}  // namespace gl_tests
