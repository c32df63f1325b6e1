#include "app/system/threads.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <latch>
#include <stdexcept>
#include <system_error>
#include <vector>

#include "render/shortage.hpp"

namespace spindrift::app {
namespace {

/// Why no more threads can be started. It must be called while the started threads still run.
std::string why_no_more(const std::system_error& error) {
  constexpr std::size_t stack_bytes = std::size_t{8} << 20;  // the default size of a thread's stack
  return shortage(stack_bytes).value_or(error.code().message());
}

}  // namespace

std::thread started_thread(std::function<void()> f) {
  try {
    return std::thread(std::move(f));
  } catch (const std::system_error& error) {
    throw std::runtime_error(fmt::format("no thread could be started: {}", why_no_more(error)));
  }
}

void require_threads(int count) {
  std::latch all_begun(1);
  std::vector<std::thread> threads;
  std::string failure;
  threads.reserve(static_cast<std::size_t>(count));
  try {
    while (static_cast<int>(threads.size()) < count)
      threads.emplace_back([&] { all_begun.wait(); });
  } catch (const std::system_error& error) {
    failure = why_no_more(error);
  }
  all_begun.count_down();
  for (std::thread& thread : threads)
    thread.join();
  if (!failure.empty())
    throw std::runtime_error(fmt::format(
        "{} threads are needed and {} could be started: {}; ask for fewer with --threads", count,
        threads.size(), failure));
}

int threads_of_run(int threads) {
  constexpr int of_stages = 3, of_encoder = 6;
  const int of_renderer = std::min(16u, std::max(1u, std::thread::hardware_concurrency()));
  return 2 * (threads - 1) + of_stages + of_encoder + of_renderer;
}

}  // namespace spindrift::app
