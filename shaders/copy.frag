// A picture pixel by pixel, byte by byte.
layout(location = 0) out vec4 color;

layout(binding = 0) uniform sampler2D source;

void main() {
  color = texelFetch(source, ivec2(gl_FragCoord.xy), 0);
}
