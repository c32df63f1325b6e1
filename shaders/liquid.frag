// The surfaces of the liquid and of the obstacles, lit once per pixel: four samples say how much of
// the pixel each covers, and what its mean normal is there.
//
// The liquid: Phong's ambient, diffuse and specular light on a body that is clear where it is thin.
// What lies behind is seen bent by Snell's law and coloured by Beer and Lambert's law; what is in
// front is mirrored by Schlick's approximation of Fresnel's law, less than
// fully at the rim, where white on a white backdrop would not be seen.
layout(location = 0) in vec3 sight;
layout(location = 0) out vec4 color;  // alpha: share of the pixel that is covered

layout(binding = 0) uniform sampler2D thickness_map;
layout(binding = 1) uniform sampler2D behind;  // the picture without the liquid, sRGB-encoded
layout(binding = 2) uniform sampler2DMS surface;
layout(binding = 3) uniform sampler2DMS depth;
layout(location = 0) uniform bool has_obstacles;

const float refractive_index = 1.33;

// The studio as the liquid mirrors it: a bright ceiling, a pale horizon, a wide soft lamp.
vec3 studio(vec3 direction) {
  float height = clamp(direction.y * 1.2 + 0.1, 0.0, 1.0);
  vec3 sky = mix(frame.background_bottom.rgb, frame.background_top.rgb, height);
  float lamp = clamp(dot(direction, -frame.light.xyz) * 6.0 - 4.8, 0.0, 1.0);
  return sky + 1.5 * lamp * lamp * frame.radiance.rgb;
}

// Light from the liquid at a distance along the camera's axis; v points to the eye.
vec3 liquid_light(vec3 n, vec3 v, float range) {
  float facing = clamp(dot(n, v), 0.0, 1.0);
  vec2 pixel = gl_FragCoord.xy * frame.viewport.zw;
  float thickness = max(textureLod(thickness_map, pixel, 0.0).r, 0.0) * length(sight);
  vec3 inside = refract(-v, n, 1.0 / refractive_index);
  vec3 position = frame.eye.xyz + sight * range;
  vec4 leaving = frame.world_to_clip * vec4(position + inside * thickness, 1.0);
  vec3 seen = textureLod(behind, leaving.xy / leaving.w * 0.5 + 0.5, 0.0).rgb;
  seen *= seen * (seen * 0.305306011 + 0.682171111) + 0.012522878;  // near enough to sRGB decoded
  // A grazing look meets more liquid than the straight line through it: rims stay readable.
  float graze = 1.0 - facing;
  thickness += 0.22 * frame.liquid_color.w * graze * graze;
  vec3 through = seen * exp2(thickness * frame.liquid_absorption.rgb);

  float body = 1.0 - exp2(-1.7 * thickness / frame.liquid_color.w);
  vec3 phong = frame.liquid_color.rgb * (sky_fill(n) + direct_light(n));
  float fresnel = 0.02 + 0.70 * graze * graze * graze * graze * graze;
  vec3 shaded = mix(through, phong, body);
  return mix(shaded, studio(reflect(-v, n)), fresnel) + highlight(n, v);
}

void main() {
  ivec2 texel = ivec2(gl_FragCoord.xy);
  vec4 liquid = vec4(0.0), obstacle = vec4(0.0);
  int nearest = 0;
  for (int i = 3; i >= 0; --i) {
    vec4 s = texelFetch(surface, texel, i);
    vec4 counted = vec4(2.0 * s.rgb - 1.0, 1.0);
    if (s.a > 0.5) {
      liquid += counted;
      nearest = i;
    } else if (s.a > 0.0) {
      obstacle += counted;
    }
  }
  float covered = liquid.w + obstacle.w;
  if (covered == 0.0) {
    discard;
  }
  vec3 v = -normalize(sight);
  float range = range_of(texelFetch(depth, texel, nearest).r);
  vec3 light = liquid.w * liquid_light(normalize(liquid.xyz + 1e-4 * v), v, range);
  if (has_obstacles) {
    light += obstacle.w * obstacle_light(normalize(obstacle.xyz + 1e-4 * v), v);
  }
  color = vec4(light / covered, 0.25 * covered);
}
