#pragma once

#include <cstdint>
#include <optional>
#include <tuple>

#include "block/blocks.h"

namespace halfspace {

/// A bolt: a line between two places that blocks carry, or between a block and a place that stays. It
/// transmits an axial force, linear in its elongation up to the yield force, until it ruptures. Without
/// implicit padding.
template <int D>
struct Bolt {
  std::int64_t number = 0;  // of all bolts added so far, in ascending order
  std::int32_t a = -1;      // slots; -1: the place stays
  std::int32_t b = -1;
  std::int32_t is_tension_only = 1;
  std::int32_t is_ruptured = 0;
  double stiffness = 0;                // N/m
  Vector<D> on_a = Vector<D>::Zero();  // in the frame of the shape, or where it stays
  Vector<D> on_b = Vector<D>::Zero();
  double unstressed_length = 0;   // before it has yielded
  double yield_force = 0;         // 0: it does not yield
  double rupture_elongation = 0;  // from the unstressed length; 0: it does not rupture
  double plastic_elongation = 0;
  double elongation = 0;  // from the unstressed length, at the last evaluation
  double tension = 0;     // likewise
  double dissipated = 0;  // by yield and rupture, J
  double reserved = 0;

  double strain_energy() const { return 0.5 * tension / stiffness * tension; }
};

static_assert(sizeof(Bolt<2>) == 128 && sizeof(Bolt<3>) == 144, "snapshots have no implicit padding");

/// The bolts of a world, in the order in which they were added.
template <int D>
class Bolts {
 public:
  explicit Bolts(Memory* memory) : bolts_(memory) {}

  bool empty() const { return bolts_.empty(); }
  Array<Bolt<D>>& all() { return bolts_; }
  const Array<Bolt<D>>& all() const { return bolts_; }
  /// Sets the number of a bolt and adds it.
  std::int64_t add(const Bolt<D>& bolt);
  /// The index of a bolt, if it has not been removed.
  std::optional<std::size_t> index_of(std::int64_t number) const;
  void remove(std::size_t index) { bolts_.erase(bolts_.begin() + std::ptrdiff_t(index)); }
  /// Removes the bolts of a block.
  void forget(std::int32_t block) {
    std::erase_if(bolts_, [=](const Bolt<D>& bolt) { return bolt.a == block || bolt.b == block; });
  }

  /// State that the evaluation of forces changes.
  auto state() { return std::tie(bolts_); }

  bool is_consistent(const Blocks<D>& blocks) const;

  template <class Archive>
  void visit(Archive& archive) {
    archive(bolts_, next_number_);
  }

 private:
  Array<Bolt<D>> bolts_;
  std::int64_t next_number_ = 0;
};

/// The ends of a bolt at present.
template <int D>
struct BoltEnds {
  BoltEnds(const Blocks<D>& blocks, const Bolt<D>& bolt)
      : arm_a(arm_of(blocks, bolt.a, bolt.on_a)),
        arm_b(arm_of(blocks, bolt.b, bolt.on_b)),
        a(centroid_of(blocks, bolt.a) + arm_a),
        b(centroid_of(blocks, bolt.b) + arm_b) {}

  Vector<D> arm_a;  // from the centroid; from the origin where it stays
  Vector<D> arm_b;
  Vector<D> a;
  Vector<D> b;

 private:
  static Vector<D> centroid_of(const Blocks<D>& blocks, std::int32_t slot) {
    return slot < 0 ? Vector<D>(Vector<D>::Zero()) : blocks.position[std::size_t(slot)];
  }
  static Vector<D> arm_of(const Blocks<D>& blocks, std::int32_t slot, const Vector<D>& place) {
    return slot < 0 ? place : blocks.arm_to(std::size_t(slot), place);
  }
};

/// The state of a bolt at an elongation: updates tension, plastic elongation, rupture and loss. Held bolts
/// neither yield nor rupture.
template <int D>
void stretch(Bolt<D>& bolt, double elongation, bool are_held);

/// A bound of the stiffness of a bolt against motions of its ends.
template <int D>
double stiffness_of(const Blocks<D>& blocks, const Bolt<D>& bolt);

extern template class Bolts<2>;
extern template class Bolts<3>;

}  // namespace halfspace
