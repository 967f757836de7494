#pragma once

#include "detect/contact.h"
#include "detect/seen_outline.h"

namespace halfspace {

/// A contact at a point, with the gap that it has already.
void describe_point(ContactType type, const Vector<3>& point, Contact<3>& contact);

/// The region of a face of a and what is parallel to it of b at a vertex: a face, or else an edge. False when
/// there is none.
bool describe_face_region(const SeenOutline& a, const SeenOutline& b, const Vector<3>& to_b,
                          const PotentialPair<3>& pair, const DetectOptions& options, Contact<3>& contact);

/// Of a face of a and a vertex of b. Returns the pair, or the neighbouring one when the foot of the vertex
/// lies outside the face: then this is the contact at the edge or vertex of the face that it lies beyond.
PotentialPair<3> describe_face_vertex(const SeenOutline& a, const SeenOutline& b, const Vector<3>& to_b,
                                      const PotentialPair<3>& pair, const DetectOptions& options,
                                      Contact<3>& contact);

}  // namespace halfspace
