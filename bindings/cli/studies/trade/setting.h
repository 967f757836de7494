#pragma once

#include <optional>
#include <string>

#include "model/model.h"
#include "scene/scene.h"

namespace halfspace::cli {

/// The values of the parameters that trade accuracy for time. Without a value, a parameter is that of the
/// scene.
struct Setting {
  double step = 0.5;             ///< fraction of the largest one, see largest_step()
  double stiffness = 1;          ///< times the scene's
  double cells = 1;              ///< factor of the cells along each length, of meshes that the scene makes
  std::optional<int> law = {};   ///< stiffness kind, of equal stiffness for faces of the typical size
  std::optional<int> kind = {};  ///< of all blocks that move freely
  std::optional<double> damping = {};    ///< of all contacts, fraction of the critical one
  std::optional<double> skin = {};       ///< of the neighbour list, fraction of a block's size
  std::optional<double> tolerance = {};  ///< of impulses
  int disturbance = 0;                   ///< number of a start disturbed by 1e-9 of a block's size; 0: none

  bool operator==(const Setting&) const = default;
};

/// The sizes for the conversion of stiffnesses between laws.
struct FaceSize {
  double area = 1;              ///< m2, mean of the faces of free blocks; 2D: m, of their edges
  double potential_length = 1;  ///< m, of the scene's potentials, or their default
  double stiffness = 0;         ///< N/m, of a layer of cells behind the face; 0 without elasticity
};

/// The typical face of the blocks of a scene.
FaceSize typical_face(const Context& context, const Scene& scene, const Model& model);

/// True if springs or elements determine a stable time step.
bool has_stable_step(const Scene& scene);

/// The step of which settings have fractions, s, where none is stable: the scene's own, or 1/60 s where the
/// scene's law has springs and the setting's has none.
double largest_step(const Scene& scene);

/// True for a block that no setting deforms: one that is held along axes, or concave.
bool stays_rigid(const Block& block, int dimension);

/// The scene with a setting.
Scene with_setting(Scene scene, const Setting& setting, const FaceSize& face);

/// True if the scene makes meshes itself, so that their number of cells can change.
bool has_cut_meshes(const Scene& scene);

/// Displaces each free block or mesh at random by up to 1e-9 of its size.
void disturb(const Context& context, int number, Layout& layout);

/// The names of a law and of a kind of blocks, as in scene files.
std::string name_of_law(int stiffness_kind);
const char* name_of_kind(int kind);

/// The lines of a scene file for a setting.
std::string scene_lines(const Setting& setting, const Scene& scene, const FaceSize& face);

}  // namespace halfspace::cli
