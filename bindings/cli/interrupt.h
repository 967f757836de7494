#pragma once

namespace halfspace::cli {

/// Signals that ask for the end, of a user, a terminal that closes or a batch system, are remembered instead
/// of obeyed, so that work ends where its files are whole. Those that the caller has switched off, as nohup
/// does, stay so. A reader of the output that goes away ends nothing.
void remember_interrupts();

/// Has such a signal come?
bool interrupt_asked();

}  // namespace halfspace::cli
