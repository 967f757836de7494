#include "detection.h"

#include "narrow_phase/plane/posed_pair.h"
#include "narrow_phase/space/posed_pair.h"
#include "pose_and_vector.h"

namespace halfspace::capi {
namespace {

template <int D>
Frames<D> read_frames(const PosedPair<D>& posed) {
  if (!are_tolerable<D>(posed.at_a, posed.at_b)) {
    require_pose<D>(posed.at_a, "pose_a");
    require_pose<D>(posed.at_b, "pose_b");
  }
  return frames_of<D>(posed.at_a, posed.at_b);
}

}  // namespace

template <int D>
void judge(const PosedPair<D>& posed, const PairOptions& options, hs_pair_cache* cache, Memory* room,
           hs_contact& out) {
  const Frames<D> frames = read_frames(posed);
  PairCache<D> witness;
  if (cache) witness = read_cache(*cache, posed);
  write_contact(search_pair(posed, frames, options, witness, room), out);
  if (cache) write_cache(witness, posed, out, *cache);
}

template void judge(const PosedPair<2>&, const PairOptions&, hs_pair_cache*, Memory*, hs_contact&);
template void judge(const PosedPair<3>&, const PairOptions&, hs_pair_cache*, Memory*, hs_contact&);

}  // namespace halfspace::capi
