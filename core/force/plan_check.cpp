#include <algorithm>

#include "force/planned_force.h"

namespace halfspace {
namespace {

/// Walks through numbers that may be any. What it takes is below what is said, or all is wrong from there on.
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

  /// Returns how many of them there are.
  int take_list(std::initializer_list<int> ends_of_each) {
    const int listed = count();
    for (int n = 0; n < listed && is_right_; ++n)
      for (const int end : ends_of_each) take(end);
    return listed;
  }

  void take_solid(int corners) {
    take(corners);
    for (int triangles = count(); triangles > 0 && is_right_; triangles = count())
      for (int n = 0; n < triangles + 2 && is_right_; ++n) take(corners);
  }

 private:
  std::span<const PlanCode> rest_;
  bool is_right_ = true;
};

}  // namespace

bool is_plan(std::span<const PlanCode> plan, const Outline<3>& a, const Outline<3>& b) {
  if (std::max(a.face_count(), b.face_count()) > most_faces_to_plan) return false;
  PlanCheck check(plan);
  const int faces[2] = {check.take_list({a.face_count()}), check.take_list({b.face_count()})};
  if (std::min(faces[0], faces[1]) < 1 || std::max(faces[0], faces[1]) > most_plan_faces) return false;
  const int face_or_none = faces[0] + faces[1] + 1;
  int shared = check.take_list({a.vertex_count()});
  shared += check.take_list({b.vertex_count()});
  shared += check.take_list({face_or_none, face_or_none, face_or_none});
  if (shared < 1 || shared > most_plan_corners) return false;
  check.take_solid(shared);
  for (const int of_owner : faces) {
    const int corners = shared + check.take_list({face_or_none, face_or_none, face_or_none, face_or_none,
                                                  face_or_none, face_or_none});
    if (corners > most_plan_corners) return false;
    check.take_list({corners, of_owner});
    check.take_list({corners, of_owner});
    const int cells = check.count();
    for (int n = 0; n < cells && check.is_right(); ++n) {
      check.take(of_owner);
      check.take_solid(corners);
    }
  }
  return check.is_right() && check.is_over();
}

}  // namespace halfspace
