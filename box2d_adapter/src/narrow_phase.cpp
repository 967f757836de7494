#include <halfspace/box2d.hpp>

#include "installation.h"

namespace halfspace::box2d {

NarrowPhase::NarrowPhase(b2World& world, Options options)
    : installation_(std::make_unique<Installation>(world, std::move(options))) {}

NarrowPhase::~NarrowPhase() = default;

void NarrowPhase::refresh(b2Fixture& fixture) { installation_->refresh(fixture); }

const Statistics& NarrowPhase::statistics() const { return installation_->statistics; }

void NarrowPhase::reset_statistics() { installation_->statistics = {}; }

}  // namespace halfspace::box2d
