// A solid as a triangle mesh; what is under the floor is cut off when clipping is on.
layout(location = 0) in vec3 vertex;
layout(location = 1) in vec3 vertex_normal;
layout(location = 0) out vec3 position;
layout(location = 1) out vec3 normal;
out float gl_ClipDistance[1];

void main() {
  position = vertex;
  normal = vertex_normal;
  gl_Position = frame.world_to_clip * vec4(vertex, 1.0);
  gl_ClipDistance[0] = vertex.y - frame.stage_min.y;
}
