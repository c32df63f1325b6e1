// A particle as a lit sphere, with the depth of the sphere and a rim softened over its samples.
layout(location = 0) in vec2 place;
layout(location = 1) flat in vec3 albedo;
layout(location = 2) flat in vec3 to_light;
layout(location = 3) flat in vec3 up;
layout(location = 4) flat in vec4 depth;
layout(location = 5) flat in vec4 weight;
layout(location = 0) out vec4 color;

void main() {
  float r = length(place);
  float covered = clamp((1.0 - r) / max(fwidth(r), 1e-6) + 0.5, 0.0, 1.0);
  if (covered <= 0.0) {
    discard;
  }
  vec3 n = vec3(place, sqrt(max(1.0 - r * r, 0.0))) / max(r, 1.0);
  gl_FragDepth = 0.5 + 0.5 * dot(depth, vec4(n, 1.0)) / dot(weight, vec4(n, 1.0));

  float facing = dot(n, to_light);
  float mirrored = max(2.0 * facing * n.z - to_light.z, 0.0);
  vec3 lit = albedo * (frame.light.w * mix(0.45, 1.0, 0.5 + 0.5 * dot(n, up)) + max(facing, 0.0));
  float shine = 0.3 * frame.gloss.y * pow(mirrored, frame.gloss.x);
  color = vec4(frame.radiance.rgb * (lit + shine), covered);
}
