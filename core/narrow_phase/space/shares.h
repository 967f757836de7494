#pragma once

#include "narrow_phase/contact.h"

namespace halfspace {

/// Shares the stiffness of a contact among the points of its region.
///
/// Level, each corner of a region has a share of its area so that the mean of a linear gap comes out exactly:
/// where a corner splits into two, they have its share between them. A point loses its share as the steepest
/// way down from it to another one goes from a quarter to half the parallel angle. So the force does not jump
/// where the region shrinks to a segment or a point, or grows out of one, nor where another corner becomes
/// the deepest: between corners that are level, no way leads down.
void share_stiffness(const DetectOptions& options, Contact<3>& contact);

/// Drops the points of a region that have no share.
void keep_what_bears(Contact<3>& contact);

}  // namespace halfspace
