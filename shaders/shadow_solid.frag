// Something opaque between light and floor.
layout(location = 0) out float blocked;  // m of liquid

void main() {
  blocked = 1e6;  // as good as opaque
}
