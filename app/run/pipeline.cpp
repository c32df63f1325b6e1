#include "app/run/pipeline.hpp"

#include <fmt/format.h>
#include <omp.h>

#include <algorithm>
#include <chrono>
#include <exception>
#include <filesystem>
#include <thread>
#include <utility>

#include "app/draw/scene_drawing.hpp"
#include "app/run/particle_source.hpp"
#include "app/run/progress.hpp"
#include "app/run/run_folder.hpp"
#include "app/system/bounded_queue.hpp"
#include "app/system/interrupt.hpp"
#include "app/system/threads.hpp"
#include "render/output/atomic_file.hpp"
#include "render/output/output.hpp"
#include "sim/run/sight.hpp"

namespace spindrift::app {
namespace {

namespace fs = std::filesystem;

/// The number of pictures that may wait to be written.
constexpr std::size_t queue_capacity = 2;
/// The number of frames of particles that may wait to be kept, and as many again to be drawn.
constexpr std::size_t particles_capacity = 1;

struct NumberedFrame {
  int number = 0;
  ComingFrame frame;
};

struct NumberedParticles {
  int number = 0;
  sim::Frame frame;
};

struct NumberedImage {
  int number = 0;
  Image image;
};

/// Adds the wall-clock time, s, for which the object lives to a stage's sum.
class StageTimer {
 public:
  explicit StageTimer(double& sum) : sum_(sum) {}
  ~StageTimer() {
    sum_ += std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
  }
  StageTimer(const StageTimer&) = delete;
  StageTimer& operator=(const StageTimer&) = delete;

 private:
  double& sum_;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

/// Writes the files of a frame in all export formats that the options ask for.
void export_frame(const RenderOptions& options, int number, const ExportedFrame& frame) {
  for (const ExportFormat* format : options.exports)
    format->write(
        options.output / format->folder / fmt::format("{:04}{}", number, format->extension), frame);
}

/// Makes meshes and pictures of particles. It must live in the drawing thread, to which its GL
/// context belongs.
class DrawingStage {
 public:
  DrawingStage(const Scene& scene, const RenderOptions& options, RunRecord& record)
      : scene_(scene),
        options_(options),
        meshing_(record.stage_seconds["mesh"]),
        drawing_(record.stage_seconds["draw"]),
        writing_(record.stage_seconds["export"]),
        scene_drawing_(scene, sim::choose_backend(scene.simulation).cuda_device) {
    record.gl_renderer = scene_drawing_.info().renderer;
    record.gl_version = scene_drawing_.info().version;
    record.egl_device = scene_drawing_.info().egl_device;
  }

  Image draw(const NumberedParticles& particles) {
    Mesh surface;
    if (scene_drawing_.shows_surface() || any_of_surface(options_.exports)) {
      const StageTimer timer(meshing_);
      surface = scene_drawing_.surface_of(particles.frame);
    }
    if (!options_.exports.empty()) {
      const StageTimer timer(writing_);
      export_frame(options_, particles.number, {scene_, particles.frame, surface});
    }
    const StageTimer timer(drawing_);
    return scene_drawing_.draw(particles.frame, surface);
  }

 private:
  const Scene& scene_;
  const RenderOptions& options_;
  double &meshing_, &drawing_, &writing_;
  SceneDrawing scene_drawing_;
};

/// Writes pictures as PNG files and into the video.
class WritingStage {
 public:
  WritingStage(const Scene& scene, const RenderOptions& options, RunRecord& record)
      : scene_(scene),
        options_(options),
        record_(record),
        png_(record.stage_seconds["write PNG"]),
        video_(record.stage_seconds["write MP4"]),
        part_(output::part_name(options.output / "video.mp4")),
        writer_(part_, output::VideoSettings{.width = scene.video.width,
                                             .height = scene.video.height,
                                             .frames_per_second = scene.video.frames_per_second,
                                             .quality = scene.video.quality}) {}

  /// Closes the video where an error came before finish(), so that its frames can be played.
  ~WritingStage() {
    try {
      finish();
    } catch (const std::exception&) {
      // The error that came before is the one that is reported.
    }
  }
  WritingStage(const WritingStage&) = delete;
  WritingStage& operator=(const WritingStage&) = delete;

  void write(const NumberedImage& numbered) {
    {
      const StageTimer timer(png_);
      output::write_png(options_.output / "frames" / fmt::format("{:04}.png", numbered.number),
                        numbered.image);
    }
    const StageTimer timer(video_);
    writer_.add(numbered.image);
    ++count_;
  }

  /// Closes the video and gives it its name, unless a longer video has that name already.
  void finish() {
    const int count = std::exchange(count_, 0);
    if (count == 0)
      return;
    const StageTimer timer(video_);
    writer_.finish();
    const fs::path name =
        options_.output / video_name(options_, record_.first_frame, count, scene_.video);
    if (fs::exists(name) && output::video_length(name) > count)
      fs::remove(part_);
    else
      output::give_name(part_, name);
    record_.video = name;
  }

 private:
  const Scene& scene_;
  const RenderOptions& options_;
  RunRecord& record_;
  double &png_, &video_;
  int count_ = 0;  ///< number of frames in the unfinished video
  fs::path part_;  ///< name of the video until it is finished
  output::VideoWriter writer_;
};

/// The threads of a run, and the queues and figures that they share.
class Pipeline {
 public:
  Pipeline(const Scene& scene, const RenderOptions& options, RunRecord& record)
      : scene_(scene), options_(options), record_(record) {
    // All stages are entered before the threads start, since the map must not grow under them.
    for (const char* stage :
         {"simulate", "keep", "mesh", "draw", "export", "write PNG", "write MP4"})
      record_.stage_seconds[stage] = 0;
  }

  void run(const FrameRange& range) {
    ParticleSource source(scene_, options_, record_.probe_readings);
    Progress progress(scene_, options_, range.last - range.first + 1, source.particle_count());
    guarded([&] {
      for (const ExportFormat* format : options_.exports)
        output::make_folders(options_.output / format->folder);
      if (!options_.simulate_only) {
        make_folders();
        drawing_ = started_thread([&] { guarded([&] { draw_all(); }); });
        writing_ = started_thread([&] { guarded([&] { write_all(progress); }); });
      }
      keeping_ = started_thread([&] { guarded([&] { keep_all(source, range, progress); }); });
      simulate(source, range, progress);
    });
    coming_.close();
    join(keeping_);
    particles_.close();
    join(drawing_);
    images_.close();
    join(writing_);
    source.finish(record_);
    if (failure_)
      std::rethrow_exception(failure_);
    // Ctrl-C may come when all frames are simulated and some of them wait to be drawn.
    record_.interrupted = record_.frames_finished < record_.frames_wanted;
  }

 private:
  /// Runs a stage; the first failure of any stage ends them all.
  template <class F>
  void guarded(F stage) {
    try {
      stage();
    } catch (...) {
      const std::lock_guard lock(failure_mutex_);
      if (!failure_)
        failure_ = std::current_exception();
      coming_.close();
      particles_.close();
      images_.close();
    }
  }

  static void join(std::thread& thread) {
    if (thread.joinable())
      thread.join();
  }

  void simulate(ParticleSource& source, const FrameRange& range, Progress& progress) {
    for (int number = 0; number <= range.last; ++number) {
      std::optional<ComingFrame> coming = timed_next(source, number);
      if (!coming)
        return;
      record_.frames.push_back(coming->statistics);
      record_.times.push_back(coming->time);
      progress.set_particles(coming->particle_count);
      if (!coming_.push({number, std::move(*coming)}))
        return;
    }
  }

  /// Writes frames to the cache and passes them on; after Ctrl-C too, so that no simulated frame is
  /// lost.
  void keep_all(const ParticleSource& source, const FrameRange& range, Progress& progress) {
    while (auto coming = coming_.pop()) {
      const int number = coming->number;
      CachedFrame cached = timed_keep(source, std::move(*coming));
      if (number < range.first)
        continue;
      cached.frame = sim::in_sight(scene_.simulation, std::move(cached.frame));
      if (options_.simulate_only) {
        export_frame(options_, number, {scene_, cached.frame, {}});
        progress.show("simulating", number, ++record_.frames_finished);
      } else {
        particles_.push({number, std::move(cached.frame)});
      }
    }
  }

  CachedFrame timed_keep(const ParticleSource& source, NumberedFrame coming) {
    const StageTimer timer(record_.stage_seconds["keep"]);
    return source.keep(coming.number, std::move(coming.frame));
  }

  std::optional<ComingFrame> timed_next(ParticleSource& source, int number) {
    const StageTimer timer(record_.stage_seconds["simulate"]);
    return source.next(number);
  }

  void draw_all() {
    if (options_.threads > 0)
      omp_set_num_threads(options_.threads);  // the number holds for the loops of one thread
    DrawingStage stage(scene_, options_, record_);
    while (auto particles = particles_.pop()) {
      if (InterruptGuard::requested())
        break;
      if (!images_.push({particles->number, stage.draw(*particles)}))
        break;
    }
    particles_.close();
    images_.close();
  }

  void write_all(Progress& progress) {
    WritingStage stage(scene_, options_, record_);
    while (auto image = images_.pop()) {
      stage.write(*image);
      progress.show("rendering", image->number, ++record_.frames_finished);
    }
    stage.finish();
  }

  void make_folders() {
    output::require_replaceable(options_.output / video_name(options_, record_.first_frame,
                                                             record_.frames_wanted, scene_.video));
    output::make_folders(options_.output / "frames");
  }

  const Scene& scene_;
  const RenderOptions& options_;
  RunRecord& record_;
  BoundedQueue<NumberedFrame> coming_{particles_capacity};
  BoundedQueue<NumberedParticles> particles_{particles_capacity};
  BoundedQueue<NumberedImage> images_{queue_capacity};
  std::thread drawing_, writing_, keeping_;
  std::exception_ptr failure_;
  std::mutex failure_mutex_;
};

}  // namespace

void run_pipeline(const Scene& scene, const RenderOptions& options, RunRecord& record) {
  if (options.threads > 0)
    omp_set_num_threads(options.threads);
  const InterruptGuard interrupt;
  const FrameRange range = options.frames.value_or(FrameRange{0, scene.video.frame_count() - 1});
  record.first_frame = range.first;
  record.frames_wanted = range.last - range.first + 1;
  StageTimer timer(record.wall_seconds);
  Pipeline(scene, options, record).run(range);
}

}  // namespace spindrift::app
