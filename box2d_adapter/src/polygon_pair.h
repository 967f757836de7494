#pragma once

#include <box2d/b2_collision.h>

#include <halfspace/box2d.hpp>
#include <memory>

#include "face.h"
#include "search_proof.h"

namespace halfspace::box2d {

/// Two polygons that may touch, with their state from step to step.
class PolygonPair {
 public:
  /// `radii` is the sum of both skins.
  PolygonPair(std::shared_ptr<const Polygon> a, std::shared_ptr<const Polygon> b, double radii);

  const std::shared_ptr<const Polygon>& a() const { return a_; }
  const std::shared_ptr<const Polygon>& b() const { return b_; }

  /// Writes the manifold. False, without writing it, if the library refuses the poses.
  bool collide(const b2Transform& at_a, const b2Transform& at_b, b2Manifold& manifold);

 private:
  /// Is the result of the last search still valid, by the proof or by the separating face?
  bool is_known(const Placement& b_from_a);
  /// Detects by the library, and finds the reference face of polygons in contact. False if the library
  /// refuses.
  bool search(const Placement& b_from_a);
  double gap_at(const Face& face, const Placement& b_from_a) const;
  Face preferred_to(const Face& largest, int deepest, const Placement& b_from_a) const;

  // Members that every step reads are first; separated pairs need no polygon.
  Vector centroid_a_, centroid_b_;
  SearchProof proof_;
  double radii_;
  Face face_;  // reference face of a pair in contact; else a separating face
  bool in_contact_ = false;
  std::shared_ptr<const Polygon> a_;
  std::shared_ptr<const Polygon> b_;
};

}  // namespace halfspace::box2d
