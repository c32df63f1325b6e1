// Signals that end a run well, and what stopped a command, in words.
#include <catch2/catch.hpp>
#include <csignal>
#include <new>
#include <stdexcept>

#include "app/system/interrupt.hpp"
#include "app/system/machine_limits.hpp"

namespace app_interrupt_tests {

using namespace spindrift::app;

TEST_CASE("a lost terminal is told of twice and asks once for an end, also after the run") {
  {
    const InterruptGuard guard;
    CHECK_FALSE(InterruptGuard::requested());
    std::raise(SIGHUP);
    CHECK(InterruptGuard::requested());
    std::raise(SIGHUP);  // would end this program
  }
  std::raise(SIGHUP);
  std::signal(SIGHUP, SIG_DFL);
  const InterruptGuard next;
  CHECK_FALSE(InterruptGuard::requested());
}

TEST_CASE("what stopped a command says so when it was memory") {
  CHECK_THAT(reason_of(std::bad_alloc()),
             Catch::Contains("out of memory") && Catch::Contains("larger fluid.spacing"));
  CHECK(reason_of(std::runtime_error("as it says")) == "as it says");
}

}  // namespace app_interrupt_tests
