#include "app/threads.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <latch>
#include <stdexcept>
#include <system_error>
#include <vector>

namespace spindrift::app {
namespace {

constexpr const char* advice =
    "more than the system lets this process have (ulimit -u, ulimit -v for their stacks, or a "
    "container's limit); "
    "raise that, or ask for fewer with --threads";

}  // namespace

std::thread started_thread(std::function<void()> f) {
  try {
    return std::thread(std::move(f));
  } catch (const std::system_error& error) {
    throw std::runtime_error(
        fmt::format("no thread could be started ({}): one is {}", error.code().message(), advice));
  }
}

void require_threads(int count) {
  std::latch all_begun(1);
  std::vector<std::thread> threads;
  std::error_code failure;
  threads.reserve(static_cast<std::size_t>(count));
  try {
    while (static_cast<int>(threads.size()) < count)
      threads.emplace_back([&] { all_begun.wait(); });
  } catch (const std::system_error& error) {
    failure = error.code();
  }
  all_begun.count_down();
  for (std::thread& thread : threads)
    thread.join();
  if (failure)
    throw std::runtime_error(
        fmt::format("{} threads are needed and {} could be started ({}): that is {}", count,
                    threads.size(), failure.message(), advice));
}

int threads_of_run(int threads) {
  constexpr int of_stages = 3, of_encoder = 6;
  const int of_renderer = std::min(16u, std::max(1u, std::thread::hardware_concurrency()));
  return 2 * (threads - 1) + of_stages + of_encoder + of_renderer;
}

}  // namespace spindrift::app
