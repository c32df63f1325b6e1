// Edges of the domain box: a thin, half-clear grey, hidden as far as samples of something lie before
// it.
layout(location = 0) in float offset;  // from the ribbon's middle, in pixels
layout(location = 0) out vec4 color;

layout(binding = 0) uniform sampler2DMS depth;

void main() {
  float seen = 0.0;
  for (int i = 0; i < 4; ++i) {
    seen += gl_FragCoord.z <= texelFetch(depth, ivec2(gl_FragCoord.xy), i).r ? 0.25 : 0.0;
  }
  float covered = clamp(0.5 * ribbon_pixels + 0.5 - abs(offset), 0.0, 1.0);
  color = vec4(vec3(0.12, 0.14, 0.17), 0.55 * seen * covered);
}
