// Runs the per-particle formulas on the CPU's cores. Every result is the same for any number of
// threads: particles are independent within a loop, and sums are taken over blocks of fixed size,
// in order.
#pragma once

#include <omp.h>

#include <algorithm>
#include <cstdint>
#include <string_view>
#include <utility>
#include <vector>

#include "sim/backend/openmp/arrays.hpp"
#include "sim/core/phase_clock.hpp"
#include "sim/core/reductions.hpp"
#include "sim/core/stop.hpp"

namespace spindrift::sim::inline openmp {

/// A small value that loops read and write in turn, and that the code around them looks at now and
/// then.
template <class T>
class Kept {
 public:
  /// Number of loops that change the value between two looks at it; here a look costs nothing.
  static constexpr int look_every = 1;

  /// A copy of the value, used like a pointer to it.
  struct View {
    T value;
    const T* operator->() const { return &value; }
    const T& operator*() const { return value; }
  };
  /// Read access for loops.
  View view() const { return {value_}; }
  /// The value, outside of loops.
  const T& look() const { return value_; }
  /// Write access for loops.
  T* place() { return &value_; }

 private:
  T value_{};
};

/// An array of elements as they were when they were copied.
template <class T>
class Copy {
 public:
  explicit Copy(std::vector<T> values) : values_(std::move(values)) {}
  /// The elements. To be called once.
  std::vector<T> take() { return std::move(values_); }

 private:
  std::vector<T> values_;
};

/// Runs loops over indices on the CPU's cores, and measures their time by phase. Every loop but
/// copy() throws Stopped once the flag given to obey() is set.
class Executor {
 public:
  using Index = std::uint32_t;
  static constexpr Index block_size = 512;  ///< particles per task and per partial sum

  /// Calls f(i) for i in [0, n).
  /// @param name the phase in the profile, a string literal
  template <class F>
  void for_each(std::string_view name, Index n, F f) {
    throw_if_stopped(stop_);
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

  /// Joins f(i) for i in [0, n), block by block in order, so that the result of a floating-point
  /// sum does not depend on the threads. T needs `void join(const T&)`.
  template <class T, class F>
  T reduce(std::string_view name, Index n, F f) {
    throw_if_stopped(stop_);
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

  /// Joins f(i) for i in [0, n) like reduce(), and calls use(*state, total).
  template <class T, class State, class F, class Use>
  void reduce_to(std::string_view name, Index n, Kept<State>& state, F f, Use use) {
    use(*state.place(), reduce<T>(name, n, f));
  }

  /// Sets `chosen` to the i in [0, n) for which f(i) holds, in order.
  template <class F>
  void select(std::string_view name, Index n, Array<Index>& chosen, F f) {
    throw_if_stopped(stop_);
    const PhaseClock::Scope timed(clock_, name);
    chosen.clear();
    for (Index i = 0; i < n; ++i)
      if (f(i))
        chosen.push_back(i);
  }

  /// Adds value(k) to sums[place(k)] for k in [0, n), in the order of k.
  template <class Place, class Value>
  void add_at_places(std::string_view name, Index n, float* sums, Index, Place place, Value value) {
    throw_if_stopped(stop_);
    const PhaseClock::Scope timed(clock_, name);
    for (Index k = 0; k < n; ++k)
      sums[place(k)] += value(k);
  }

  /// Copies f(i) for i in [0, n), as it is now, for later use.
  template <class T, class F>
  Copy<T> copy(std::string_view name, Index n, F f) {
    const PhaseClock::Scope timed(clock_, name);
    std::vector<T> values;
    values.reserve(n);
    for (Index i = 0; i < n; ++i)
      values.push_back(f(i));
    return Copy<T>(std::move(values));
  }

  /// Checks nothing: allocations fail by themselves where particles do not fit into the memory.
  void check_room(std::size_t, float) const {}

  /// Does nothing: particles may be accessed outside of loops at any time.
  void wait() const {}

  std::size_t memory_bytes() const {
    return 0;
  }

  /// Makes all loops from now on throw Stopped once `stop` is true, but for copies, which are of
  /// what is finished.
  void obey(Stop stop) {
    stop_ = stop;
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
  Stop stop_ = nullptr;
};

}  // namespace spindrift::sim::inline openmp
