// Tasks that share a machine: their order, their memory, and what a failure takes with it.
#include <algorithm>
#include <atomic>
#include <catch2/catch.hpp>
#include <chrono>
#include <mutex>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "app/system/task_pool.hpp"

namespace app_task_pool_tests {

using namespace spindrift::app;
using Catch::Matchers::Contains;

namespace {

const std::atomic<bool> never{false};

}  // namespace

TEST_CASE("tasks run after those that they need, and never need more memory than there is") {
  std::mutex mutex;
  std::uint64_t bytes = 0, most = 0;
  int running = 0, most_running = 0;
  std::vector<int> order;
  std::vector<Task> tasks;
  for (int k = 0; k < 12; ++k) {
    const std::uint64_t need = 10 + 10 * (k % 3);
    const auto run = [&, k, need] {
      {
        const std::lock_guard lock(mutex);
        most = std::max(most, bytes += need);
        most_running = std::max(most_running, ++running);
        order.push_back(k);
      }
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
      const std::lock_guard lock(mutex);
      bytes -= need;
      --running;
      return std::string();
    };
    tasks.push_back({.label = "", .run = run, .bytes = need});
  }
  tasks[4].after = {3};
  tasks[11].after = {4, 10};
  const auto results =
      run_tasks(tasks, {.at_once = 4, .bytes = 50}, never, [](const PoolStatus&) {});
  CHECK(std::all_of(results.begin(), results.end(), [](const TaskResult& r) { return r.done; }));
  CHECK(order.size() == 12);
  CHECK(most <= 50);
  CHECK(most_running > 1);
  CHECK(most_running <= 4);
  const auto place = [&](int k) { return std::find(order.begin(), order.end(), k); };
  CHECK(place(3) < place(4));
  CHECK(place(4) < place(11));
}

TEST_CASE("a task that fails takes those that need it with it, and no others") {
  const auto good = [] { return std::string(); };
  int begun = 0;
  const std::vector<Task> tasks{
      {.label = "", .run = good},
      {.label = "", .run = [] { return std::string("no"); }},
      {.label = "", .run = [&] { return ++begun, std::string(); }, .after = {1}},
      {.label = "", .run = [&] { return ++begun, std::string(); }, .after = {2}},
      {.label = "", .run = []() -> std::string { throw std::runtime_error("thrown"); }},
      {.label = "", .run = good, .bytes = 2'000'000'000},
      {.label = "", .run = good, .after = {0}}};
  for (const int at_once : {1, 3}) {
    const auto results = run_tasks(tasks, {.at_once = at_once, .bytes = 1'000'000'000}, never,
                                   [](const PoolStatus&) {});
    CHECK(results[0].done);
    CHECK(results[1].failure == "no");
    CHECK(results[2].failure == "no");
    CHECK(results[3].failure == "no");
    CHECK(begun == 0);
    CHECK(results[4].failure == "thrown");
    CHECK_THAT(results[5].failure, Contains("needs about 2.0 GB of memory, 1.0 GB are free"));
    CHECK(results[6].done);
  }
}

}  // namespace app_task_pool_tests
