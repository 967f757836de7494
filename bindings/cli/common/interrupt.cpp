#include "common/interrupt.h"

#include <csignal>
#include <initializer_list>

namespace halfspace::cli {
namespace {

volatile std::sig_atomic_t requested = 0;
void request(int) { requested = 1; }

thread_local bool is_thread_interrupted = false;

}  // namespace

void remember_interrupts() {
  for (int signal : {SIGINT, SIGTERM, SIGHUP, SIGQUIT, SIGXCPU, SIGALRM, SIGUSR1, SIGUSR2}) {
    if (std::signal(signal, request) == SIG_IGN) std::signal(signal, SIG_IGN);
  }
  std::signal(SIGPIPE, SIG_IGN);
}

void interrupt_this_thread(bool is_interrupted) { is_thread_interrupted = is_interrupted; }

bool interrupt_requested() { return requested != 0 || is_thread_interrupted; }

}  // namespace halfspace::cli
