// Starts threads, and explains in words when the system allows no more of them.
#pragma once

#include <functional>
#include <thread>

namespace spindrift::app {

/// Starts a thread that runs f.
/// @throws std::runtime_error that says why the system lets this process have no more threads
std::thread started_thread(std::function<void()> f);

/// Makes sure that `count` threads can run beside this one. Libraries that start threads would
/// otherwise end the process where they can't.
/// @throws std::runtime_error with the reason and the number of threads that could be started
void require_threads(int count);

/// The most threads that a command starts whose loops are shared by `threads` threads. Simulating
/// and drawing each have threads for their loops, and the encoder and Mesa's software renderer have
/// their own.
int threads_of_run(int threads);

}  // namespace spindrift::app
