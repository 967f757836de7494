#pragma once

#include <string>
#include <vector>

#include "mesh/convex_solid.h"

namespace halfspace::cli {

/// The faults of all blocks of a file, and the changes that made them convex.
class FileSummary {
 public:
  void add(const Solid& solid, const hs_fit_report& report);
  void add(const MeshFault& fault);
  void add(const NotConvex& fault);
  /// So many faces were moved onto a plane that they share with a neighbour's.
  void add_flush_faces(int count) { flush_ += count; }

  /// One for each faulty block of the first ones, and one for all others.
  std::vector<std::string> faults() const;
  std::vector<std::string> notes() const;

 private:
  std::size_t faulty_ = 0;
  std::vector<std::string> faults_;
  double sufficient_ = 0;  // m, of all dents that some tolerance takes
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
