#include "app/system/interrupt.hpp"

#include <array>
#include <csignal>

namespace spindrift::app {
namespace {

// A signal handler can reach nothing else.
std::atomic<bool> interrupted{false};

void on_signal(int signal) {
  interrupted = true;
  // A lost terminal is told of twice: by the shell, and by the system when the shell ends.
  if (signal != SIGHUP)
    std::signal(signal, SIG_DFL);
}

/// Whether nohup has asked for the run to go on without its terminal.
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
  // The second word of a lost terminal may come while what was finished is being reported.
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
