#pragma once

#include <string>
#include <vector>

#include "files.h"
#include "model.h"

namespace halfspace::cli {

/// One frame as VTK XML PolyData: the faces of each block (in 2D the block itself is the one), with its
/// motion as cell data.
std::string vtk_polygons(const Layout& layout, const Frame& frame, const Frame& start);

/// The frames of a run for ParaView: frames/frame_0000.vtp, ... and run.pvd, which gives their times.
class VtkSeries {
 public:
  VtkSeries(const Layout& layout, OutputDirectory& directory) : layout_(layout), directory_(directory) {}
  void add(const Frame& frame, const Frame& start);

 private:
  const Layout& layout_;
  OutputDirectory& directory_;
  std::string entries_;
  int count_ = 0;
};

}  // namespace halfspace::cli
