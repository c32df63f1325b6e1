// The twelve edges of the domain box as thin ribbons that face the eye, one instance each.
//
//      6-------7      y
//     /|      /|      |
//    2-------3 |      o-- x
//    | 4-----|-5     /
//    |/      |/     z: corner 0 is the minimum, bit 0 is x, bit 1 is y, bit 2 is -z in this picture
//    0-------1

layout(location = 0) out float offset;  // from the middle, in pixels

vec3 box_corner(int index) {
  return mix(frame.stage_min.xyz, frame.stage_max.xyz,
             vec3(index & 1, (index >> 1) & 1, (index >> 2) & 1));
}

void main() {
  // Edge i runs along axis i / 4; its four copies differ in the other two axes' bits.
  int axis = gl_InstanceID / 4;
  int other = gl_InstanceID % 4;
  int low = (axis + 1) % 3, high = (axis + 2) % 3;
  int start = ((other & 1) << low) | ((other >> 1) << high);
  vec3 from = box_corner(start), to = box_corner(start | (1 << axis));
  vec3 along = to - from;
  vec3 p = (gl_VertexID & 1) == 0 ? from : to;
  vec3 to_eye = frame.eye.xyz - p;
  float pixel = frame.eye.w * length(to_eye);
  vec3 across = cross(along, to_eye);
  // Wider by a pixel on each side, for soft rims.
  float reach = 0.5 * ribbon_pixels + 1.0;
  across *= reach * pixel / max(length(across), 1e-20);
  offset = (gl_VertexID & 2) == 0 ? reach : -reach;
  p += (gl_VertexID & 2) == 0 ? across : -across;
  // Slightly towards the eye, so that liquid at the wall does not cover the edge in front of it.
  p += to_eye * 2e-3;
  gl_Position = frame.world_to_clip * vec4(p, 1.0);
}
