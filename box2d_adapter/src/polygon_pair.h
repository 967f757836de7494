#pragma once

#include <box2d/b2_collision.h>

#include <halfspace/box2d.hpp>
#include <memory>

#include "face.h"
#include "search_proof.h"

namespace halfspace::box2d {

/// Two polygons that may touch, and what they remember from step to step.
class PolygonPair {
 public:
  /// In skins that reach `radii` together.
  PolygonPair(std::shared_ptr<const Polygon> a, std::shared_ptr<const Polygon> b, double radii);

  const std::shared_ptr<const Polygon>& a() const { return a_; }
  const std::shared_ptr<const Polygon>& b() const { return b_; }

  /// Writes the manifold. False, and nothing written, when the library refuses the poses.
  bool collide(const b2Transform& at_a, const b2Transform& at_b, b2Manifold& manifold);

 private:
  /// Is what the last search has found still so, by the proof or by a look at the separating face?
  bool is_known(const Placement& b_from_a);
  /// Asks the library, and finds the reference face if the polygons are in contact. False when it refuses.
  bool search(const Placement& b_from_a);
  double gap_at(const Face& face, const Placement& b_from_a) const;
  Face preferred_to(const Face& largest, int deepest, const Placement& b_from_a) const;

  // What is read in every step comes first: of a pair that stays apart, no polygon.
  Vector centroid_a_, centroid_b_;
  SearchProof proof_;
  double radii_;
  Face face_;  // the reference face of a pair in contact; else one that separates
  bool in_contact_ = false;
  std::shared_ptr<const Polygon> a_;
  std::shared_ptr<const Polygon> b_;
};

}  // namespace halfspace::box2d
