// The profile of a run: wall time by phase.
#pragma once

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace spindrift::sim {

/// The wall time and the number of calls of a phase.
struct PhaseTime {
  std::string name;
  double seconds = 0;
  std::int64_t calls = 0;
};

/// Adds up the wall time and the calls of each phase under its name.
class PhaseClock {
 public:
  /// Adds the time between its construction and its destruction to a phase.
  class Scope {
   public:
    /// @param name the phase, a string that outlives the scope
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
                              [&](const PhaseTime& e) { return e.name == name; });
    if (entry == entries_.end())
      entry = entries_.insert(entries_.end(), PhaseTime{std::string(name)});
    entry->seconds += seconds;
    ++entry->calls;
  }
  /// The phases in the order in which they were first added.
  const std::vector<PhaseTime>& entries() const { return entries_; }

 private:
  std::vector<PhaseTime> entries_;
};

}  // namespace spindrift::sim
