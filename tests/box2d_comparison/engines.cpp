#include "engines.h"

#include <cmath>
#include <halfspace/box2d_force.hpp>
#include <halfspace/box2d_impulse.hpp>

#include "forces.h"

namespace box2d_comparison {
namespace {

using halfspace::box2d::FixtureGeometry;
using halfspace::box2d::ForceMode;
using halfspace::box2d::ImpulseMode;
using halfspace::box2d::NarrowPhase;
using halfspace::box2d::Options;

Options with_true_polygons() {
  Options options;
  options.geometry_of = [](b2Fixture& fixture) {
    const TruePolygon* truth = true_polygon_of(fixture);
    return FixtureGeometry{false, truth ? truth->shape.get() : nullptr};
  };
  return options;
}

/// Box2D's solver, on the contacts of Box2D's own narrow phase.
class EnergySample : public Engine {
 public:
  explicit EnergySample(Stage& stage) : world_(stage.world()) {}
  void step() override { world_.Step(float(frame_seconds), 8, 3); }

 private:
  b2World& world_;
};

/// Box2D's solver, on those of the half-space narrow phase, which meets the true polygons.
class Halfspace : public EnergySample {
 public:
  Halfspace(Stage& stage, Options options)
      : EnergySample(stage), narrow_phase_(stage.world(), std::move(options)) {}

 private:
  NarrowPhase narrow_phase_;
};

/// The library's forces in place of Box2D's solver, between the same true polygons.
class Forces : public Engine {
 public:
  Forces(Stage& stage, int bearers)
      : narrow_phase_(stage.world(), with_true_polygons()),
        forces_(narrow_phase_, law_of_forces(force_stiffness(stage.world(), bearers))) {}

  void step() override { forces_.step(float(frame_seconds), sub_steps(), 8, 3); }
  int sub_steps() override { return forces_.sub_steps_for(float(frame_seconds)); }

 private:
  NarrowPhase narrow_phase_;
  ForceMode forces_;
};

/// The library's impulses at Box2D's step, between the same true polygons.
class Impulses : public Engine {
 public:
  explicit Impulses(Stage& stage)
      : narrow_phase_(stage.world(), with_true_polygons()), impulses_(narrow_phase_) {}

  void step() override { impulses_.step(float(frame_seconds), 8, 3); }

 private:
  NarrowPhase narrow_phase_;
  ImpulseMode impulses_;
};

std::unique_ptr<Engine> begin_impulses(Stage& stage) { return std::make_unique<Impulses>(stage); }

std::unique_ptr<Engine> begin_stock(Stage& stage) { return std::make_unique<EnergySample>(stage); }

std::unique_ptr<Engine> begin_halfspace(Stage& stage) {
  return std::make_unique<Halfspace>(stage, with_true_polygons());
}

/// Puts what moves 0.1 mm to the left and to the right of where it was by turns, or to the next float.
void nudge(b2World& world, float side) {
  for (b2Body* body = world.GetBodyList(); body; body = body->GetNext()) {
    if (body->GetType() != b2_dynamicBody) continue;
    const b2Vec2 at = body->GetPosition();
    const float aside = at.x + side * 1e-4f;
    body->SetTransform({aside != at.x ? aside : std::nextafter(at.x, side * INFINITY), at.y},
                       body->GetAngle());
    side = -side;
  }
}

/// The same world, of which all that moves has been moved aside.
EngineKind nudged(const EngineKind& kind, const char* suffix, float side) {
  const auto begin = [begin = kind.begin, side](Stage& stage) {
    nudge(stage.world(), side);
    return begin(stage);
  };
  return {kind.name + suffix, kind.rest_gap, begin, kind.is_by_itself};
}

}  // namespace

std::vector<EngineKind> engine_kinds(const ForceUse& forces) {
  std::vector<EngineKind> kinds = {{"box2d", skins, begin_stock},
                                   {"halfspace", skins, begin_halfspace},
                                   {"impulses", 0, begin_impulses, true}};
  if (forces.bearers > 0) {
    const auto begin = [bearers = forces.bearers](Stage& stage) {
      return std::make_unique<Forces>(stage, bearers);
    };
    kinds.push_back({"forces", 0, begin, true});
  }
  const std::size_t nudged_kinds = forces.bearers > 0 && !forces.is_nudged ? kinds.size() - 1 : kinds.size();
  for (std::size_t i = 0; i < nudged_kinds; ++i) {
    kinds.push_back(nudged(kinds[i], "_nudged", 1));
    kinds.push_back(nudged(kinds[i], "_nudged_back", -1));
  }
  return kinds;
}

std::unique_ptr<Engine> begin_compared(Stage& stage,
                                       std::function<void(const halfspace::box2d::Comparison&)> compared) {
  Options options = with_true_polygons();
  options.compared = std::move(compared);
  return std::make_unique<Halfspace>(stage, std::move(options));
}

}  // namespace box2d_comparison
