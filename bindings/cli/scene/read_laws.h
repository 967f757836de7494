#pragma once

#include <vector>

#include "scene/keys.h"
#include "scene/scene.h"

namespace halfspace::cli {

void read_default_law(Keys keys, Scene& scene);

void read_laws(std::vector<Keys> tables, Scene& scene);

/// The laws at some stage of a scene.
struct Laws {
  hs_law_def of_all{};
  std::vector<PairLaw> of_pairs;
};

/// Reads the laws that a stage changes. Missing keys keep their present values.
void read_stage_laws(Keys& keys, const Scene& scene, Laws& present, SceneStage& stage);

}  // namespace halfspace::cli
