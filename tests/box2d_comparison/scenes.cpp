#include "scenes.h"

namespace box2d_comparison {

std::vector<Scene> all_scenes() {
  std::vector<Scene> all;
  for (const auto& some : {stacks(), moving(), slopes(), fine_shapes(), far_and_near()})
    all.insert(all.end(), some.begin(), some.end());
  return all;
}

}  // namespace box2d_comparison
