#include "force/division_planner.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace halfspace {
namespace {

/// Corners nearer to each other than this share of the blocks' size are one.
constexpr double one_place = 0x1p-40;
/// So far at least the planes that tell where a corner is are from meeting in a line: the volume that their
/// normals span.
constexpr double least_span = 1e-6;
/// By so much, as a share of the whole, may the volumes of the solids be off from what they have been found
/// to be.
constexpr double volume_error = 1e-9;
/// Those included that turn out to be none.
constexpr std::size_t most_corners = most_division_crossings;

template <class Visit>
void for_each(std::uint64_t set, Visit visit) {
  for (; set != 0; set &= set - 1) visit(std::countr_zero(set));
}

bool holds(std::uint64_t set, int element) { return set >> element & 1; }

double least_depth_behind(const Array<NearFace>& faces, const Vector<3>& at) {
  double least = HUGE_VAL;
  for (const NearFace& face : faces) least = std::min(least, face.plane.depth(at));
  return least;
}

/// Planes that may tell where a corner is, by faces or by pairs of them: the first ones of too many.
class PlanesOfCorner {
 public:
  void add(const std::array<PlanCode, 2>& faces, const Vector<3>& normal, double depth) {
    if (count_ == faces_.size()) return;
    faces_[count_] = faces;
    depth_[count_] = depth;
    normal_[count_++] = normal;
  }

  /// By the three that are farthest from meeting in a line. False when all but do.
  bool locate(Vector<3>& at, std::array<std::array<PlanCode, 2>, 3>& faces) const {
    double largest = 0;
    Vector<3> to_planes = Vector<3>::Zero();
    for (std::size_t i = 0; i < count_; ++i)
      for (std::size_t j = i + 1; j < count_; ++j) {
        const Vector<3> along = cross_product(normal_[i], normal_[j]);
        for (std::size_t k = j + 1; k < count_; ++k) {
          const double span = along.dot(normal_[k]);
          if (std::abs(span) <= largest) continue;
          largest = std::abs(span);
          faces = {faces_[i], faces_[j], faces_[k]};
          to_planes = (depth_[k] * along + depth_[i] * cross_product(normal_[j], normal_[k]) +
                       depth_[j] * cross_product(normal_[k], normal_[i])) /
                      span;
        }
      }
    at += to_planes;
    return largest > least_span;
  }

 private:
  std::array<std::array<PlanCode, 2>, 16> faces_;
  std::array<Vector<3>, 16> normal_;
  std::array<double, 16> depth_;  // of the place where the corner was thought to be
  std::size_t count_ = 0;
};

}  // namespace

void DivisionPlanner::reserve() {
  corners_.reserve(most_corners);
  for (Array<NearFace>& near : near_) near.reserve(2 * most_plan_faces);
  facets_.reserve(3 * most_plan_faces);
  plan_.reserve(most_plan_codes);
}

void DivisionPlanner::begin(const PlacedBlock& a, const PlacedBlock& b, const VolumeAndMoment& content) {
  block_[0].emplace(a);
  block_[1].emplace(b);
  volume_ = content.volume;
  const auto largest_offset = [](const Outline<3>& outline) {
    return *std::max_element(outline.offset, outline.offset + outline.face_count());
  };
  size_ = plan_size(b.at - a.at, std::max(largest_offset(a.outline), largest_offset(b.outline)));
  corners_.clear();
  is_too_large_ = std::max(a.outline.face_count(), b.outline.face_count()) > most_faces_to_plan;
}

/// Among those before it, as a shared one or as one of the same cells.
bool DivisionPlanner::is_known(const Corner& corner, std::size_t before) const {
  const double reach = one_place * size_;
  return std::any_of(corners_.begin(), corners_.begin() + std::ptrdiff_t(before), [&](const Corner& known) {
    return (is_shared(known) || known.kind == corner.kind) &&
           (known.at - corner.at).squaredNorm() <= reach * reach;
  });
}

void DivisionPlanner::add_corner(const Vector<3>& at, Kind kind) {
  is_too_large_ |= corners_.size() == most_corners;
  if (is_too_large_) return;
  Corner corner{};
  corner.at = at;
  corner.kind = kind;
  if (!is_known(corner, corners_.size())) corners_.push_back(corner);
}

/// Only faces that the depths at the corners leave in question matter.
void DivisionPlanner::add_cells(int owner, const Array<NearFace>& near, const Array<double>& least_depth,
                                const Array<Vector<3>>& places) {
  is_too_large_ |= near.size() > 2 * most_plan_faces || places.size() >= most_corners;
  if (is_too_large_) return;
  for (const Vector<3>& at : places) add_corner(at, of_cells(owner));
  double reach = 0;
  for (const Corner& corner : corners_) {
    if (is_of_cells(owner, corner)) reach = std::max(reach, least_depth_behind(near, corner.at));
  }
  near_[owner].clear();
  const double margin = plan_rounding_followed * size_;
  for (const NearFace& face : near)
    if (least_depth[std::size_t(face.face)] <= reach + margin) near_[owner].push_back(face);
  is_too_large_ |= near_[owner].size() > most_plan_faces;
}

void DivisionPlanner::find_faces(Corner& corner) const {
  const double rounding = plan_rounding_made * size_;
  for (int owner = 0; owner < 2; ++owner) {
    const double least = least_depth_behind(near_[owner], corner.at);
    corner.on[owner] = corner.nearest[owner] = 0;
    for (int f = 0; f < near_count(owner); ++f) {
      const double depth = plane(owner, f).depth(corner.at);
      corner.on[owner] |= Set(depth <= rounding) << f;
      corner.nearest[owner] |= Set(depth <= least + rounding) << f;
    }
  }
}

/// As who follows the plan finds it, too.
void DivisionPlanner::measure_size() {
  double largest = 0;
  for (int owner = 0; owner < 2; ++owner)
    for (const NearFace& face : near_[owner])
      largest = std::max(largest, block_[owner]->outline.offset[face.face]);
  size_ = plan_size(block_[1]->at - block_[0]->at, largest);
}

bool DivisionPlanner::is_vertex_of(int owner, Corner& corner) const {
  if (std::popcount(corner.on[owner]) < 3) return false;
  const Outline<3>& outline = block_[owner]->outline;
  const Vector<3> at = corner.at - block_[owner]->at;
  const double rounding = plan_rounding_made * size_;
  for (std::int32_t v = 0; v < outline.vertex_count(); ++v) {
    if ((outline.vertex(v) - at).squaredNorm() > rounding * rounding) continue;
    corner.vertex = v;
    corner.kind = owner == 0 ? vertex_of_a : vertex_of_b;
    return true;
  }
  return false;
}

bool DivisionPlanner::locate_by_faces(Corner& corner) const {
  const int nothing = near_count(0) + near_count(1);
  PlanesOfCorner candidates;
  for (int owner = 0; owner < 2; ++owner) {
    const int first = owner == 0 ? 0 : near_count(0);
    for_each(corner.on[owner], [&](int f) {
      candidates.add({PlanCode(first + f), PlanCode(nothing)}, plane(owner, f).normal,
                     plane(owner, f).depth(corner.at));
    });
    if (corner.kind != of_cells(owner)) continue;
    const int one = std::countr_zero(corner.nearest[owner]);
    for_each(corner.nearest[owner] & (corner.nearest[owner] - 1), [&](int f) {
      candidates.add({PlanCode(first + one), PlanCode(first + f)},
                     plane(owner, one).normal - plane(owner, f).normal,
                     plane(owner, one).depth(corner.at) - plane(owner, f).depth(corner.at));
    });
  }
  return candidates.locate(corner.at, corner.faces);
}

/// Who follows the plan looks at the depths behind the owner's faces only: the other block's have to be among
/// those that tell where a corner of cells is.
bool DivisionPlanner::is_told_by_faces_of_other(const Corner& corner) const {
  const int other = corner.kind == of_cells_of_a ? 1 : 0, first = other == 0 ? 0 : near_count(0);
  Set told = 0;
  for (const FacePair& faces : corner.faces)
    if (faces[0] >= first && faces[0] < first + near_count(other)) told |= Set(1) << (faces[0] - first);
  return (corner.on[other] & ~told) == 0;
}

/// A place where planes between faces cross what was but an edge of a part on the way is no corner.
bool DivisionPlanner::locate(Corner& corner) const {
  switch (corner.kind) {
    case shared:
      return is_vertex_of(0, corner) || is_vertex_of(1, corner) || locate_by_faces(corner);
    case of_cells_of_a:
    case of_cells_of_b:
      if (locate_by_faces(corner)) return is_told_by_faces_of_other(corner);
      corner.kind = none;
      return true;
    default:
      return true;
  }
}

/// In the order of their numbers. False when there are too many.
bool DivisionPlanner::sort_corners() {
  std::sort(corners_.begin(), corners_.end(),
            [](const Corner& p, const Corner& q) { return p.kind < q.kind; });
  while (!corners_.empty() && corners_.back().kind == none) corners_.pop_back();
  const int common = count(vertex_of_a) + count(vertex_of_b) + count(shared);
  return common + std::max(count(of_cells_of_a), count(of_cells_of_b)) <= most_plan_corners;
}

int DivisionPlanner::count(Kind kind) const {
  return int(std::count_if(corners_.begin(), corners_.end(),
                           [kind](const Corner& corner) { return corner.kind == kind; }));
}

void DivisionPlanner::put(std::initializer_list<int> codes) {
  is_too_large_ |= plan_.size() + codes.size() > most_plan_codes;
  if (is_too_large_) return;
  for (const int code : codes) plan_.push_back(PlanCode(code));
}

void DivisionPlanner::put_shared_corners() {
  for (const Kind kind : {vertex_of_a, vertex_of_b, shared}) {
    put({count(kind)});
    for (const Corner& corner : corners_) {
      if (corner.kind != kind) continue;
      if (kind == shared) {
        put({corner.faces[0][0], corner.faces[1][0], corner.faces[2][0]});
      } else {
        put({corner.vertex});
      }
    }
  }
}

template <class FacesOf>
void DivisionPlanner::put_faces_of_corners(Set corners, FacesOf faces_of) {
  const std::size_t at = plan_.size();
  put({0});
  for_each(corners, [&](int c) {
    for_each(faces_of(corner(c)), [&](int f) {
      put({c, f});
      if (!is_too_large_) ++plan_[at];
    });
  });
}

template <class Has>
DivisionPlanner::Set DivisionPlanner::corners_with(Has has) const {
  Set set = 0;
  const int corners = std::min(int(corners_.size()), most_plan_corners);
  for (int c = 0; c < corners; ++c) set |= Set(has(corner(c))) << c;
  return set;
}

/// One that has all corners of another takes its place: where faces of both blocks lie in one plane.
void DivisionPlanner::add_facet(Set corners, const Vector<3>& outward) {
  if (std::popcount(corners) < 3) return;
  for (Facet& facet : facets_) {
    if ((corners & ~facet.corners) == 0) return;
    if ((facet.corners & ~corners) != 0) continue;
    facet = {outward, corners, {}};
    return;
  }
  facets_.push_back({outward, corners, {}});
}

/// Those that lie in the blocks' own faces.
void DivisionPlanner::find_facets(Set corners) {
  facets_.clear();
  for (int owner = 0; owner < 2; ++owner)
    for (int f = 0; f < near_count(owner); ++f)
      add_facet(corners & corners_with([&](const Corner& c) { return holds(c.on[owner], f); }),
                plane(owner, f).normal);
}

void DivisionPlanner::go_around(Facet& facet) const {
  Vector<3> center = Vector<3>::Zero();
  for_each(facet.corners, [&](int c) { center += corner(c).at / std::popcount(facet.corners); });
  const Vector<3> normal = facet.outward.normalized();
  Vector<3> axis = Vector<3>::Zero();
  axis[std::abs(normal.x()) < 0.5 ? 0 : 1] = 1;
  const Vector<3> u = cross_product(normal, axis).normalized(), w = cross_product(normal, u);
  std::array<double, most_plan_corners> angle;
  auto end = facet.around.begin();
  for_each(facet.corners, [&](int c) {
    const Vector<3> arm = corner(c).at - center;
    angle[std::size_t(c)] = std::atan2(w.dot(arm), u.dot(arm));
    *end++ = std::uint8_t(c);
  });
  std::sort(facet.around.begin(), end,
            [&](int c, int d) { return angle[std::size_t(c)] < angle[std::size_t(d)]; });
}

/// Along each edge there are two facets, one on either side.
bool DivisionPlanner::is_closed() const {
  std::array<Set, most_plan_corners> to{}, from{};
  for (const Facet& facet : facets_) {
    const std::size_t count = std::size_t(std::popcount(facet.corners));
    for (std::size_t i = 0; i < count; ++i) {
      const int c = facet.around[i], d = facet.around[(i + 1) % count];
      if (holds(to[std::size_t(c)], d)) return false;
      to[std::size_t(c)] |= Set(1) << d;
      from[std::size_t(d)] |= Set(1) << c;
    }
  }
  return to == from;
}

void DivisionPlanner::put_fan(const Facet& facet, int top, double& volume) {
  const std::size_t count = std::size_t(std::popcount(facet.corners));
  put({int(count) - 2});
  for (std::size_t i = 0; i < count; ++i) put({facet.around[i]});
  const auto seen_from_top = [&](std::size_t i) {
    return Vector<3>(corner(facet.around[i]).at - corner(top).at);
  };
  for (std::size_t i = 1; i + 1 < count; ++i)
    volume += seen_from_top(0).dot(cross_product(seen_from_top(i), seen_from_top(i + 1))) / 6;
}

/// The fewest tetrahedra are those with a corner in most facets. False when corners are missing, or facets,
/// or the volume.
bool DivisionPlanner::put_solid(double expected) {
  for (Facet& facet : facets_) go_around(facet);
  if (!is_closed()) return false;
  std::array<int, most_plan_corners> facets_at{};
  for (const Facet& facet : facets_) for_each(facet.corners, [&](int c) { ++facets_at[std::size_t(c)]; });
  const int top = int(std::max_element(facets_at.begin(), facets_at.end()) - facets_at.begin());
  put({top});
  double volume = 0;
  for (const Facet& facet : facets_)
    if (!holds(facet.corners, top)) put_fan(facet, top, volume);
  put({0});
  return std::abs(volume - expected) <= volume_error * volume_;
}

bool DivisionPlanner::put_cells(int owner) {
  const Set corners = corners_with([&](const Corner& c) { return is_of_cells(owner, c); });
  put({count(of_cells(owner))});
  for (const Corner& corner : corners_) {
    if (corner.kind != of_cells(owner)) continue;
    for (const FacePair& faces : corner.faces) put({faces[0], faces[1]});
  }
  put_faces_of_corners(corners, [&](const Corner& c) { return c.nearest[owner]; });
  put_faces_of_corners(corners, [&](const Corner& c) { return c.on[owner]; });
  const std::size_t at = plan_.size();
  put({0});
  for (int f = 0; f < near_count(owner); ++f) {
    const double volume = near_[owner][std::size_t(f)].cell.volume;
    if (volume == 0) continue;
    const auto with = [&](int face) {
      return corners & corners_with([&](const Corner& c) { return holds(c.nearest[owner], face); });
    };
    const Set of_cell = with(f);
    find_facets(of_cell);
    for (int other = 0; other < near_count(owner); ++other)
      if (other != f) add_facet(of_cell & with(other), plane(owner, other).normal - plane(owner, f).normal);
    put({f});
    if (!put_solid(volume) || is_too_large_) return false;
    ++plan_[at];
  }
  return true;
}

std::span<const PlanCode> DivisionPlanner::make() {
  plan_.clear();
  if (is_too_large_) return {};
  measure_size();
  for (std::size_t c = 0; c < corners_.size(); ++c) {
    Corner& corner = corners_[c];
    // Cutting has rounded its place: its faces tell better where it is, and from there which these are.
    find_faces(corner);
    locate(corner);
    find_faces(corner);
    if (!locate(corner)) return {};
    if (is_known(corner, c)) corner.kind = none;
  }
  if (!sort_corners()) return {};
  for (const Array<NearFace>& near : near_) {
    put({int(near.size())});
    for (const NearFace& face : near) put({face.face});
  }
  put_shared_corners();
  find_facets(corners_with(is_shared));
  if (!put_solid(volume_) || !put_cells(0)) return {};
  // Those of b have the numbers that those of a have had.
  std::erase_if(corners_, [](const Corner& corner) { return corner.kind == of_cells_of_a; });
  const bool is_whole = put_cells(1) && !is_too_large_;
  return is_whole ? std::span<const PlanCode>(plan_) : std::span<const PlanCode>();
}

}  // namespace halfspace
