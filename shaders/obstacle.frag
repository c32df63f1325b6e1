// Solid obstacles: ambient and diffuse light, and a faint Phong highlight.
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 0) out vec4 color;

void main() {
  vec3 n = normalize(gl_FrontFacing ? normal : -normal);
  vec3 v = normalize(frame.eye.xyz - position);
  vec3 lit = frame.obstacle_color.rgb * (sky_fill(n) + direct_light(n));
  color = vec4(lit + 0.15 * highlight(n, v), 1.0);
}
