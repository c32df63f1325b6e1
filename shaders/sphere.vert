// A particle as a triangle that faces the eye and holds the sphere's silhouette. All that its pixels
// need is given in the sphere's own axes: x and y across the line of sight, z towards the eye.
layout(std430, binding = 0) readonly buffer Positions { float positions[]; };
layout(std430, binding = 1) readonly buffer Values { float values[]; };
layout(location = 0) uniform vec3 span;  // radius, value at the colour map's low and high end

layout(location = 0) out vec2 place;  // length 1 on the silhouette
layout(location = 1) flat out vec3 albedo;
layout(location = 2) flat out vec3 to_light;
layout(location = 3) flat out vec3 up;
layout(location = 4) flat out vec4 depth;   // clip-space z along the axes and at the centre
layout(location = 5) flat out vec4 weight;  // clip-space w likewise

// A path through the OKLCh colour space: lightness grows evenly from deep blue over teal to pale
// yellow, so that equal steps of the attribute look equal.
// Oklab: B. Ottosson, "A perceptual color space for image processing", 2020.
vec3 color_map(float t) {
  float lightness = mix(0.36, 0.93, t);
  float hue = radians(mix(272.0, 105.0, t));
  float chroma = mix(0.13, 0.11, t);
  float a = chroma * cos(hue), b = chroma * sin(hue);
  vec3 cones = vec3(lightness + 0.3963377774 * a + 0.2158037573 * b,
                    lightness - 0.1055613458 * a - 0.0638541728 * b,
                    lightness - 0.0894841775 * a - 1.2914855480 * b);
  cones = cones * cones * cones;
  return clamp(mat3(4.0767416621, -1.2684380046, -0.0041960863, -3.3077115913, 2.6097574011,
                    -0.7034186147, 0.2309699292, -0.3413193965, 1.7076147010) * cones, 0.0, 1.0);
}

void main() {
  int i = gl_VertexID / 3, corner = gl_VertexID % 3;
  vec3 centre = vec3(positions[3 * i], positions[3 * i + 1], positions[3 * i + 2]);
  float radius = span.x;
  vec3 to_eye = frame.eye.xyz - centre;
  float range = max(length(to_eye), 1.001 * radius);
  vec3 z = to_eye / range;
  vec3 x = normalize(abs(z.y) < 0.99 ? vec3(z.z, 0.0, -z.x) : vec3(0.0, -z.z, z.y));
  mat3 axes = mat3(x, cross(z, x), z);

  // The cone of sight that touches the sphere is this wide where the triangle stands; a pixel more
  // gives room for a soft rim.
  float reach = radius * range / sqrt(range * range - radius * radius);
  float margin = 1.0 + frame.eye.w * range / radius;
  place = margin * (corner == 2 ? vec2(0.0, 2.0) : vec2(corner == 0 ? -1.7321 : 1.7321, -1.0));
  gl_Position = frame.world_to_clip * vec4(centre + axes * vec3(reach * place, 0.0), 1.0);

  albedo = color_map(clamp((values[i] - span.y) / max(span.z - span.y, 1e-30), 0.0, 1.0));
  to_light = -frame.light.xyz * axes;
  up = vec3(0.0, 1.0, 0.0) * axes;
  mat4 rows = transpose(frame.world_to_clip);
  depth = vec4(radius * (rows[2].xyz * axes), dot(rows[2], vec4(centre, 1.0)));
  weight = vec4(radius * (rows[3].xyz * axes), dot(rows[3], vec4(centre, 1.0)));
}
