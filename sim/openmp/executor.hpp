// Runs the per-particle formulas on the processor's cores. Every result is the same for any number
// of threads: particles are independent within a loop, and sums are taken over blocks of fixed
// size, in order.
#pragma once

#include <omp.h>

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <string_view>
#include <vector>

namespace spindrift::sim {

/// Adds up the wall time of a phase under its name.
class PhaseClock {
 public:
  struct Entry {
    std::string_view name;
    double seconds = 0;
    std::int64_t calls = 0;
  };
  class Scope {
   public:
    Scope(PhaseClock& clock, std::string_view name)
        : clock_(clock), name_(name), start_(std::chrono::steady_clock::now()) {}
    ~Scope() {
      const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - start_;
      clock_.add(name_, spent.count());
    }
    Scope(const Scope&) = delete;
    Scope& operator=(const Scope&) = delete;

   private:
    PhaseClock& clock_;
    std::string_view name_;
    std::chrono::steady_clock::time_point start_;
  };

  void add(std::string_view name, double seconds) {
    auto entry = std::find_if(entries_.begin(), entries_.end(),
                              [&](const Entry& e) { return e.name == name; });
    if (entry == entries_.end())
      entry = entries_.insert(entries_.end(), Entry{name});
    entry->seconds += seconds;
    ++entry->calls;
  }
  const std::vector<Entry>& entries() const { return entries_; }

 private:
  std::vector<Entry> entries_;
};

/// A sum to reduce to, in double precision.
struct Sum {
  double value = 0;
  void join(const Sum& other) { value += other.value; }
};

/// The largest of values that are not negative.
struct Largest {
  float value = 0;
  void join(const Largest& other) { value = std::max(value, other.value); }
};

class Executor {
 public:
  using Index = std::uint32_t;
  static constexpr Index block_size = 512;  ///< particles per task and per partial sum

  /// f(i) for i in [0, n). `name` is the phase in the profile; a string literal.
  template <class F>
  void for_each(std::string_view name, Index n, F f) {
    const PhaseClock::Scope timed(clock_, name);
    const std::int64_t blocks = block_count(n);
#pragma omp parallel for schedule(dynamic, 1)
    for (std::int64_t b = 0; b < blocks; ++b) {
      const Index begin = static_cast<Index>(b) * block_size;
      const Index end = std::min(n, begin + block_size);
      for (Index i = begin; i < end; ++i)
        f(i);
    }
  }

  /// Like for_each, and joins what f returns: block by block in order, so that the result of a
  /// floating-point sum does not depend on the threads. T needs `void join(const T&)`.
  template <class T, class F>
  T reduce(std::string_view name, Index n, F f) {
    const PhaseClock::Scope timed(clock_, name);
    const std::int64_t blocks = block_count(n);
    std::vector<T> partial(static_cast<std::size_t>(blocks));
#pragma omp parallel for schedule(dynamic, 1)
    for (std::int64_t b = 0; b < blocks; ++b) {
      const Index begin = static_cast<Index>(b) * block_size;
      const Index end = std::min(n, begin + block_size);
      T sum;
      for (Index i = begin; i < end; ++i)
        sum.join(f(i));
      partial[static_cast<std::size_t>(b)] = sum;
    }
    T total;
    for (const T& p : partial)
      total.join(p);
    return total;
  }

  PhaseClock& clock() {
    return clock_;
  }
  const PhaseClock& clock() const {
    return clock_;
  }

 private:
  static std::int64_t block_count(Index n) {
    return (n + block_size - 1) / block_size;
  }
  PhaseClock clock_;
};

}  // namespace spindrift::sim
