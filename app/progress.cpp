#include "app/progress.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cmath>
#include <cstdio>

namespace spindrift::app {

std::string duration_text(double seconds) {
  const long s = std::lround(std::ceil(seconds));
  if (s < 90)
    return fmt::format("{} s", s);
  if (s < 5400)
    return fmt::format("{} min {:02} s", s / 60, s % 60);
  return fmt::format("{} h {:02} min", s / 3600, s / 60 % 60);
}

Progress::Progress(std::string scene, int frames, std::size_t particles, bool quiet)
    : scene_(std::move(scene)),
      frames_(frames),
      particles_(particles),
      visible_(!quiet && isatty(STDERR_FILENO)) {}

Progress::~Progress() {
  clear();
}

void Progress::show(const char* stage, int done) {
  using std::chrono::steady_clock;
  if (!visible_)
    return;
  const auto now = steady_clock::now();
  if (done < frames_ && now - last_shown_ < std::chrono::milliseconds(100))
    return;
  last_shown_ = now;
  const std::chrono::duration<double> spent = now - start_;
  const std::string left =
      done > 0 ? duration_text(spent.count() / done * (frames_ - done)) + " left" : "starting";
  fmt::print(stderr, "\r\033[K{}  {}  frame {}/{}  {} particles  {}", scene_, stage, done, frames_,
             particles_.load(), left);
  std::fflush(stderr);
  drawn_ = true;
}

void Progress::clear() {
  if (!drawn_)
    return;
  fmt::print(stderr, "\r\033[K");
  std::fflush(stderr);
  drawn_ = false;
}

}  // namespace spindrift::app
