#include <cmath>
#include <string>

#include "notes/kinds.h"
#include "text.h"
#include "vector.h"

namespace halfspace::cli {
namespace {

void note_gravity(int dimension, const Point& gravity, Place place, const std::string& key, Faults& faults) {
  const std::size_t up = up_axis(dimension);
  if (length(gravity) == 0 || gravity[up] < 0) return;
  const std::string axis = dimension == 3 ? "z" : "y";
  faults.note(place, key,
              described(gravity, dimension) +
                  (gravity[up] > 0 ? " points upwards" : " has no part along " + axis) + "; usual: along -" +
                  axis + ", as " + axis + " is up");
}

/// Rock is pressed, so that a stress in situ above 0 has the sign of other conventions.
void note_tension(const Making& making, Faults& faults) {
  if (!making.stress) return;
  bool is_pressed = false, is_pulled = false;
  for (const std::size_t component : {0, 4, 8}) {
    is_pressed |= (*making.stress)[component] < 0;
    is_pulled |= (*making.stress)[component] > 0;
  }
  if (is_pulled && !is_pressed)
    faults.note(
        making.place, making.key,
        quoted(making.name) + " has a normal_stress above 0, which pulls; usual: below 0, which presses");
}

/// A stress that grows upwards by density times gravity holds the weight.
void note_stress_by_height(const Start& start, const Mesh& mesh, Faults& faults) {
  constexpr double most_ratio = 10;
  const std::size_t up = up_axis(start.layout.dimension);
  const double given = mesh.stress_by_height[4 * up];
  const double usual = start.scene.materials[static_cast<std::size_t>(mesh.making.material)].density *
                       -start.scene.world.gravity[up];
  if (given == 0 || !(usual > 0) || (given * most_ratio > usual && given < most_ratio * usual)) return;
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
