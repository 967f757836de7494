#include "interrupt.h"

#include <csignal>
#include <initializer_list>

namespace halfspace::cli {
namespace {

volatile std::sig_atomic_t asked = 0;
void ask(int) { asked = 1; }

}  // namespace

void remember_interrupts() {
  for (int signal : {SIGINT, SIGTERM, SIGHUP, SIGQUIT, SIGXCPU, SIGALRM, SIGUSR1, SIGUSR2}) {
    if (std::signal(signal, ask) == SIG_IGN) std::signal(signal, SIG_IGN);
  }
  std::signal(SIGPIPE, SIG_IGN);
}

bool interrupt_asked() { return asked != 0; }

}  // namespace halfspace::cli
