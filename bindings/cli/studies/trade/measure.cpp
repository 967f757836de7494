#include "studies/trade/measure.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "scene/read_values.h"

namespace halfspace::cli {
namespace {

constexpr double short_run = 0.02;  // s of CPU time; shorter runs are repeated, as clocks are coarse
constexpr double steepest = 89;     // degrees
constexpr int halvings = 14;

Outcomes run_once(const Scene& scene, int disturbance) {
  const Context context = make_context(scene.threads);
  Layout layout = layout_of(context, scene);
  disturb(context, disturbance, layout);
  Model model(context, scene, std::move(layout));
  return run_for_quantity(scene, model);
}

void set_friction(Scene& scene, double angle) {
  for_each_law(scene, [&](hs_law_def& law) {
    if (&law == &scene.default_law || law.friction_angle > 0) law.friction_angle = angle;
  });
}

/// Pairs of materials without friction stay without.
Outcomes find_friction_angle(Scene scene, int disturbance) {
  Outcomes all;
  const auto stands_at = [&](double angle) {
    set_friction(scene, angle * degree);
    const Outcomes run = run_once(scene, disturbance);
    all.cpu_seconds += run.cpu_seconds;
    all.simulated += run.simulated;
    all.end = run.end;
    return run.value > 0;
  };
  const bool stands_without = stands_at(0);
  if (all.end != RunEnd::whole) return all;
  const bool can_stand = !stands_without && stands_at(steepest);
  if (all.end != RunEnd::whole) return all;
  if (!can_stand) {
    all.end = RunEnd::no_angle;
    return all;
  }
  double falls = 0, stands = steepest;
  for (int i = 0; i < halvings && all.end == RunEnd::whole; ++i) {
    const double middle = (falls + stands) / 2;
    (stands_at(middle) ? stands : falls) = middle;
  }
  all.value = (falls + stands) / 2;
  return all;
}

}  // namespace

Layout layout_of(const Context& context, const Scene& scene) {
  Faults faults;  // the scene has been checked
  Layout layout = lay_out_blocks(context, scene, faults);
  if (!faults.none())
    throw std::runtime_error("the scene with this setting is faulty: " + faults.describe("scene"));
  return layout;
}

Outcomes measure(const Setting& setting, const Scene& scene, const FaceSize& face) {
  const Scene of_setting = with_setting(scene, setting, face);
  return scene.reference.quantity == Quantity::friction_angle
             ? find_friction_angle(of_setting, setting.disturbance)
             : fastest_of(short_run, [&] { return run_once(of_setting, setting.disturbance); });
}

double angle_resolution() { return std::ldexp(steepest, -halvings); }

bool names_cells(const Scene& scene) { return layout_of(make_context(), scene).names_cells; }

FaceSize typical_face(const Scene& scene) {
  const Context context = make_context();
  return typical_face(context, scene, Model(context, scene, layout_of(context, scene)));
}

}  // namespace halfspace::cli
