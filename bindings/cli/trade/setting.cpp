#include "trade/setting.h"

#include <algorithm>
#include <cmath>

#include "random.h"
#include "read_values.h"
#include "text.h"
#include "vector.h"

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

/// The factor from a stiffness of one kind to that of a whole face that meets another one, in N/m. Two faces
/// that meet squarely are pushed apart by potentials as by 2 k / H of stiffness per area.
double per_face(int kind, double area, double potential_length) {
  switch (kind) {
    case HS_STIFFNESS_PER_AREA:
      return area;
    case HS_STIFFNESS_POTENTIAL:
      return 2 * area / potential_length;
    default:
      return 1;
  }
}

/// The shear spring of potentials is one per contact, as their friction is.
double shear_per_face(int kind, double area) { return kind == HS_STIFFNESS_PER_AREA ? area : 1; }

void change_kind(hs_law_def& law, int kind, const FaceSize& face) {
  if (kind == law.stiffness_kind) return;
  const double shear = law.shear_stiffness > 0 ? law.shear_stiffness : law.normal_stiffness;
  const double normal_of_face =
      law.normal_stiffness * per_face(law.stiffness_kind, face.area, face.potential_length);
  const double shear_of_face = shear * shear_per_face(law.stiffness_kind, face.area);
  law.stiffness_kind = kind;
  law.normal_stiffness = normal_of_face / per_face(kind, face.area, face.potential_length);
  law.shear_stiffness = shear_of_face / shear_per_face(kind, face.area);
  if (kind == HS_STIFFNESS_POTENTIAL) law.cohesion = law.tensile_strength = 0;
}

void turn(hs_law_def& law, const Setting& setting, const FaceSize& face) {
  law.normal_stiffness *= setting.stiffness;
  law.shear_stiffness *= setting.stiffness;
  if (setting.law) change_kind(law, *setting.law, face);
  if (setting.damping) law.normal_damping = law.shear_damping = *setting.damping;
}

void set_kind(Scene& scene, int kind) {
  for_each_making(scene, [&](Making& making) {
    if (moves_freely(making.kind)) making.kind = kind;
    if (kind != HS_BLOCK_AFFINE) making.stress.reset();
  });
}

std::string law_lines(const hs_law_def& law) {
  if (law.stiffness_kind == HS_STIFFNESS_NONE)
    return "stiffness = \"" + name_of_law(law.stiffness_kind) + "\"\n";
  return "stiffness = \"" + name_of_law(law.stiffness_kind) +
         "\"\nnormal_stiffness = " + rounded(law.normal_stiffness, 6) +
         "\nshear_stiffness = " + rounded(law.shear_stiffness, 6) +
         "\nnormal_damping = " + shortest(law.normal_damping) +
         "\nshear_damping = " + shortest(law.shear_damping) + '\n';
}

bool knows_potential(const Scene& scene) {
  return any_law(scene, [](const hs_law_def& law) { return law.stiffness_kind == HS_STIFFNESS_POTENTIAL; });
}

class Mean {
 public:
  void add(double sum, double count) {
    sum_ += sum;
    count_ += count;
  }
  double value() const { return count_ > 0 ? sum_ / count_ : 1; }

 private:
  double sum_ = 0, count_ = 0;
};

}  // namespace

FaceSize typical_face(const Context& context, const Scene& scene, const Model& model) {
  Mean faces, edges;
  for (const LayoutBlock& block : model.layout().blocks) {
    if (!moves_freely(block.kind)) continue;
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
  return face;
}

Scene turned(Scene scene, const Setting& setting, const FaceSize& face) {
  hs_world_def& world = scene.world;
  world.time_step = 0;
  world.safety = setting.step;
  if (setting.skin) world.skin = *setting.skin;
  world.potential_length = face.potential_length;
  turn(scene.default_law, setting, face);
  for (PairLaw& pair : scene.laws) turn(pair.law, setting, face);
  if (setting.kind) set_kind(scene, *setting.kind);
  return scene;
}

void disturb(const Context& context, int number, Layout& layout) {
  if (number == 0) return;
  Random random(static_cast<std::uint64_t>(number));
  for (LayoutBlock& block : layout.blocks) {
    if (!moves_freely(block.kind)) continue;
    const double size = properties_of(context, block.shape).bounding_radius;
    for (std::size_t axis = 0; axis < static_cast<std::size_t>(layout.dimension); ++axis)
      block.placing.shift[axis] += 1e-9 * size * (2 * random.uniform() - 1);
  }
}

std::string name_of_law(int stiffness_kind) {
  return std::string(law_names[static_cast<std::size_t>(stiffness_kind)]);
}

const char* name_of_kind(int kind) { return kind == HS_BLOCK_AFFINE ? "affine" : "rigid"; }

std::string scene_lines(const Setting& setting, const Scene& scene, const FaceSize& face) {
  const Scene turned_scene = turned(scene, setting, face);
  std::string text = "[world]  # and no time_step\nsafety = " + shortest(setting.step) + '\n';
  if (setting.skin) text += "skin = " + shortest(*setting.skin) + '\n';
  if (knows_potential(turned_scene)) text += "potential_length = " + rounded(face.potential_length, 6) + '\n';
  text += "\n[default_law]\n" + law_lines(turned_scene.default_law);
  for (const PairLaw& pair : turned_scene.laws) {
    const auto name = [&](int material) { return scene.materials[static_cast<std::size_t>(material)].name; };
    text +=
        "\n[[law]]\nbetween = [\"" + name(pair.a) + "\", \"" + name(pair.b) + "\"]\n" + law_lines(pair.law);
  }
  return text;
}

}  // namespace halfspace::cli
