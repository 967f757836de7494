#pragma once

namespace halfspace::cli {

/// Records termination signals (SIGINT, SIGTERM, SIGHUP and others) instead of ending the process, so that
/// work ends where its files are complete. Signals that the caller ignores, as under nohup, stay ignored.
/// SIGPIPE is ignored.
void remember_interrupts();

/// Ends the work of the calling thread as a signal would; false before the next work.
void interrupt_this_thread(bool is_interrupted);

/// True once such a signal has arrived, or the calling thread is interrupted.
bool interrupt_requested();

}  // namespace halfspace::cli
