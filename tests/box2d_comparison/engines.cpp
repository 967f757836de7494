#include "engines.h"

#include <cmath>

namespace box2d_comparison {
namespace {

using halfspace::box2d::FixtureGeometry;
using halfspace::box2d::NarrowPhase;
using halfspace::box2d::Options;

/// Box2D's solver, on the contacts of Box2D's own narrow phase.
class Stock : public Engine {
 public:
  explicit Stock(Stage& stage) : world_(stage.world()) {}
  void step() override { world_.Step(float(frame_seconds), 8, 3); }

 private:
  b2World& world_;
};

/// Box2D's solver, on those of the half-space narrow phase, which meets the true polygons.
class Halfspace : public Stock {
 public:
  Halfspace(Stage& stage, Options options) : Stock(stage), narrow_phase_(stage.world(), std::move(options)) {}

 private:
  NarrowPhase narrow_phase_;
};

Options with_true_polygons() {
  Options options;
  options.geometry_of = [](b2Fixture& fixture) {
    const TruePolygon* truth = true_polygon_of(fixture);
    return FixtureGeometry{false, truth ? truth->shape.get() : nullptr};
  };
  return options;
}

std::unique_ptr<Engine> begin_stock(Stage& stage) { return std::make_unique<Stock>(stage); }

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

template <auto begin, int side>
std::unique_ptr<Engine> begin_nudged(Stage& stage) {
  nudge(stage.world(), float(side));
  return begin(stage);
}

}  // namespace

const std::vector<EngineKind>& engine_kinds() {
  static const std::vector<EngineKind> kinds = {{"box2d", begin_stock},
                                                {"halfspace", begin_halfspace},
                                                {"box2d_nudged", begin_nudged<begin_stock, 1>},
                                                {"halfspace_nudged", begin_nudged<begin_halfspace, 1>},
                                                {"box2d_nudged_back", begin_nudged<begin_stock, -1>},
                                                {"halfspace_nudged_back", begin_nudged<begin_halfspace, -1>}};
  return kinds;
}

std::unique_ptr<Engine> begin_compared(Stage& stage,
                                       std::function<void(const halfspace::box2d::Comparison&)> compared) {
  Options options = with_true_polygons();
  options.compared = std::move(compared);
  return std::make_unique<Halfspace>(stage, std::move(options));
}

}  // namespace box2d_comparison
