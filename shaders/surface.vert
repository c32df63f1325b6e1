// A triangle mesh as it is.
layout(location = 0) in vec3 vertex;
layout(location = 1) in vec3 vertex_normal;
layout(location = 0) out vec3 position;
layout(location = 1) out vec3 normal;

void main() {
  position = vertex;
  normal = vertex_normal;
  gl_Position = frame.world_to_clip * vec4(vertex, 1.0);
}
