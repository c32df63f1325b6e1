// How much liquid lies behind a pixel, along the camera's axis: added up over all faces of the
// closed surface, far sides count positive and near sides negative. Nothing behind an obstacle
// counts.
layout(location = 0) out float signed_range;

layout(binding = 0) uniform sampler2D obstacle_range;

void main() {
  ivec2 texel = min(ivec2(gl_FragCoord.xy), textureSize(obstacle_range, 0) - 1);
  float range = min(1.0 / gl_FragCoord.w, texelFetch(obstacle_range, texel, 0).r);
  signed_range = gl_FrontFacing ? -range : range;
}
