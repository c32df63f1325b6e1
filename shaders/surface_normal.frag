// The nearest surface's normal and what it is, to be lit later, once per pixel.
layout(location = 1) in vec3 normal;
layout(location = 0) out vec4 surface;  // alpha: 0 nothing, 1/3 an obstacle, 1 liquid

layout(location = 0) uniform float kind;

void main() {
  vec3 n = kind < 0.5 && !gl_FrontFacing ? -normal : normal;
  surface = vec4(0.5 + 0.5 * n, kind);
}
