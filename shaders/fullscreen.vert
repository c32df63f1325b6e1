// One triangle that covers the picture.
layout(location = 0) out vec3 sight;  // from the eye through the pixel

void main() {
  vec2 corner = vec2(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0);
  sight = frame.ray.xyz + corner.x * frame.ray_x.xyz + corner.y * frame.ray_y.xyz;
  gl_Position = vec4(corner, 0.0, 1.0);
}
