// Makes the process report closed streams, full files and missing memory in words.
#pragma once

namespace spindrift::app {

/// Sets up signals and streams for the rest of the process. Writing where nobody reads (SIGPIPE) or
/// beyond the largest file allowed (SIGXFSZ) then fails with an error instead of ending the
/// process. Text that can't be written to stderr, for example because the terminal is gone, is
/// dropped. An error that nothing catches, such as memory running out in a loop shared by threads,
/// ends the process with a sentence on stderr and exit code run_failed.
void prepare_process();

/// Flushes standard output.
/// @return whether all that was printed has reached its reader; if not, the reason is on stderr,
/// unless the reader is gone
bool all_printed();

}  // namespace spindrift::app
