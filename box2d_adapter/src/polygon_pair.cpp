#include "polygon_pair.h"

#include "manifold.h"

namespace halfspace::box2d {
namespace {

/// Faces whose gaps differ by less are equivalent: Box2D's tolerance of this choice.
constexpr double same_gap = 0.1f * b2_linearSlop;

Face face_of(const hs_contact& contact) {
  return contact.pair_kind == HS_PAIR_FACE_VERTEX ? Face{0, contact.feature_a} : Face{1, contact.feature_b};
}

/// The deepest vertex of the other polygon.
int deepest_of(const hs_contact& contact) {
  return contact.pair_kind == HS_PAIR_FACE_VERTEX ? contact.feature_b : contact.feature_a;
}

hs_pair_options options_of_search() {
  hs_pair_options options;
  hs_pair_options_init(&options, sizeof options);
  options.without_region = 1;
  return options;
}

}  // namespace

PolygonPair::PolygonPair(std::shared_ptr<const Polygon> a, std::shared_ptr<const Polygon> b, double radii)
    : centroid_a_(a->centroid()),
      centroid_b_(b->centroid()),
      radii_(radii),
      a_(std::move(a)),
      b_(std::move(b)) {}

double PolygonPair::gap_at(const Face& face, const Placement& b_from_a) const {
  const SeenFromFace seen(*a_, *b_, b_from_a, face);
  return seen.gap(deepest_vertex(seen));
}

/// At first touch a face of a is preferred, as in Box2D; later the current face. So a point keeps its id and
/// its impulse as long as possible.
Face PolygonPair::preferred_to(const Face& largest, int deepest, const Placement& b_from_a) const {
  if (in_contact_) return face_;
  if (largest.owner == 0) return largest;
  return {0, incident_edge(SeenFromFace(*a_, *b_, b_from_a, largest), deepest)};
}

/// Testing one face is cheaper than a search over all, and a separating face mostly separates in the next
/// step, too.
bool PolygonPair::is_known(const Placement& b_from_a) {
  const double change = proof_.max_change(b_from_a);
  if (in_contact_) return proof_.still_at_same_face(change, radii_);
  if (proof_.still_separated(change, radii_)) return true;
  const double gap = gap_at(face_, b_from_a);
  if (gap > radii_) proof_ = SearchProof(*a_, *b_, b_from_a, gap);
  return gap > radii_;
}

bool PolygonPair::search(const Placement& b_from_a) {
  const hs_pose here = {{0, 0, 0}, {0, 0, 0, 1}}, there = pose_of(b_from_a);
  static const hs_pair_options without_margin = options_of_search();
  hs_pair_options options = without_margin;
  options.margin = radii_;
  hs_contact found;
  if (hs_pair_detect(a_->shape(), &here, b_->shape(), &there, &options, nullptr, &found) != HS_OK)
    return false;
  const Face largest = face_of(found);
  if (found.type == HS_CONTACT_NONE) {
    face_ = largest;
    proof_ = SearchProof(*a_, *b_, b_from_a, found.gap);
    in_contact_ = false;
    return true;
  }
  const Face preferred = preferred_to(largest, deepest_of(found), b_from_a);
  const double worse_by = preferred == largest ? 0 : found.gap - gap_at(preferred, b_from_a);
  const bool is_as_good = worse_by <= same_gap;
  face_ = is_as_good ? preferred : largest;
  proof_ = SearchProof(*a_, *b_, b_from_a, found.gap, is_as_good ? same_gap - worse_by : same_gap);
  in_contact_ = true;
  return true;
}

bool PolygonPair::collide(const b2Transform& at_a, const b2Transform& at_b, b2Manifold& manifold) {
  const Placement b_from_a = placement_of(centroid_a_, at_a, centroid_b_, at_b);
  if (!is_known(b_from_a) && !search(b_from_a)) return false;
  manifold.pointCount = 0;
  if (!in_contact_) return true;
  const SeenFromFace seen(*a_, *b_, b_from_a, face_);
  write_manifold(seen, face_, deepest_vertex(seen), radii_, manifold);
  return true;
}

}  // namespace halfspace::box2d
