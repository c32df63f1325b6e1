// The backdrop: a vertical gradient.
layout(location = 0) out vec4 color;

void main() {
  color = vec4(background(gl_FragCoord.y), 1.0);
}
