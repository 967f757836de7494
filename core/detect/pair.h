#pragma once

#include "detect/contact.h"
#include "detect/separation.h"
#include "geometry/outline.h"

namespace halfspace {

/// Gap of a potential pair whose vertex may have moved on: `pair.vertex` is brought up to date.
double refresh(const Outline<2>& a, const Outline<2>& b, const Vector<2>& to_b, PotentialPair& pair);

/// Are a and b in contact, and through which pair? Returns the pair and its gap: a violated one when separated, a complete proof
/// (Wang et al. 2021, eq. 12), and the one remembered is tried first; else the initial contact pair (section 2.5).
Separation judge(const Outline<2>& a, const Outline<2>& b, const Vector<2>& to_b, PairMemory& memory);

/// Type, normal, gap and region of the contact at a potential pair, touching or not. `pair` is moved to the neighbouring one when
/// the vertex has left the edge across its end.
void describe_contact(const Outline<2>& a, const Outline<2>& b, const Vector<2>& to_b, PotentialPair& pair,
                      const DetectOptions& options, Contact<2>& contact);

/// Judges a pair: the contact when it touches, else ContactType::none with the violated pair, its normal and its gap.
void detect_pair(const Outline<2>& a, const Outline<2>& b, const Vector<2>& to_b, const DetectOptions& options,
                 PairMemory& memory, Contact<2>& contact);

}  // namespace halfspace
