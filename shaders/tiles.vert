// The picture's tiles in which something stands.
layout(location = 0) in vec2 corner;
layout(location = 0) out vec3 sight;  // from the eye through the pixel

void main() {
  sight = frame.ray.xyz + corner.x * frame.ray_x.xyz + corner.y * frame.ray_y.xyz;
  gl_Position = vec4(corner, 0.0, 1.0);
}
