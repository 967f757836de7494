#include <algorithm>
#include <cmath>

#include "block/free_turn.h"
#include "world/motion/integrator.h"

// The predicted motion: half a kick and a drift, before anything moves.

namespace halfspace {

template <int D>
bool Integrator<D>::predict(double duration) {
  duration_ = duration;
  const std::size_t slots = blocks_.slot_count();
  next_rotation_.resize(slots);
  samples_.reserve(chunk_count(slots, blocks_per_chunk));
  if (!meshes_.predict(duration)) return false;
  sum_each_block(predictions_, [&](std::size_t i, Prediction& prediction) {
    prediction.is_valid = prediction.is_valid && predict_motion_of(i, prediction);
  });
  Prediction all;
  for (const Prediction& prediction : predictions_) {
    if (!prediction.is_valid) return false;
    all.needs_rebuild |= prediction.needs_rebuild;
    all.goes_far |= prediction.goes_far;
    all.longest_motion = std::max(all.longest_motion, prediction.longest_motion);
    all.max_rotation = std::max(all.max_rotation, prediction.max_rotation);
  }
  if (!predict_parts(all)) return false;
  longest_motion_ = all.longest_motion;
  max_rotation_ = all.max_rotation;
  neighbors_.end_announcements(all.needs_rebuild);
  if (all.goes_far && kicks_.empty()) announce_displacements();  // impulses may still change the direction
  return true;
}

template <int D>
bool Integrator<D>::predict_motion_of(std::size_t i, Prediction& prediction) {
  if (blocks_.is_part(i) || share_.is_idle(i)) return true;  // parts follow their compound
  if (sleep_.is_asleep(i)) {
    next_rotation_[i] = blocks_.rotation[i];
    return predict_block(i, Vector<D>::Zero(), 0, prediction);
  }
  const double half = 0.5 * duration_;
  Vector<D> velocity = blocks_.velocity[i];
  Angular<D> spin = blocks_.spin[i];
  switch (blocks_.kind[i]) {
    case BlockKind::affine:
      return predict_affine(i, prediction);
    case BlockKind::mesh:
      return predict_block(i, meshes_.predicted_displacement(i) / duration_,
                           meshes_.predicted_stretch(i).norm(), prediction);
    case BlockKind::rigid: {
      velocity += half * acceleration_[i];
      Angular<D> momentum = blocks_.momentum[i] + half * momentum_rate_[i];
      if (!kicks_.empty()) {
        velocity += kicks_.of_block(i);
        momentum += kicks_.momentum(i);
      }
      const auto onward = turned_freely(blocks_.rotation[i], blocks_.inertia[i], momentum, duration_);
      spin = onward.spin;
      next_rotation_[i] = onward.rotation;
      break;
    }
    case BlockKind::prescribed:
      velocity += half * acceleration_[i];
      spin += half * momentum_rate_[i];
      next_rotation_[i] = blocks_.rotation[i].turned_by(duration_ * spin);
      break;
    default:
      return true;
  }
  const double turn = std::max(duration_ * spin.norm(), next_rotation_[i].farthest_from(blocks_.rotation[i]));
  return predict_block(i, velocity, turn, prediction);
}

/// Parts move with their compounds, whose motion has been predicted.
template <int D>
bool Integrator<D>::predict_parts(Prediction& prediction) {
  for (const Part<D>& part : blocks_.compounds().parts()) {
    const std::size_t p = std::size_t(part.block), c = std::size_t(part.compound);
    if (!blocks_.moves(c)) continue;
    next_rotation_[p] = next_rotation_[c] * part.pose.rotation;
    const double turn =
        std::max(predicted_turn(c).norm(), next_rotation_[c].farthest_from(blocks_.rotation[c]));
    if (!predict_block(p, predicted_displacement(p) / duration_, turn, prediction)) return false;
  }
  return true;
}

/// Announces the maximum displacement of a block. `turn`: its rotation or change of gradient. False when not
/// finite.
template <int D>
bool Integrator<D>::predict_block(std::size_t i, const Vector<D>& velocity, double turn,
                                  Prediction& prediction) {
  const double motion = duration_ * velocity.norm() + blocks_.radius[i] * turn;
  if (!std::isfinite(motion)) return false;
  if (!blocks_.is_compound(i)) prediction.needs_rebuild |= neighbors_.announce(blocks_, i, motion);
  prediction.goes_far |= motion > blocks_.radius[i];
  prediction.max_rotation = std::max(prediction.max_rotation, turn);
  prediction.longest_motion = std::max(prediction.longest_motion, motion);
  return true;
}

/// Announces the displacements of blocks that move by more than their radius.
template <int D>
void Integrator<D>::announce_displacements() {
  for (std::size_t i = 0; i < blocks_.moving_end(); ++i) {
    if (blocks_.moves(i) && !blocks_.is_compound(i) && neighbors_.announced_motion(i) > blocks_.radius[i])
      neighbors_.announce_displacement(i, predicted_displacement(i));
  }
}

template <int D>
Vector<D> Integrator<D>::predicted_displacement(std::size_t i) const {
  if (blocks_.is_of_mesh(i)) return meshes_.predicted_displacement(i);
  if (sleep_.is_asleep(i)) return Vector<D>::Zero();
  if (blocks_.is_part(i)) return predicted_displacement_of_part(i);
  Vector<D> velocity = blocks_.velocity[i];
  if (blocks_.moves(i)) velocity += 0.5 * duration_ * acceleration_[i];
  if (blocks_.moves_freely(i) && !kicks_.empty()) velocity += kicks_.of_block(i);
  return duration_ * velocity;
}
template <int D>
Vector<D> Integrator<D>::predicted_displacement_of_part(std::size_t i) const {
  const Part<D>& part = blocks_.compounds().part_of_block(i);
  const std::size_t compound = std::size_t(part.compound);
  return predicted_displacement(compound) + next_rotation_[compound] * part.pose.position - blocks_.arm_of(i);
}
template <int D>
Tensor<D> Integrator<D>::predicted_stretch(std::size_t i) const {
  if (blocks_.is_of_mesh(i)) return meshes_.predicted_stretch(i);
  if (sleep_.is_asleep(i)) return Tensor<D>::Zero();
  const Deformation<D>& deformation = blocks_.deformation(i);
  Tensor<D> rate = deformation.rate + 0.5 * duration_ * deformation.acceleration;
  if (!kicks_.empty()) rate += kicks_.of_gradient(i);
  return duration_ * rate;
}
template <int D>
Angular<D> Integrator<D>::predicted_turn(std::size_t i) const {
  return next_rotation_[i].turn_since(blocks_.rotation[i]);
}

template <int D>
Vector<D> Integrator<D>::predicted_velocity(const MaterialPoint<D>& point) const {
  const std::size_t slot = std::size_t(point.block);
  Vector<D> way = Vector<D>::Zero();
  if (blocks_.is_of_mesh(slot)) {
    way = weighed(point, [&](std::size_t node) { return predicted_displacement_of_node(node); });
  } else if (blocks_.is_affine(slot)) {
    way = predicted_displacement(slot) + predicted_stretch(slot) * point.arm;
  } else if (blocks_.moves(slot)) {
    const Vector<D> own = blocks_.rotation[slot].inverse() * point.arm;
    way = predicted_displacement(slot) + next_rotation_[slot] * own - point.arm;
  }
  return way / duration_;
}

#define HALFSPACE_MEMBERS(D)                                                                      \
  template bool Integrator<D>::predict(double);                                                   \
  template bool Integrator<D>::predict_motion_of(std::size_t, Prediction&);                       \
  template bool Integrator<D>::predict_block(std::size_t, const Vector<D>&, double, Prediction&); \
  template void Integrator<D>::announce_displacements();                                          \
  template bool Integrator<D>::predict_parts(Prediction&);                                        \
  template Vector<D> Integrator<D>::predicted_displacement_of_part(std::size_t) const;            \
  template Vector<D> Integrator<D>::predicted_displacement(std::size_t) const;                    \
  template Tensor<D> Integrator<D>::predicted_stretch(std::size_t) const;                         \
  template Angular<D> Integrator<D>::predicted_turn(std::size_t) const;                           \
  template Vector<D> Integrator<D>::predicted_velocity(const MaterialPoint<D>&) const;

HALFSPACE_MEMBERS(2)
HALFSPACE_MEMBERS(3)
#undef HALFSPACE_MEMBERS

}  // namespace halfspace
