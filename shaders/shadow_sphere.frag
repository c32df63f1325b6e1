// A particle's disc in the floor's shadow.
layout(location = 0) in vec2 place;
layout(location = 0) out float blocked;  // m of liquid

void main() {
  if (dot(place, place) > 1.0) {
    discard;
  }
  blocked = 1e6;  // as good as opaque
}
