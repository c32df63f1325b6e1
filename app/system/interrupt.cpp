#include "app/system/interrupt.hpp"

#include <array>
#include <csignal>

namespace spindrift::app {
namespace {

// A signal handler can reach nothing else than a global variable.
std::atomic<bool> interrupted{false};  // NOLINT(cppcoreguidelines-avoid-non-const-global-variables)

void on_signal(int signal) {
  interrupted = true;
  // The loss of a terminal is signalled twice: by the shell, and by the system when the shell ends.
  if (signal != SIGHUP)
    std::signal(signal, SIG_DFL);
}

/// Whether SIGHUP is ignored, as nohup has it so that a run goes on without its terminal.
bool hangup_is_ignored() {
  struct sigaction now {};
  return ::sigaction(SIGHUP, nullptr, &now) == 0 && now.sa_handler == SIG_IGN;
}

}  // namespace

InterruptGuard::InterruptGuard() : hears_hangup_(!hangup_is_ignored()) {
  interrupted = false;
  set(on_signal);
}

InterruptGuard::~InterruptGuard() {
  set(SIG_DFL);
  // The second SIGHUP of a lost terminal may come while the finished part is being reported.
  if (hears_hangup_ && interrupted)
    std::signal(SIGHUP, SIG_IGN);
}

void InterruptGuard::set(void (*handler)(int)) const {
  std::signal(SIGINT, handler);
  std::signal(SIGTERM, handler);
  if (hears_hangup_)
    std::signal(SIGHUP, handler);
}

const std::atomic<bool>& InterruptGuard::requested() {
  return interrupted;
}

}  // namespace spindrift::app
