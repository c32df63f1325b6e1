// What the process does where nobody reads, where a file may not grow, and where memory is short.
#pragma once

namespace spindrift::app {

/// From here on, writing where nobody reads (SIGPIPE) or beyond the largest file allowed (SIGXFSZ)
/// fails in words instead of ending the process; what can't be written to stderr, say since the
/// terminal is gone, is dropped; and an error that nothing catches, such as memory that is short
/// in a loop shared by threads, ends in a sentence and the exit code of a failed run.
void prepare_process();

/// Whether all that was printed has reached its reader; says on stderr where it has not, unless the
/// reader is gone.
bool all_printed();

}  // namespace spindrift::app
