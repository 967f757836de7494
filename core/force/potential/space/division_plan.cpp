#include "force/potential/space/division_plan.h"

#include <algorithm>
#include <initializer_list>

namespace halfspace {
namespace {

/// Reads codes with any values. is_right() becomes false at the first code that is not below its limit.
class PlanCheck {
 public:
  explicit PlanCheck(std::span<const PlanCode> plan) : rest_(plan) {}

  bool is_right() const { return is_right_; }
  bool is_over() const { return rest_.empty(); }

  int take(int end) {
    if (rest_.empty() || rest_[0] < 0 || rest_[0] >= end) is_right_ = false;
    if (!is_right_) return 0;
    const int code = rest_[0];
    rest_ = rest_.subspan(1);
    return code;
  }
  int count() { return take(INT16_MAX); }

  /// Returns the length of the list.
  int take_list(std::initializer_list<int> ends_of_each) {
    const int listed = count();
    for (int n = 0; n < listed && is_right_; ++n)
      for (const int end : ends_of_each) take(end);
    return listed;
  }

  int take_faces(const Outline<3>& block) {
    for (int f = 0; f < block.face_count() && is_right_; f += 4) take(16);
    return take_list({block.face_count()});
  }

  void take_depths(int faces, int corners) {
    for (int n = count(); n > 0 && is_right_; --n) {
      const int depth = take(plan_depth(faces, 0));
      if (corner_of_plan_depth(depth) >= corners) is_right_ = false;
    }
  }

  void take_tetrahedra(std::initializer_list<int> ends_of_each) {
    if (take_list(ends_of_each) % 4 != 0) is_right_ = false;
  }

 private:
  std::span<const PlanCode> rest_;
  bool is_right_ = true;
};

}  // namespace

bool is_plan(std::span<const PlanCode> plan, const Outline<3>& a, const Outline<3>& b) {
  if (std::max(a.face_count(), b.face_count()) > most_faces_to_plan) return false;
  PlanCheck check(plan);
  const int faces[2] = {check.take_faces(a), check.take_faces(b)};
  if (std::min(faces[0], faces[1]) < 1 || std::max(faces[0], faces[1]) > most_plan_faces) return false;
  const int of_both = faces[0] + faces[1], between = check.take_list({of_both, of_both});
  const int planes = of_both + between;
  int corners = check.take_list({a.vertex_count()});
  corners += check.take_list({b.vertex_count()});
  corners += check.take_list({planes, planes, planes});
  if (between > most_planes_between || corners < 1 || corners > most_plan_corners) return false;
  check.take(corners);
  check.take_tetrahedra({corners, corners, corners});
  for (const int of_owner : faces) {
    check.take_depths(of_owner, corners);
    check.take_depths(of_owner, corners);
    const int cells = check.take(of_owner + 1);
    check.take_tetrahedra({cells, corners, corners, corners, corners});
  }
  return check.is_right() && check.is_over();
}

}  // namespace halfspace
