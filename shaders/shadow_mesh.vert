// A mesh on its way along the light to the floor.
layout(location = 0) in vec3 vertex;

void main() {
  gl_Position = vec4((frame.world_to_shadow * vec4(vertex, 1.0)).xy, 0.0, 1.0);
}
