#include "settle.h"

#include <algorithm>

#include "interrupt.h"

namespace halfspace::cli {

bool settle(const SceneStage& stage, Model& model, hs_balance& balance) {
  constexpr std::int64_t steps_of_piece = 20000;  // between two looks at interrupts
  std::int64_t steps = 0, portion = 0;
  const std::int64_t most_steps = stage.relaxation.most_steps;
  bool is_balanced = false;
  while (!(is_balanced && model.is_changed()) && steps < most_steps && !interrupt_asked()) {
    if ((is_balanced || portion == 0) && !model.is_changed())
      model.change_to(static_cast<double>(++portion) / static_cast<double>(stage.portions));
    hs_relaxation_def piece = stage.relaxation;
    piece.most_steps = std::min(steps_of_piece, most_steps - steps);
    is_balanced = model.settle(piece, balance);
    steps += balance.steps;
  }
  balance.steps = steps;
  return is_balanced && model.is_changed();
}

}  // namespace halfspace::cli
