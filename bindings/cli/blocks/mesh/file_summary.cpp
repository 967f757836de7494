#include "blocks/mesh/file_summary.h"

#include <algorithm>

#include "common/text.h"

namespace halfspace::cli {
namespace {

/// Max number of faulty blocks that are listed one by one.
constexpr std::size_t listed = 20;

std::string counted(std::size_t count, const std::string& what) {
  return std::to_string(count) + ' ' + what + (count == 1 ? "" : "s");
}

}  // namespace

void FileSummary::add(const Solid& solid, const hs_fit_report& report) {
  if (is_inside_out(solid) && ++inside_out_ == 1) first_inside_out_ = solid.place;
  if (!(report.moved > 0)) return;
  ++fitted_;
  merged_ += report.merged;
  deviation_ = std::max(deviation_, report.deviation);
  if (report.moved <= moved_) return;
  moved_ = report.moved;
  farthest_moved_ = solid.place;
}

void FileSummary::add(const MeshFault& fault) {
  if (++faulty_ <= listed) faults_.emplace_back(fault.what());
}

void FileSummary::add(const NotConvex& fault) {
  add(static_cast<const MeshFault&>(fault));
  sufficient_ = std::max(sufficient_, fault.sufficient_tolerance);
}

std::vector<std::string> FileSummary::faults() const {
  std::vector<std::string> all = faults_;
  if (faulty_ < 2) return all;
  std::string text = counted(faulty_, "faulty block") + " in the file";
  if (faulty_ > listed) text += ", the first " + std::to_string(listed) + " of them above";
  if (sufficient_ > 0)
    text += "; tolerance = " + rounded(sufficient_, 2) + " accepts every dent that a tolerance can";
  all.push_back(text);
  return all;
}

std::vector<std::string> FileSummary::notes() const {
  std::vector<std::string> all;
  if (inside_out_ > 0)
    all.push_back(first_inside_out_ + ": " + counted(inside_out_, "surface") +
                  " inside out: reversed; usual: faces counter-clockwise seen from outside");
  if (fitted_ > 0)
    all.push_back(farthest_moved_ + ": planes fitted to " + counted(fitted_, "block") + ": " +
                  std::to_string(merged_) + " facets merged, vertices up to " + rounded(deviation_, 2) +
                  " m off their planes, corners moved by up to " + rounded(moved_, 2) +
                  " m; usual: a file with more digits");
  if (flush_ > 0)
    all.push_back("joints made flush: " + counted(static_cast<std::size_t>(flush_), "face") +
                  " moved onto the common plane of its joint; usual: a file with more digits");
  return all;
}

}  // namespace halfspace::cli
