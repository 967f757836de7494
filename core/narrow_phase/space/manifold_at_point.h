#pragma once

#include "narrow_phase/contact.h"
#include "narrow_phase/space/seen_outline.h"

namespace halfspace {

/// Is a contact at a point and plainly nothing else, and if so, does it show by itself that the blocks touch?
enum class Plain { no, yes, and_touching };

/// The contact of a potential pair as it is as a rule: of a vertex well inside a face or of two edges that
/// cross, with nothing near to parallel with the contact plane. Nothing is described where it may be
/// otherwise. The vertex of a face need not be known to be the deepest one: it is where the answer is not no.
Plain describe_plain_contact(const SeenOutline& a, const SeenOutline& b, const Vector<3>& to_b,
                             const PotentialPair<3>& pair, const DetectOptions& options, Contact<3>& contact);

}  // namespace halfspace
