// Runs the per-particle formulas on the device. Loops run there one after the other, and the host
// does not wait for them; it waits only where a reduction brings it a result.
#pragma once

#include <string_view>

#include "sim/backend/device/algorithms.hpp"
#include "sim/backend/device/arrays.hpp"
#include "sim/backend/device/copy.hpp"
#include "sim/backend/device/loops.hpp"
#include "sim/core/phase_clock.hpp"
#include "sim/core/reductions.hpp"
#include "sim/core/stop.hpp"

namespace spindrift::sim::inline device {

/// A small value in device memory that loops read and write in turn, and that the host looks at
/// only now and then.
template <class T>
class Kept {
 public:
  /// Number of loops that change the value which the host should begin between two looks at it.
  static constexpr int look_every = 4;

  using View = const T*;
  /// Read access for loops, used like a pointer.
  View view() const { return value_.data(); }
  /// The value, for the host, which waits for it.
  T look() const { return fetched(value_.data()); }
  /// Write access for loops.
  T* place() { return value_.data(); }

 private:
  Array<T> value_ = Array<T>(1);
};

/// Runs loops over indices on the device, and measures their time by phase. Every loop but copy()
/// throws Stopped once the flag given to obey() is set.
class Executor {
 public:
  using Index = std::uint32_t;

  /// Calls f(i) for i in [0, n).
  /// @param name the phase in the profile, a string literal; its time ends when the host goes on
  template <class F>
  void for_each(std::string_view name, Index n, F f) {
    throw_if_stopped(stop_);
    const PhaseClock::Scope timed(clock_, name);
    launch(n, f);
  }

  /// Joins f(i) for i in [0, n), in an order that depends on n and the kind of device only, and
  /// waits for the result. T needs `void join(const T&)`.
  template <class T, class F>
  T reduce(std::string_view name, Index n, F f) {
    throw_if_stopped(stop_);
    const PhaseClock::Scope timed(clock_, name);
    if (n == 0)
      return {};
    char* const room = scratch_.allocate(sizeof(T));
    T* const result = reinterpret_cast<T*>(room);
    join_and<T>(scratch_, n, f, [=] SPINDRIFT_HD(const T& total) { *result = total; });
    scratch_.deallocate(room, sizeof(T));
    return fetched(result);
  }

  /// Joins f(i) for i in [0, n) like reduce(), and calls use(*state, total) on the device, without
  /// waiting.
  template <class T, class State, class F, class Use>
  void reduce_to(std::string_view name, Index n, Kept<State>& state, F f, Use use) {
    throw_if_stopped(stop_);
    const PhaseClock::Scope timed(clock_, name);
    State* const to = state.place();
    join_and<T>(scratch_, n, f, [=] SPINDRIFT_HD(const T& total) { use(*to, total); });
  }

  /// Sets `chosen` to the i in [0, n) for which f(i) holds, in order.
  template <class F>
  void select(std::string_view name, Index n, Array<std::uint32_t>& chosen, F f) {
    throw_if_stopped(stop_);
    const PhaseClock::Scope timed(clock_, name);
    flags_.renew(n);
    std::uint8_t* flags = flags_.data();
    launch(n, [=] SPINDRIFT_HD(Index i) { flags[i] = f(i); });
    chosen.renew(n);
    chosen.renew(find_flagged(scratch_, flags, n, chosen.data()));
  }

  /// Adds value(k) to sums[place(k)] for k in [0, n), in the order of k.
  /// @param place_count number that all places are below
  template <class Place, class Value>
  void add_at_places(std::string_view name, Index n, float* sums, Index place_count, Place place,
                     Value value);

  /// Begins to copy f(i) for i in [0, n), as it is now, for the host to use later.
  template <class T, class F>
  Copy<T> copy(std::string_view name, Index n, F f) {
    const PhaseClock::Scope timed(clock_, name);
    std::shared_ptr<CopyRoom> room = copies_.take(n * sizeof(T));
    T* const to = static_cast<T*>(room->on_device());
    launch(n, [=] SPINDRIFT_HD(Index i) { to[i] = f(i); });
    room->send(n * sizeof(T));
    return {std::move(room), n};
  }

  /// @param spacing of the particles, m
  /// @throws std::runtime_error where the device has no memory for so many particles
  void check_room(std::size_t particles, float spacing) const {
    device::check_room(particles, spacing, free_memory());
  }

  /// Waits until the host may access the particles.
  void wait() const { device::wait(); }

  /// Makes all loops from now on throw Stopped once `stop` is true, but for copies, which are of
  /// what is finished.
  void obey(Stop stop) { stop_ = stop; }

  PhaseClock& clock() { return clock_; }
  const PhaseClock& clock() const { return clock_; }
  std::size_t memory_bytes() const {
    return bytes_of(scratch_, copies_, flags_, places_, other_places_, terms_, other_terms_);
  }

 private:
  PhaseClock clock_;
  Stop stop_ = nullptr;
  Scratch scratch_;
  CopyRooms copies_;
  Array<std::uint8_t> flags_;  ///< working memory of select()
  // Working memory of add_at_places().
  Array<std::uint32_t> places_, other_places_, terms_, other_terms_;
};

/// Terms are sorted by their places, and the thread of each place's first term adds up all of them.
template <class Place, class Value>
void Executor::add_at_places(std::string_view name, Index n, float* sums, Index place_count,
                             Place place, Value value) {
  throw_if_stopped(stop_);
  const PhaseClock::Scope timed(clock_, name);
  if (n == 0)
    return;
  for (Array<std::uint32_t>* array : {&places_, &other_places_, &terms_, &other_terms_})
    array->renew(n);
  std::uint32_t *places = places_.data(), *other_places = other_places_.data(),
                *terms = terms_.data(), *other_terms = other_terms_.data();
  launch(n, [=] SPINDRIFT_HD(Index k) {
    places[k] = place(k);
    terms[k] = k;
  });
  sort_pairs(scratch_, n, bits_below(place_count), places, other_places, terms, other_terms);
  launch(n, [=] SPINDRIFT_HD(Index k) {
    const Index at = places[k];
    if (k > 0 && places[k - 1] == at)
      return;
    float sum = sums[at];
    for (Index t = k; t < n && places[t] == at; ++t)
      sum += value(terms[t]);
    sums[at] = sum;
  });
}

}  // namespace spindrift::sim::inline device
