// The floor under the light, with the shadow that falls on it; it fades into the backdrop, so that
// there is no horizon.
layout(location = 0) in vec3 sight;
layout(location = 0) out vec4 color;

layout(binding = 0) uniform sampler2D shadow;  // share of the light that arrives

void main() {
  float drop = frame.stage_min.y - frame.eye.y;
  vec3 position = frame.eye.xyz + sight * (drop / min(sight.y, -1e-6));
  vec4 place = frame.world_to_shadow * vec4(position, 1.0);
  vec3 arriving = texture(shadow, place.xy * 0.5 + 0.5).rgb;
  // What hides the light hides part of the sky as well.
  const vec3 up = vec3(0.0, 1.0, 0.0);
  vec3 lit = direct_light(up) * arriving + sky_fill(up) * mix(vec3(0.6), vec3(1.0), arriving);
  vec2 from_middle = position.xz - 0.5 * (frame.stage_min.xz + frame.stage_max.xz);
  float fade = smoothstep(0.25, 1.0, length(from_middle) / frame.floor_color.w);
  color = vec4(mix(frame.floor_color.rgb * lit, background(gl_FragCoord.y), fade), 1.0);
}
