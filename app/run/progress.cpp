#include "app/run/progress.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>

namespace spindrift::app {

std::string duration_text(double seconds) {
  const long s = std::lround(std::ceil(seconds));
  if (s < 90)
    return fmt::format("{} s", s);
  if (s < 5400)
    return fmt::format("{} min {:02} s", s / 60, s % 60);
  return fmt::format("{} h {:02} min", s / 3600, s / 60 % 60);
}

bool LogPace::is_due(double part) {
  using namespace std::chrono;
  const auto now = steady_clock::now();
  const bool due = told_part_ < 0 || std::floor(10 * part) > std::floor(10 * told_part_) ||
                   now - told_ >= longest_silence;
  if (due) {
    told_part_ = part;
    told_ = now;
  }
  return due;
}

Progress::Progress(const Scene& scene, const RenderOptions& options, int frames,
                   std::size_t particles)
    : scene_(scene.name),
      frames_(frames),
      frames_per_second_(scene.video.frames_per_second.per_second()),
      particles_(particles),
      form_(options.progress == ProgressKind::json ? Form::json
            : options.quiet                        ? Form::none
            : isatty(STDERR_FILENO)                ? Form::terminal
                                                   : Form::log) {
  if (form_ != Form::log)
    return;
  pace_.is_due(0);
  fmt::print(stderr, "{}: {} frames, {} particles at the start\n", scene_, frames_, particles);
  heartbeat_.emplace(longest_silence, [this] { show_in_log(); });
}

Progress::~Progress() {
  if (!drawn_)
    return;
  fmt::print(stderr, "\r\033[K");
  std::fflush(stderr);
}

void Progress::show(const char* stage, int number, int done) {
  if (form_ == Form::none)
    return;
  const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - start_;
  const double left = spent.count() / done * (frames_ - done);
  done_ = done;
  if (heartbeat_)
    heartbeat_->beat();
  if (form_ == Form::terminal) {
    show_on_terminal(stage, done, left);
  } else if (form_ == Form::json) {
    const nlohmann::ordered_json line{{"frame", number},
                                      {"finished", done},
                                      {"of", frames_},
                                      {"time", number / frames_per_second_},
                                      {"particles", particles_.load()},
                                      {"seconds", spent.count()},
                                      {"seconds_left", left}};
    fmt::print(stderr, "{}\n", line.dump());
  } else if (pace_.is_due(static_cast<double>(done) / frames_)) {
    fmt::print(stderr, "{}: {} frame {} of {}, {} particles, {} left\n", scene_, stage, done,
               frames_, particles_.load(), duration_text(left));
  }
}

/// Says that a frame is still at work, in the log of a run whose frames take long.
void Progress::show_in_log() {
  const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - start_;
  fmt::print(stderr, "{}: at work on frame {} of {}, {} so far\n", scene_,
             std::min(done_ + 1, frames_), frames_, duration_text(spent.count()));
}

void Progress::show_on_terminal(const char* stage, int done, double seconds_left) {
  using std::chrono::steady_clock;
  const auto now = steady_clock::now();
  if (done < frames_ && now - last_shown_ < std::chrono::milliseconds(100))
    return;
  last_shown_ = now;
  fmt::print(stderr, "\r\033[K{}  {}  frame {}/{}  {} particles  {} left", scene_, stage, done,
             frames_, particles_.load(), duration_text(seconds_left));
  std::fflush(stderr);
  drawn_ = true;
}

}  // namespace spindrift::app
