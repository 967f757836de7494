#pragma once

#include <string>

#include "common/archive.h"
#include "common/files.h"
#include "model/model.h"

namespace halfspace::cli {

/// Consecutive blocks of a layout.
struct BlockRange {
  std::size_t begin = 0;
  std::size_t end = 0;
};

/// Blocks of a frame as VTK XML PolyData: the faces of each block (in 2D the block itself), with its motion
/// as cell data.
std::string vtk_polygons(const Layout& layout, const Frame& frame, const Frame& start, BlockRange blocks);

/// The contacts of a frame as points of VTK XML PolyData, at the points of application, with force, normal
/// and gap.
std::string vtk_contacts(const Frame& frame);

/// The bolts of a frame as lines of VTK XML PolyData, with tension and elongation.
std::string vtk_bolts(const Frame& frame);

/// The water table of a frame as VTK XML PolyData over the extent of the blocks: a line in 2D, a polygon in
/// 3D.
std::string vtk_water(int dimension, const Frame& frame);

/// The frames of a run for ParaView: frames/frame_0000.vtp, ... and run.pvd, which gives their times; with
/// contacts also frames/contacts_0000.vtp, ... and contacts.pvd, and likewise with bolts and water. Terrains
/// are in terrain.pvd, with a file where triangles have been excavated since the last one.
class VtkSeries {
 public:
  VtkSeries(const Layout& layout, const Scene& scene, OutputDirectory& directory)
      : layout_(layout), scene_(scene), directory_(directory) {}
  void add(const Frame& frame, const Frame& start);
  /// After reading, earlier frames are listed only if they are in the directory.
  void add_to(Archive& archive, bool has_frames);
  int count() const { return count_; }

 private:
  const Layout& layout_;
  const Scene& scene_;
  OutputDirectory& directory_;
  std::string entries_;
  std::string contact_entries_;
  std::string bolt_entries_;
  std::string water_entries_;
  std::string terrain_entries_;
  std::size_t terrain_left_ = 0;  ///< triangles in the last file
  int count_ = 0;
};

}  // namespace halfspace::cli
