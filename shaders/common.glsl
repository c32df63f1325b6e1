// What every shader sees: the frame's camera, light and colours, and the shading they share.
// Colours are linear RGB; lengths are in m.

const float ribbon_pixels = 1.6;  // width of the domain box's edges

layout(std140, binding = 0) uniform Frame {
  mat4 world_to_clip;
  mat4 world_to_shadow;    // to clip space of the floor's shadow map
  vec4 eye;                // position; w: height of a pixel at distance 1
  vec4 ray;                // line of sight through the picture's middle, 1 long
  vec4 ray_x, ray_y;       // from there to the picture's right edge and to its top edge
  vec4 light;              // unit direction the light travels; w: sky fill, relative to the light
  vec4 radiance;           // colour times intensity
  vec4 liquid_color;       // w: the depth of liquid after which white light has this colour
  vec4 liquid_absorption;  // logarithm to base 2 of what 1 m of liquid lets through
  vec4 gloss;              // Phong exponent, strength of the highlight
  vec4 obstacle_color;
  vec4 background_top;
  vec4 background_bottom;
  vec4 floor_color;        // w: distance from the stage's middle at which the floor has faded
  vec4 stage_min;
  vec4 stage_max;
  vec4 viewport;           // width, height, 1/width, 1/height
  vec4 depth_scale;        // see range_of()
} frame;

// How far before the eye a value of the depth buffer lies, along the camera's axis.
float range_of(float depth) {
  return frame.depth_scale.y / (2.0 * depth - 1.0 + frame.depth_scale.x);
}

// The backdrop behind a pixel: from the colour of the picture's bottom row to that of its top row.
vec3 background(float y) {
  float t = clamp((y - 0.5) / max(frame.viewport.y - 1.0, 1.0), 0.0, 1.0);
  return mix(frame.background_bottom.rgb, frame.background_top.rgb, t);
}

// Light of the sky and, from below, of the floor, on a surface facing n: a hemisphere light.
vec3 sky_fill(vec3 n) {
  return frame.light.w * frame.radiance.rgb * mix(vec3(0.45), vec3(1.0), 0.5 + 0.5 * n.y);
}

// The light's own share on a surface facing n.
vec3 direct_light(vec3 n) {
  return frame.radiance.rgb * max(dot(n, -frame.light.xyz), 0.0);
}

// Phong's highlight: v points to the eye.
vec3 highlight(vec3 n, vec3 v) {
  float along = max(dot(reflect(frame.light.xyz, n), v), 0.0);
  return frame.gloss.y * frame.radiance.rgb * pow(along, frame.gloss.x);
}

// Solid obstacles: ambient and diffuse light, and a faint Phong highlight. v points to the eye.
vec3 obstacle_light(vec3 n, vec3 v) {
  return frame.obstacle_color.rgb * (sky_fill(n) + direct_light(n)) + 0.15 * highlight(n, v);
}
