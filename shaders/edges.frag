// Edges of the domain box: a thin, half-clear grey.
layout(location = 0) out vec4 color;

void main() {
  color = vec4(vec3(0.12, 0.14, 0.17), 0.55);
}
