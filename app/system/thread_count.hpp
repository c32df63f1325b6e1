// Decides how many threads a command uses.
#pragma once

namespace spindrift::app {

/// The number of threads asked for or, where that is 0, the number that OpenMP would take: that of
/// the processors, or OMP_NUM_THREADS. A number above that of the processors gives a warning on
/// stderr, unless `quiet`.
/// @throws InputError for so many threads, over 16 per processor or 1024, that they would hold each
/// other up
int thread_count(int asked_for, bool quiet);

}  // namespace spindrift::app
