#include "settle.h"

#include <algorithm>

#include "interrupt.h"

namespace halfspace::cli {

hs_balance settle_on(const SceneStage& stage, Model& model, Settling& settling) {
  constexpr std::int64_t steps_of_piece = 20000;
  if ((settling.is_balanced || settling.portions == 0) && !model.is_changed())
    model.change_to(static_cast<double>(++settling.portions) / static_cast<double>(stage.portions));
  hs_relaxation_def piece = stage.relaxation;
  piece.most_steps = std::min(steps_of_piece, stage.relaxation.most_steps - settling.steps);
  hs_balance balance{};
  settling.is_balanced = model.settle(piece, balance);
  settling.steps += balance.steps;
  return balance;
}

bool settle(const SceneStage& stage, Model& model, hs_balance& balance) {
  Settling settling;
  while (!settling.is_over(stage, model) && !interrupt_asked()) balance = settle_on(stage, model, settling);
  balance.steps = settling.steps;
  return settling.is_at_rest(model);
}

}  // namespace halfspace::cli
