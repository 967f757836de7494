#pragma once

#include <optional>
#include <string>

#include "model.h"
#include "scene.h"

namespace halfspace::cli {

/// The places of the knobs that trade accuracy for time. Knobs without one stand as in the scene.
struct Setting {
  double step = 0.5;                   ///< share of the stable time step, or of the scene's own
  double stiffness = 1;                ///< times the scene's
  double cells = 1;                    ///< of meshes that the scene has cut: times as many along each length
  std::optional<int> law = {};         ///< stiffness kind, of equal stiffness for faces of the typical size
  std::optional<int> kind = {};        ///< of all blocks that move freely
  std::optional<double> damping = {};  ///< of all contacts, share of the critical one
  std::optional<double> skin = {};     ///< reach of the neighbour list, share of a block's size
  int disturbance = 0;                 ///< the number of a start disturbed by 1e-9 of a block's size; 0: none

  bool operator==(const Setting&) const = default;
};

/// The sizes that turn a stiffness of one kind into the unit of another.
struct FaceSize {
  double area = 1;              ///< mean of all faces of free blocks; in the plane the length of their edges
  double potential_length = 1;  ///< that the scene's potentials refer to; without any, that theirs would
  double stiffness = 0;         ///< N/m, of a layer of cells behind it; 0 where nothing is elastic
};

/// The typical face of the blocks of a scene.
FaceSize typical_face(const Context& context, const Scene& scene, const Model& model);

/// Do springs or elements tell a stable time step? Without, steps are shares of the scene's own.
bool tells_stable_step(const Scene& scene);

/// The scene with its knobs turned.
Scene turned(Scene scene, const Setting& setting, const FaceSize& face);

/// Are there meshes that the scene has cut, so that it could cut them otherwise?
bool has_cut_meshes(const Scene& scene);

/// Moves each block or mesh that is free by a random way of up to 1e-9 of its size.
void disturb(const Context& context, int number, Layout& layout);

/// The names of a law and of a kind of blocks, as scene files have them.
std::string name_of_law(int stiffness_kind);
const char* name_of_kind(int kind);

/// The lines of a scene file that turn its knobs.
std::string scene_lines(const Setting& setting, const Scene& scene, const FaceSize& face);

}  // namespace halfspace::cli
