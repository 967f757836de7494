#pragma once

#include <string>
#include <vector>

#include "blocks/mesh/convex_solid.h"

namespace halfspace::cli {

/// The faults of all blocks of a file, and the changes that made them convex.
class FileSummary {
 public:
  void add(const Solid& solid, const hs_fit_report& report);
  void add(const MeshFault& fault);
  void add(const NotConvex& fault);
  /// Adds faces that were moved onto the plane of a neighbour's face.
  void add_flush_faces(int count) { flush_ += count; }

  /// A text for each of the first faulty blocks, and one for all.
  std::vector<std::string> faults() const;
  std::vector<std::string> notes() const;

 private:
  std::size_t faulty_ = 0;
  std::vector<std::string> faults_;
  double sufficient_ = 0;  // m, sufficient for every dent that some tolerance accepts
  std::size_t inside_out_ = 0;
  std::string first_inside_out_;
  std::size_t fitted_ = 0;
  std::int64_t merged_ = 0;
  double moved_ = 0;
  double deviation_ = 0;
  std::string farthest_moved_;
  int flush_ = 0;
};

}  // namespace halfspace::cli
