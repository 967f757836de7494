#include "studies/sweep/children.h"

#include <sys/types.h>
#include <sys/wait.h>
#ifdef __linux__
#include <sys/prctl.h>
#endif
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <exception>
#include <stdexcept>
#include <string>
#include <system_error>
#include <thread>

#include "common/interrupt.h"

namespace halfspace::cli {
namespace {

using Clock = std::chrono::steady_clock;

struct Child {
  pid_t process = 0;
  std::size_t number = 0;
  Clock::time_point start = Clock::now();
};

/// Never returns.
[[noreturn]] void work_as_child(const Job& job) {
#ifdef __linux__
  prctl(PR_SET_PDEATHSIG, SIGTERM);  // no run goes on without the sweep
#endif
  int status = 1;
  if (std::freopen(job.log.c_str(), "w", stdout) && dup2(STDOUT_FILENO, STDERR_FILENO) >= 0) {
    try {
      status = job.work();
    } catch (const std::exception& error) {
      std::fprintf(stderr, "halfspace: %s\n", error.what());
    }
  }
  std::fflush(nullptr);
  _exit(status);
}

Child begin(const Job& job) {
  std::error_code error;
  std::filesystem::create_directories(job.log.parent_path(), error);
  std::fflush(nullptr);  // what is not written yet would be written twice
  const pid_t process = fork();
  if (process < 0) throw std::runtime_error(std::string("cannot start a run: ") + std::strerror(errno));
  if (process == 0) work_as_child(job);
  return {.process = process, .number = job.number};
}

int code_of(int status) { return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status); }

}  // namespace

void run_in_children(const std::vector<Job>& jobs, std::size_t at_once,
                     const std::function<void(const JobEnd&)>& ended,
                     const std::function<void(std::size_t running)>& wait) {
  std::vector<Child> children;
  auto next = jobs.begin();
  bool is_interrupted = false;
  while (next != jobs.end() || !children.empty()) {
    if (!is_interrupted && interrupt_requested()) {
      is_interrupted = true;
      next = jobs.end();
      for (const Child& child : children) kill(child.process, SIGINT);
    }
    while (next != jobs.end() && children.size() < at_once) children.push_back(begin(*next++));
    std::erase_if(children, [&](const Child& child) {
      int status = 0;
      if (waitpid(child.process, &status, WNOHANG) != child.process) return false;
      ended(
          {child.number, code_of(status), std::chrono::duration<double>(Clock::now() - child.start).count()});
      return true;
    });
    wait(children.size());
    if (!children.empty()) std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
}

}  // namespace halfspace::cli
