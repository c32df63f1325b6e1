#include "app/system/thread_count.hpp"

#include <fmt/format.h>
#include <omp.h>

#include <algorithm>

#include "app/errors/error_report.hpp"
#include "app/errors/errors.hpp"

namespace spindrift::app {
namespace {

constexpr int most_per_processor = 16, most_threads = 1024;

}  // namespace

int thread_count(int asked_for, bool quiet) {
  const int threads = asked_for > 0 ? asked_for : omp_get_max_threads();
  const int processors = omp_get_num_procs();
  const int most = std::min(most_per_processor * processors, most_threads);
  const char* const said_by = asked_for > 0 ? "--threads" : "OMP_NUM_THREADS";
  const std::string here =
      fmt::format("{} processor{} can be used here", processors, processors == 1 ? "" : "s");
  if (threads > most)
    throw InputError(fmt::format("{} {}: {}; accepted: 1 ... {}, and {} is fastest", said_by,
                                 threads, here, most, processors));
  if (threads > processors && !quiet)
    tell_warning(
        fmt::format("{} {}: {}; more threads than that are slower", said_by, threads, here));
  return threads;
}

}  // namespace spindrift::app
