// Liquid between light and floor: sides that light leaves count positive, sides it enters negative.
layout(location = 0) in float travelled;
layout(location = 0) out float blocked;  // m of liquid

void main() {
  blocked = gl_FrontFacing ? -travelled : travelled;
}
