// Threads, where the system may have no more of them.
#pragma once

#include <functional>
#include <thread>

namespace spindrift::app {

/// A thread that runs f. @throws std::runtime_error that says how to get more, where the system
/// lets this process have no more threads
std::thread started_thread(std::function<void()> f);

/// Makes sure that so many threads can run beside this one, since the libraries that start them end
/// the process where they can't. @throws std::runtime_error as started_thread, with the number
void require_threads(int count);

/// Threads that a command starts whose loops are shared by so many, at most: simulating and drawing
/// share their loops apart, and the encoder and Mesa's software renderer have their own.
int threads_of_run(int threads);

}  // namespace spindrift::app
