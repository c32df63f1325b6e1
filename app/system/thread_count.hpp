// How many threads a command uses.
#pragma once

namespace spindrift::app {

/// As many as asked for, or, where that is 0, as OpenMP would take: the processors', or what
/// OMP_NUM_THREADS says. More than there are processors are warned of on stderr.
/// @throws InputError for so many that they would hold each other up
int thread_count(int asked_for, bool quiet);

}  // namespace spindrift::app
