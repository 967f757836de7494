#pragma once

#include "narrow_phase/contact.h"
#include "narrow_phase/space/seen_outline.h"

namespace halfspace {

/// Is a contact at a point, without a region, and does this also prove that the blocks touch?
enum class Plain { no, yes, and_touching };

/// Describes the most frequent contacts of a potential pair: a vertex well inside a face, or two crossing
/// edges, with no feature nearly parallel to the contact plane. In doubt returns no and describes nothing.
/// The vertex of a face need not be the deepest one: if the result is not no, it is.
Plain describe_plain_contact(const SeenOutline& a, const SeenOutline& b, const Vector<3>& to_b,
                             const PotentialPair<3>& pair, const DetectOptions& options, Contact<3>& contact);

}  // namespace halfspace
