#pragma once

namespace halfspace::cli {

/// Records termination signals (SIGINT, SIGTERM, SIGHUP and others) instead of ending the process, so that
/// work ends where its files are complete. Signals that the caller ignores, as under nohup, stay ignored.
/// SIGPIPE is ignored.
void remember_interrupts();

/// True once such a signal has arrived.
bool interrupt_requested();

}  // namespace halfspace::cli
