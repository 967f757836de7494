#include "polygon_pair.h"

#include "manifold.h"

namespace halfspace::box2d {
namespace {

/// Faces whose gaps differ by less are as good as each other: Box2D's tolerance for this choice.
constexpr double same_gap = 0.1f * b2_linearSlop;

Face face_of(const hs_contact& contact) {
  return contact.pair_kind == HS_PAIR_FACE_VERTEX ? Face{0, contact.feature_a} : Face{1, contact.feature_b};
}

}  // namespace

PolygonPair::PolygonPair(std::shared_ptr<const Polygon> a, std::shared_ptr<const Polygon> b, double radii)
    : a_(std::move(a)), b_(std::move(b)), radii_(radii) {}

/// Polygons that begin to touch do so at a face of a if one is as good, as Box2D has it; later they stay at
/// the face where they are. So a point keeps its id, and the impulse that goes with it, as long as it can.
Face PolygonPair::preferred_to(const Face& largest, const Placement& b_from_a) const {
  if (in_contact_) return reference_;
  if (largest.owner == 0) return largest;
  const SeenFromFace seen(*a_, *b_, b_from_a, largest);
  return {0, incident_edge(seen, deepest_vertex(seen))};
}

bool PolygonPair::search(const Placement& b_from_a) {
  const hs_pose here = {{0, 0, 0}, {0, 0, 0, 1}}, there = pose_of(b_from_a);
  hs_pair_options options;
  hs_pair_options_init(&options, sizeof options);
  options.margin = radii_;
  options.without_region = 1;
  hs_contact found;
  if (hs_pair_detect(a_->shape(), &here, b_->shape(), &there, &options, &cache_, &found) != HS_OK)
    return false;
  const bool in_contact = found.type != HS_CONTACT_NONE;
  double surplus = -1;
  if (in_contact) {
    const Face largest = face_of(found), preferred = preferred_to(largest, b_from_a);
    surplus = same_gap;
    reference_ = largest;
    if (preferred != largest) {
      const SeenFromFace seen(*a_, *b_, b_from_a, preferred);
      const double worse_by = found.gap - seen.gap(deepest_vertex(seen));
      if (worse_by <= same_gap) {
        reference_ = preferred;
        surplus = same_gap - worse_by;
      }
    }
  }
  in_contact_ = in_contact;
  proof_ = SearchProof(*a_, *b_, b_from_a, found.gap, surplus);
  return true;
}

bool PolygonPair::collide(const b2Transform& at_a, const b2Transform& at_b, b2Manifold& manifold) {
  const Placement b_from_a = placement_of(*a_, at_a, *b_, at_b);
  const double change = proof_.most_change(b_from_a);
  const bool still_separated = !in_contact_ && proof_.still_separated(change, radii_);
  const bool known = still_separated || (in_contact_ && proof_.still_at_same_face(change, radii_));
  if (!known && !search(b_from_a)) return false;
  manifold.pointCount = 0;
  if (!in_contact_) return true;
  const SeenFromFace seen(*a_, *b_, b_from_a, reference_);
  write_manifold(seen, reference_, deepest_vertex(seen), radii_, manifold);
  return true;
}

}  // namespace halfspace::box2d
