#include <cmath>
#include <string>

#include "common/text.h"
#include "common/vector.h"
#include "notes/kinds.h"

namespace halfspace::cli {
namespace {

void note_gravity(int dimension, const Point& gravity, Place place, const std::string& key, Faults& faults) {
  const std::size_t up = up_axis(dimension);
  if (length(gravity) == 0 || gravity[up] < 0) return;
  const std::string axis = dimension == 3 ? "z" : "y";
  faults.note(place, key,
              described(gravity, dimension) +
                  (gravity[up] > 0 ? " points upwards" : " has no component along " + axis) +
                  "; usual: along -" + axis + ", as " + axis + " is up");
}

/// In-situ stresses of rock are compressive, so that a positive one probably has the sign of another
/// convention.
void note_tension(const Making& making, Faults& faults) {
  if (!making.stress) return;
  bool is_pressed = false, is_pulled = false;
  for (const std::size_t component : {0, 4, 8}) {
    is_pressed |= (*making.stress)[component] < 0;
    is_pulled |= (*making.stress)[component] > 0;
  }
  if (is_pulled && !is_pressed)
    faults.note(making.place, making.key,
                quoted(making.name) + " has a normal_stress above 0, tension; usual: below 0, compression");
}

/// A vertical gradient of density times gravity balances the weight.
void note_stress_by_height(const Start& start, const Mesh& mesh, Faults& faults) {
  constexpr double max_ratio = 10;
  const std::size_t up = up_axis(start.layout.dimension);
  const double given = mesh.stress_by_height[4 * up];
  const double usual = start.scene.materials[static_cast<std::size_t>(mesh.making.material)].density *
                       -start.scene.world.gravity[up];
  if (given == 0 || !(usual > 0) || (given * max_ratio > usual && given < max_ratio * usual)) return;
  faults.note(mesh.making.place, mesh.making.key,
              quoted(mesh.making.name) + " has a normal_stress_by_height of " + shortest(given) +
                  " Pa/m upwards; usual: density times gravity, " + rounded(usual, 4) + " Pa/m");
}

}  // namespace

void note_directions(const Start& start, Faults& faults) {
  const Scene& scene = start.scene;
  note_gravity(start.layout.dimension, point_of(scene.world.gravity), scene.places.gravity, "world.gravity",
               faults);
  for (std::size_t i = 0; i < scene.stages.size(); ++i) {
    if (!scene.stages[i].gravity) continue;
    note_gravity(start.layout.dimension, *scene.stages[i].gravity, scene.stages[i].gravity_place,
                 "stage[" + std::to_string(i) + "].gravity", faults);
  }
  for_each_making(scene, [&](const Making& making) { note_tension(making, faults); });
  for (const Mesh& mesh : scene.meshes) note_stress_by_height(start, mesh, faults);
}

}  // namespace halfspace::cli
