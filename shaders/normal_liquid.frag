// The liquid's nearest surface, to be lit later, once per pixel: its normal.
layout(location = 1) in vec3 normal;
layout(location = 0) out vec4 surface;  // alpha: 0 nothing, 1/3 an obstacle, 1 liquid

void main() {
  surface = vec4(0.5 + 0.5 * normal, 1.0);
}
