// One direction of the shadow's blur. The first pass turns what blocks the light into the share of
// the light that arrives.
layout(location = 0) out vec4 arriving;

layout(binding = 0) uniform sampler2D source;
layout(location = 0) uniform ivec2 step_texels;
layout(location = 1) uniform bool first;

vec3 light_at(ivec2 texel) {
  vec4 value = texelFetch(source, clamp(texel, ivec2(0), textureSize(source, 0) - 1), 0);
  if (!first) {
    return value.rgb;
  }
  // Even a clear liquid spreads some of the light away from the floor.
  float thickness = max(value.r, 0.0);
  return exp2(thickness * (0.6 * frame.liquid_absorption.rgb - 0.7 / frame.liquid_color.w));
}

void main() {
  const int reach = 5;
  ivec2 middle = ivec2(gl_FragCoord.xy);
  vec3 sum = vec3(0.0);
  float weights = 0.0;
  for (int i = -reach; i <= reach; ++i) {
    float weight = exp(-4.5 * float(i * i) / float(reach * reach));
    sum += weight * light_at(middle + i * step_texels);
    weights += weight;
  }
  // The map's rim is lit, and so is everything beyond it.
  ivec2 last = textureSize(source, 0) - 1;
  bool rim = any(equal(middle, ivec2(0))) || any(equal(middle, last));
  arriving = vec4(rim ? vec3(1.0) : sum / weights, 1.0);
}
