#pragma once

#include <string>
#include <vector>

#include "files.h"
#include "model.h"

namespace halfspace::cli {

/// One frame as VTK XML PolyData: a polygon per block, with its motion as cell data.
std::string vtk_polygons(const Frame& frame, const Frame& start);

/// The frames of a run for ParaView: frames/frame_0000.vtp, ... and run.pvd, which gives their times.
class VtkSeries {
 public:
  explicit VtkSeries(OutputDirectory& directory) : directory_(directory) {}
  void add(const Frame& frame, const Frame& start);

 private:
  OutputDirectory& directory_;
  std::string entries_;
  int count_ = 0;
};

}  // namespace halfspace::cli
