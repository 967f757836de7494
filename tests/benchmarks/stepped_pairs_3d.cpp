#include "benchmarks/stepped_pairs_3d.h"

#include <cmath>
#include <deque>
#include <memory_resource>

#include "benchmarks/halfspace_block.h"
#include "benchmarks/timing.h"
#include "block/outlines.h"
#include "narrow_phase/pair.h"

namespace halfspace_benchmark {
namespace {

using halfspace::PairCache;
using halfspace::Rotation;
using halfspace::Vector;

Vector<3> draw_direction(Random& random) {
  const auto d = halfspace_test::random_direction(random);
  return {d.x, d.y, d.z};
}

class SteppedPair {
 public:
  SteppedPair(const HalfspaceBlock& a, const HalfspaceBlock& b, const PolyhedraAt& at, Random& random)
      : centroid_of_b_(b.centroid),
        rotation_of_a_(Rotation<3>::from_quaternion(at.at_a.rotation)),
        rotation_of_b_(Rotation<3>::from_quaternion(at.at_b.rotation)),
        path_(draw_direction(random)),
        axis_(draw_direction(random)) {
    outlines_.resize(2);
    outlines_.assign(0, outlines_.take_in(a.shape));
    outlines_.assign(1, outlines_.take_in(b.shape));
    outlines_.turn(0, rotation_of_a_);
    a_ = outlines_[0];
    b_ = outlines_[1];
    const double *from = at.at_a.position, *to = at.at_b.position;
    position_ = Vector<3>(to[0] - from[0], to[1] - from[1], to[2] - from[2]) - rotation_of_a_ * a.centroid;
  }
  SteppedPair(const SteppedPair&) = delete;
  SteppedPair& operator=(const SteppedPair&) = delete;

  void move_to(double motion, double turn) {
    const Vector<3> half = std::sin(turn / 2) * axis_;
    const double quaternion[] = {half.x(), half.y(), half.z(), std::cos(turn / 2)};
    const Rotation<3> rotation = Rotation<3>::from_quaternion(quaternion) * rotation_of_b_;
    outlines_.turn(1, rotation);
    to_b_ = position_ + motion * path_ + rotation * centroid_of_b_;
  }

  bool judge_without_memory() const {
    PairCache<3> witness;
    judge_pair(a_, b_, to_b_, witness);
    return witness.state == PairCache<3>::touching;
  }
  bool judge() {
    if (!still_separated(a_, b_, to_b_, judged_)) judge_pair(a_, b_, to_b_, judged_);
    return judged_.state == PairCache<3>::touching;
  }
  /// Leaves the witness as it is after a step of a world, but for the verdict.
  void describe(halfspace::Contact<3>& contact) {
    if (judged_.state == PairCache<3>::touching) describe_contact<3>(a_, b_, to_b_, judged_, {}, contact);
  }

  bool find_contact_without_memory(halfspace::Contact<3>& contact) const {
    PairCache<3> witness;
    return halfspace::find_contact(a_, b_, to_b_, {}, witness, contact);
  }
  bool find_contact(halfspace::Contact<3>& contact) {
    return halfspace::find_contact(a_, b_, to_b_, {}, found_, contact);
  }

 private:
  Vector<3> centroid_of_b_;
  Rotation<3> rotation_of_a_;
  Rotation<3> rotation_of_b_;
  Vector<3> path_;
  Vector<3> axis_;
  Vector<3> position_;
  halfspace::Outlines<3> outlines_{std::pmr::get_default_resource()};
  halfspace::Outline<3> a_;  // into outlines_, as both blocks are turned there
  halfspace::Outline<3> b_;
  Vector<3> to_b_;
  PairCache<3> judged_;
  PairCache<3> found_;
};

}  // namespace

StepTimes time_steps(const PairSet3& set, int steps, double motion, double turn, Random& random) {
  std::deque<HalfspaceBlock> blocks;
  for (const Polyhedron& p : set.polyhedra) blocks.emplace_back(p);
  std::deque<SteppedPair> pairs;
  for (const PolyhedraAt& at : set.pairs)
    pairs.emplace_back(blocks[std::size_t(at.a)], blocks[std::size_t(at.b)], at, random);

  StepTimes times;
  long touching = 0;
  halfspace::Contact<3> contact;
  for (int step = 0; step <= steps; ++step) {
    for (SteppedPair& pair : pairs) pair.move_to(step * motion, step * turn);
    long verdicts[4] = {};
    const double seconds[] = {
        seconds_of([&] {
          for (const SteppedPair& pair : pairs) verdicts[0] += pair.judge_without_memory();
        }),
        seconds_of([&] {
          for (SteppedPair& pair : pairs) verdicts[1] += pair.judge();
        }),
        seconds_of([&] {
          for (const SteppedPair& pair : pairs) verdicts[2] += pair.find_contact_without_memory(contact);
        }),
        seconds_of([&] {
          for (SteppedPair& pair : pairs) verdicts[3] += pair.find_contact(contact);
        }),
    };
    for (SteppedPair& pair : pairs) pair.describe(contact);
    times.differences += std::abs(verdicts[1] - verdicts[0]) + std::abs(verdicts[3] - verdicts[0]);
    if (step == 0) continue;  // nothing is remembered yet
    times.judged_without_memory += seconds[0];
    times.judged += seconds[1];
    times.found_without_memory += seconds[2];
    times.found += seconds[3];
    touching += verdicts[0];
  }
  const double judged = double(steps) * double(pairs.size());
  for (double* seconds :
       {&times.judged_without_memory, &times.judged, &times.found_without_memory, &times.found})
    *seconds *= 1e9 / judged;
  times.touching = double(touching) / judged;
  return times;
}

}  // namespace halfspace_benchmark
