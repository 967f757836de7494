// YADE runs in its own Python: yade_server.py there answers requests, a line each.

#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cmath>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <sstream>
#include <stdexcept>

#include "engine.h"

namespace halfspace_trade {
namespace {

/// The other process, and a pipe to and from it.
class Server {
 public:
  Server() {
    int to[2], from[2];
    if (pipe(to) != 0 || pipe(from) != 0) throw std::runtime_error("no pipe");
    child_ = fork();
    if (child_ == 0) {
      prctl(PR_SET_PDEATHSIG, SIGKILL);  // it may be in the middle of long steps
      setenv("TRADE_REQUESTS", std::to_string(to[0]).c_str(), 1);
      setenv("TRADE_ANSWERS", std::to_string(from[1]).c_str(), 1);
      close(to[1]);
      close(from[0]);
      for (std::FILE* chatter : {stdout, stderr})
        if (!std::freopen("/dev/null", "w", chatter)) std::abort();
      execlp("yade", "yade", "-n", "-x", TRADE_SOURCES "/yade_server.py", static_cast<char*>(nullptr));
      std::abort();
    }
    close(to[0]);
    close(from[1]);
    requests_ = fdopen(to[1], "w");
    answers_ = fdopen(from[0], "r");
  }
  ~Server() {
    std::fclose(requests_);
    std::fclose(answers_);
    waitpid(child_, nullptr, 0);
  }

  std::istringstream ask(const std::string& request) {
    std::fprintf(requests_, "%s\n", request.c_str());
    std::fflush(requests_);
    char line[1024];
    if (!std::fgets(line, sizeof line, answers_))
      throw std::runtime_error("YADE does not answer: " + request);
    return std::istringstream(line);
  }

 private:
  pid_t child_;
  std::FILE* requests_;
  std::FILE* answers_;
};

Server& server() {
  static Server one;
  return one;
}

template <class Numbers>
void add(std::ostringstream& request, const Numbers& numbers) {
  for (const double x : numbers) request << ' ' << x;
}

class YadeWorld : public World {
 public:
  YadeWorld(const Scene& scene, const Setting& setting) {
    const Body& body = typical_body(scene);
    const double mass = mass_of(body, 3).mass;
    const double stiffness = face_stiffness(scene, setting.indentation);
    time_step_ = whole_part(scene.duration, setting.step * 2 * std::sqrt(mass / stiffness));
    std::ostringstream request;
    request.precision(17);
    request << "world " << stiffness / (body.size[0] * body.size[1]) << ' ' << std::atan(scene.friction)
            << ' ' << density << ' ' << (scene.seeks_rest ? 0.2 : 0) << ' ' << time_step_;
    add(request, scene.gravity);
    server().ask(request.str());
    for (const Body& b : scene.bodies) add_body(b);
  }

  double step(long steps) override {
    double seconds = 0;
    server().ask("step " + std::to_string(steps)) >> seconds;
    return seconds;
  }
  double time_step() const override { return time_step_; }

  State state(std::size_t body) const override {
    std::istringstream answer = server().ask("state " + std::to_string(body));
    State state;
    for (double& x : state.position) answer >> x;
    for (double& x : state.rotation) answer >> x;
    for (double& x : state.velocity) answer >> x;
    for (double& x : state.spin) answer >> x;
    return state;
  }

 private:
  static void add_body(const Body& body) {
    std::ostringstream request;
    request.precision(17);
    request << "body " << body.is_fixed;
    for (const auto* v : {&body.size, &body.position, &body.velocity, &body.spin}) add(request, *v);
    add(request, body.rotation);
    server().ask(request.str());
  }

  double time_step_ = 0;
};

}  // namespace

const char* engine_name() { return "YADE"; }
bool knows_dimension(int dimension) { return dimension == 3; }
bool knows_hulls() { return false; }

std::vector<Setting> settings() {
  std::vector<Setting> all;
  for (const double indentation : {1e-2, 1e-3, 1e-4}) all.push_back({"volume", indentation, 0.1});
  return all;
}

std::unique_ptr<World> build(const Scene& scene, const Setting& setting) {
  return std::make_unique<YadeWorld>(scene, setting);
}

}  // namespace halfspace_trade
