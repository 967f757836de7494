#pragma once

#include "model/layout.h"

namespace halfspace::cli {

/// The in-situ stress of a scene at a place: by the weight of the rock above it.
Tensor stress_at(const Scene& scene, const InSitu& in_situ, const Point& place);

/// Grows rigid blocks so that their joints carry the in-situ stress: by the overlap whose springs bear the
/// normal stress. The change of a block is the stress over the stiffness, some millionths of its size.
void stress_joints(const Context& context, const Scene& scene, Layout& layout, Faults& faults);

/// The shear force on block b of a contact with this normal, from a to b, and area.
Point shear_force_at(const Scene& scene, const InSitu& in_situ, const hs_contact& contact);

}  // namespace halfspace::cli
