// A mesh on its way along the light to the floor.
layout(location = 0) in vec3 vertex;
layout(location = 0) out float travelled;

void main() {
  vec4 on_floor = frame.world_to_shadow * vec4(vertex, 1.0);
  travelled = dot(vertex - frame.stage_min.xyz, frame.light.xyz);
  gl_Position = vec4(on_floor.xy, 0.0, 1.0);
}
