// How far before the eye an opaque surface lies, along the camera's axis.
layout(location = 0) out float range;

void main() {
  range = 1.0 / gl_FragCoord.w;
}
