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

  /// Writes the manifold. False, and nothing written, when the library refuses the poses.
  bool collide(const b2Transform& at_a, const b2Transform& at_b, b2Manifold& manifold);

 private:
  /// Asks the library, and finds the reference face if the polygons are in contact. False when it refuses.
  bool search(const Placement& b_from_a);
  Face preferred_to(const Face& largest, const Placement& b_from_a) const;

  // What is read in every step comes first.
  std::shared_ptr<const Polygon> a_;
  std::shared_ptr<const Polygon> b_;
  double radii_;
  bool in_contact_ = false;
  Face reference_;  // while in contact
  SearchProof proof_;
  hs_pair_cache cache_{};
};

}  // namespace halfspace::box2d
