#include <sys/auxv.h>
#include <unistd.h>

#include <array>
#include <climits>
#include <cstdlib>

#include "app/commands/command_line.hpp"
#include "app/errors/errors.hpp"
#include "app/system/standard_streams.hpp"

namespace {

/// Threads that wait for others at the end of a loop spin for milliseconds before they sleep
/// (GOMP_SPINCOUNT in the manual of libgomp). Where another program holds a core, what they wait
/// for cannot run meanwhile, and every loop takes that long. Some 30 µs bridge the time between
/// two loops as well. libgomp reads its environment when it is loaded, before main():
/// so the program runs itself once more, unless the user has said how to wait.
void wait_for_threads_shortly(char** argv) {
  if (std::getenv("GOMP_SPINCOUNT") != nullptr || std::getenv("OMP_WAIT_POLICY") != nullptr)
    return;
  // The dynamic linker, run as a program of its own, is what /proc would name; it has no linker.
  if (::getauxval(AT_BASE) == 0)
    return;
  ::setenv("GOMP_SPINCOUNT", "2000", 1);
  std::array<char, PATH_MAX> program{};
  if (::readlink("/proc/self/exe", program.data(), program.size() - 1) > 0)
    ::execv(program.data(), argv);  // returns only where that fails; it is then slower, no more
}

}  // namespace

int main(int argc, char** argv) {
  wait_for_threads_shortly(argv);
  spindrift::app::prepare_process();
  const int code = spindrift::app::run_command_line(argc, argv);
  return spindrift::app::all_printed() || code != spindrift::app::done ? code
                                                                       : spindrift::app::run_failed;
}
