#include "studies/trade/setting.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "common/random.h"
#include "common/text.h"
#include "common/vector.h"
#include "scene/law_numbers.h"

namespace halfspace::cli {
namespace {

std::vector<Point> corners_of(const std::vector<Point>& vertices, const std::vector<int>& loop) {
  std::vector<Point> corners;
  for (int vertex : loop) corners.push_back(vertices[static_cast<std::size_t>(vertex)]);
  return corners;
}

double perimeter(const std::vector<Point>& loop) {
  double around = 0;
  for (std::size_t i = 0; i < loop.size(); ++i) around += length(minus(loop[(i + 1) % loop.size()], loop[i]));
  return around;
}

/// Laws without a spring get one as stiff as a layer of cells.
void change_kind(hs_law_def& law, int kind, const FaceSize& face) {
  if (kind == law.stiffness_kind) return;
  const bool had_none = !has_spring(law);
  const double shear = law.shear_stiffness > 0 ? law.shear_stiffness : law.normal_stiffness;
  const double normal_of_face =
      had_none ? face.stiffness
               : law.normal_stiffness * normal_per_face(law.stiffness_kind, face.area, face.potential_length);
  const double shear_of_face =
      had_none ? face.stiffness : shear * shear_per_face(law.stiffness_kind, face.area);
  law.stiffness_kind = kind;
  clear_refused_numbers(law);
  if (kind == HS_STIFFNESS_NONE) return;  // it reads neither stiffnesses nor dampings
  law.normal_stiffness = normal_of_face / normal_per_face(kind, face.area, face.potential_length);
  law.shear_stiffness = shear_of_face / shear_per_face(kind, face.area);
}

void apply(hs_law_def& law, const Setting& setting, const FaceSize& face) {
  if (setting.law) change_kind(law, *setting.law, face);
  law.normal_stiffness *= setting.stiffness;
  law.shear_stiffness *= setting.stiffness;
  if (setting.damping) law.normal_damping = law.shear_damping = *setting.damping;
}

/// The bodies of [[mesh]] stay meshes.
void set_kind(Scene& scene, int kind) {
  const Scene given = scene;
  for_each_block_making(scene, [&](Making& making) {
    if (moves_freely(making.kind)) making.kind = kind;
    if (kind != HS_BLOCK_AFFINE) making.stress.reset();
  });
  for (std::size_t i = 0; i < scene.blocks.size(); ++i)
    if (stays_rigid(given.blocks[i], scene.world.dimension))
      scene.blocks[i].making.kind = given.blocks[i].making.kind;
}

int times_as_many(double factor, int count) {
  return std::max(1, static_cast<int>(std::lround(factor * count)));
}

void cut_meshes(Scene& scene, double factor) {
  for (Mesh& mesh : scene.meshes)
    for (int& count : mesh.counts) count = times_as_many(factor, count);
  for_each_block_making(scene, [&](Making& making) { making.cell_size /= factor; });
}

std::string mesh_lines(const Scene& scene) {
  std::string text;
  for (const Mesh& mesh : scene.meshes) {
    if (!mesh.box) continue;
    text += "\n[[mesh]]\nname = \"" + mesh.making.name + "\"\ncells = [";
    for (int axis = 0; axis < scene.world.dimension; ++axis)
      text += (axis == 0 ? "" : ", ") + std::to_string(mesh.counts[static_cast<std::size_t>(axis)]);
    text += "]\n";
  }
  for_each_block_making(scene, [&](const Making& making) {
    if (making.kind == HS_BLOCK_MESH)
      text += "\n# " + making.name + '\n' + "cell_size = " + shortest(making.cell_size) + '\n';
  });
  return text;
}

std::string law_lines(const hs_law_def& law) {
  if (!has_spring(law))
    return "stiffness = \"" + name_of_law(law.stiffness_kind) +
           "\"\nrestitution = " + shortest(law.restitution) + '\n';
  return "stiffness = \"" + name_of_law(law.stiffness_kind) +
         "\"\nnormal_stiffness = " + rounded(law.normal_stiffness, 6) +
         "\nshear_stiffness = " + rounded(law.shear_stiffness, 6) +
         "\nnormal_damping = " + shortest(law.normal_damping) +
         "\nshear_damping = " + shortest(law.shear_damping) + '\n';
}

bool has_potential(const Scene& scene) {
  return any_law(scene, [](const hs_law_def& law) { return law.stiffness_kind == HS_STIFFNESS_POTENTIAL; });
}

class Mean {
 public:
  void add(double sum, double count) {
    sum_ += sum;
    count_ += count;
  }
  double sum() const { return sum_; }
  double value() const { return count_ > 0 ? sum_ / count_ : 1; }

 private:
  double sum_ = 0, count_ = 0;
};

}  // namespace

FaceSize typical_face(const Context& context, const Scene& scene, const Model& model) {
  Mean faces, edges, moduli;
  for (const LayoutBlock& block : model.layout().blocks) {
    if (!moves_freely(block.kind)) continue;
    const Material& material = scene.materials[static_cast<std::size_t>(block.material)];
    if (material.elasticity) moduli.add(material.elasticity->young_modulus, 1);
    const std::vector<Point> vertices = vertices_of(context, block.shape);
    for (const std::vector<int>& loop : block.faces) {
      const std::vector<Point> corners = corners_of(vertices, loop);
      edges.add(perimeter(corners), static_cast<double>(loop.size()));
      faces.add(length(area_normal(corners)) / 2, 1);
    }
  }
  FaceSize face;
  face.area = scene.world.dimension == 2 ? edges.value() : faces.value();
  face.potential_length = scene.world.potential_length;
  if (face.potential_length == 0) face.potential_length = model.report().potential_length;
  if (face.potential_length == 0) face.potential_length = edges.value();  // the scene has no potentials
  face.stiffness =
      moduli.sum() > 0 ? moduli.value() * (scene.world.dimension == 2 ? 1 : std::sqrt(face.area)) : 0;
  return face;
}

bool stays_rigid(const Block& block, int dimension) {
  if (block.motion.held_axes != 0 || block.is_joined) return true;
  if (dimension == 3 || !moves_freely(block.making.kind) || block.vertices.empty()) return false;
  const std::vector<Point>& corners = block.vertices;
  bool turns_left = false, turns_right = false;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Point &here = corners[(i + 1) % corners.size()], &next = corners[(i + 2) % corners.size()];
    const double turn = cross(minus(here, corners[i]), minus(next, here))[2];
    (turn > 0 ? turns_left : turns_right) |= turn != 0;
  }
  return turns_left && turns_right;
}

bool has_cut_meshes(const Scene& scene) {
  return any_block_making(scene, [](const Making& making) { return making.kind == HS_BLOCK_MESH; }) ||
         std::any_of(scene.meshes.begin(), scene.meshes.end(),
                     [](const Mesh& mesh) { return mesh.box.has_value(); });
}

bool has_stable_step(const Scene& scene) {
  return any_law(scene, has_spring) || !scene.meshes.empty() ||
         any_block_making(scene, [](const Making& making) { return deforms(making.kind); });
}

double largest_step(const Scene& scene) {
  constexpr double frame = 1.0 / 60;
  return has_stable_step(scene) ? frame : scene.world.time_step;
}

Scene with_setting(Scene scene, const Setting& setting, const FaceSize& face) {
  const double step = setting.step * largest_step(scene);
  hs_world_def& world = scene.world;
  world.safety = setting.step;
  if (setting.skin) world.skin = *setting.skin;
  if (setting.tolerance) world.impulse_tolerance = *setting.tolerance;
  world.potential_length = face.potential_length;
  for_each_law(scene, [&](hs_law_def& law) { apply(law, setting, face); });
  if (setting.kind) set_kind(scene, *setting.kind);
  if (setting.cells != 1) cut_meshes(scene, setting.cells);
  world.time_step = has_stable_step(scene) ? 0 : step;
  return scene;
}

void disturb(const Context& context, int number, Layout& layout) {
  if (number == 0) return;
  Random random(static_cast<std::uint64_t>(number));
  const auto shift_of = [&](double size) {
    Point shift{};
    for (std::size_t axis = 0; axis < static_cast<std::size_t>(layout.dimension); ++axis)
      shift[axis] = 1e-9 * size * (2 * random.uniform() - 1);
    return shift;
  };
  const auto size_of_block = [&](std::size_t i) {
    return properties_of(context, layout.blocks[i].shape).bounding_radius;
  };
  const auto move = [](Placing& placing, const Point& shift) { placing.shift = plus(placing.shift, shift); };
  for (std::size_t i = 0; i < layout.blocks.size(); ++i) {
    LayoutBlock& block = layout.blocks[i];
    if (moves_freely(block.kind) && !block.body && !block.compound)
      move(block.placing, shift_of(size_of_block(i)));
  }
  for (const LayoutCompound& compound : layout.compounds) {
    if (!moves_freely(layout.blocks[compound.first_block].kind)) continue;
    const Point shift = shift_of(size_of_block(compound.first_block));
    for (std::size_t part = 0; part < compound.part_count; ++part)
      move(layout.blocks[compound.first_block + part].placing, shift);
  }
  for (LayoutBody& body : layout.bodies) {
    const double volume = std::accumulate(body.cell_sizes.begin(), body.cell_sizes.end(), 0.0);
    move(body.placing, shift_of(std::pow(volume, 1.0 / layout.dimension) / 2));
  }
}

std::string name_of_law(int stiffness_kind) {
  return std::string(law_names[static_cast<std::size_t>(stiffness_kind)]);
}

const char* name_of_kind(int kind) { return kind == HS_BLOCK_AFFINE ? "affine" : "rigid"; }

std::string scene_lines(const Setting& setting, const Scene& scene, const FaceSize& face) {
  const Scene changed_scene = with_setting(scene, setting, face);
  std::string text = has_stable_step(changed_scene)
                         ? "[world]  # and no time_step\nsafety = " + shortest(setting.step) + '\n'
                         : "[world]\ntime_step = " + shortest(changed_scene.world.time_step) + '\n';
  if (setting.skin) text += "skin = " + shortest(*setting.skin) + '\n';
  if (setting.tolerance) text += "impulse_tolerance = " + shortest(*setting.tolerance) + '\n';
  if (has_potential(changed_scene)) text += "potential_length = " + rounded(face.potential_length, 6) + '\n';
  text += "\n[default_law]\n" + law_lines(changed_scene.default_law);
  for (const PairLaw& pair : changed_scene.laws) {
    const auto name = [&](int material) { return scene.materials[static_cast<std::size_t>(material)].name; };
    text +=
        "\n[[law]]\nbetween = [\"" + name(pair.a) + "\", \"" + name(pair.b) + "\"]\n" + law_lines(pair.law);
  }
  if (setting.cells != 1) text += mesh_lines(changed_scene);
  return text;
}

}  // namespace halfspace::cli
