// Where the time goes.
#pragma once

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

}  // namespace spindrift::sim
