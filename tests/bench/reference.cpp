// A fixed amount of plain arithmetic, as a measure of the machine: what takes so many times as long
// on one machine takes about as many times as long on another. Like a sum over neighbours, it
// gathers numbers by indices, multiplies and adds them, and takes roots.
// Prints the seconds that it took.
#include <chrono>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <vector>

int main() {
  constexpr std::uint32_t count = 1 << 18, neighbours = 32;
  constexpr int passes = 16;
  std::vector<float> x(count), sum(count);
  std::vector<std::uint32_t> index(std::size_t{count} * neighbours);
  std::uint32_t random = 1;
  const auto next = [&random] {
    return random = 1664525u * random + 1013904223u;
  };  // Numerical Recipes
  for (float& value : x)
    value = static_cast<float>(next() >> 8) / (1 << 24);
  for (std::size_t k = 0; k < index.size(); ++k)  // near by, as particles in cells are
    index[k] = (static_cast<std::uint32_t>(k / neighbours) + (next() >> 22)) % count;
  const auto begin = std::chrono::steady_clock::now();
  for (int pass = 0; pass < passes; ++pass) {
    for (std::uint32_t i = 0; i < count; ++i) {
      float s = 0;
      for (std::uint32_t k = 0; k < neighbours; ++k) {
        const float d = x[i] - x[index[std::size_t{i} * neighbours + k]];
        const float q = std::sqrt(d * d + 0.01f);
        s += (1 - q) * (1 - q) * (1 - q);
      }
      sum[i] = s;
    }
    for (std::uint32_t i = 0; i < count; ++i)
      x[i] = 0.5f * (x[i] + sum[i] / neighbours);
  }
  const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - begin;
  std::printf("%.4f\n", spent.count());
  return std::isfinite(x[0]) ? 0 : 1;
}
