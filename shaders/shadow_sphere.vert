// A particle's shadow on the floor: a triangle across the light that holds its sphere's outline.
layout(std430, binding = 0) readonly buffer Positions { float positions[]; };
layout(location = 0) out vec2 place;

layout(location = 0) uniform float radius;

void main() {
  int i = gl_VertexID / 3, corner = gl_VertexID % 3;
  vec3 centre = vec3(positions[3 * i], positions[3 * i + 1], positions[3 * i + 2]);
  vec3 z = -frame.light.xyz;
  vec3 x = normalize(abs(z.y) < 0.99 ? vec3(z.z, 0.0, -z.x) : vec3(0.0, -z.z, z.y));
  place = corner == 2 ? vec2(0.0, 2.0) : vec2(corner == 0 ? -1.7321 : 1.7321, -1.0);
  vec3 p = centre + radius * (x * place.x + cross(z, x) * place.y);
  gl_Position = vec4((frame.world_to_shadow * vec4(p, 1.0)).xy, 0.0, 1.0);
}
