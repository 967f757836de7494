#include "world/stages/water_pass.h"

#include <numeric>

namespace halfspace {

template <int D>
void WaterPass<D>::fit_room() {
  energy_.reserve(chunk_count(model_.blocks.slot_count(), ForcePass<D>::blocks_per_strip));
}

template <int D>
double WaterPass<D>::load() {
  const Blocks<D>& blocks = model_.blocks;
  const double unit_weight = model_.water.unit_weight(model_.settings.gravity);
  if (unit_weight == 0) return 0;
  sum_each_chunk(threads_, blocks.slot_count(), ForcePass<D>::blocks_per_strip, energy_,
                 [&](const Chunk& chunk, double& energy) {
                   for (std::size_t i = chunk.begin; i < chunk.end; ++i) {
                     if (!blocks.moves(i) || !share_.wets(i)) continue;
                     const WaterLoad<D> water = model_.water.load_on(blocks, i, unit_weight);
                     forces_.add_load(i, water.force, water.virial);
                     energy += water.energy;
                   }
                 });
  return std::accumulate(energy_.begin(), energy_.end(), 0.0);
}

template class WaterPass<2>;
template class WaterPass<3>;

}  // namespace halfspace
