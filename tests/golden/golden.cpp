// Prints one line for each scene: the hash of all that its run shows, and its name. The same lines must come
// from every compiler, optimization level and machine.

#include <cinttypes>
#include <cstdio>
#include <exception>

#include "golden/stage.h"

int main() {
  using namespace halfspace_test;
  for (const auto& scenes : {scenes_in_plane(), scenes_in_space(), scenes_of_meshes(), scenes_of_pairs()}) {
    for (const Scene& scene : scenes) {
      try {
        std::printf("%016" PRIx64 "  %s\n", scene.hash(), scene.name.c_str());
      } catch (const std::exception& error) {
        std::fprintf(stderr, "%s: %s\n", scene.name.c_str(), error.what());
        return 1;
      }
    }
  }
}
