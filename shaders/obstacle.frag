// Solid obstacles as they are seen through the liquid or alone.
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 0) out vec4 color;

void main() {
  vec3 n = normalize(gl_FrontFacing ? normal : -normal);
  color = vec4(obstacle_light(n, normalize(frame.eye.xyz - position)), 1.0);
}
