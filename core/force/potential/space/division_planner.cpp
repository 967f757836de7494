#include "force/potential/space/division_planner.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace halfspace {
namespace {

/// Corners nearer to each other than this share of the blocks' size are one.
constexpr double one_place = 0x1p-36;
/// Faces are turned by less than this when they all but agree.
constexpr double least_turn = 0.1;
/// By so much, as a share of the whole, may the volumes of the solids be off from what they have been found
/// to be.
constexpr double volume_error = 1e-9;
/// As many as places, even those that turn out to be no corners of a plan.
constexpr std::size_t most_corners = most_division_crossings;

template <class Visit>
void for_each(std::uint64_t faces, Visit visit) {
  for (; faces != 0; faces &= faces - 1) visit(std::countr_zero(faces));
}

double least_depth_behind(const Array<NearFace>& faces, const Vector<3>& at) {
  double least = HUGE_VAL;
  for (const NearFace& face : faces) least = std::min(least, face.plane.depth(at));
  return least;
}

}  // namespace

void DivisionPlanner::reserve() {
  corners_.reserve(most_corners);
  for (int owner = 0; owner < 2; ++owner) {
    near_[owner].reserve(2 * most_plan_faces);
    on_[owner].reserve(most_plan_faces);
    nearest_[owner].reserve(most_plan_faces);
  }
  between_.reserve(3 * most_plan_corners);
  places_.reserve(most_plan_corners);
  solid_.reserve();
  writer_.reserve();
}

void DivisionPlanner::begin(const PlacedBlock& a, const PlacedBlock& b, const VolumeAndMoment& content) {
  block_[0].emplace(a);
  block_[1].emplace(b);
  volume_ = content.volume;
  const auto largest_offset = [](const Outline<3>& outline) {
    return *std::max_element(outline.offset, outline.offset + outline.face_count());
  };
  const double size = plan_size(b.at - a.at, std::max(largest_offset(a.outline), largest_offset(b.outline)));
  reach_ = one_place * size;
  margin_ = plan_rounding_followed * size;
  corners_.clear();
  is_too_large_ = std::max(a.outline.face_count(), b.outline.face_count()) > most_faces_to_plan;
}

/// Among those before it, as a shared one or as one of the same cells.
bool DivisionPlanner::is_known(const Corner& corner, std::size_t before) const {
  return std::any_of(corners_.begin(), corners_.begin() + std::ptrdiff_t(before), [&](const Corner& known) {
    return (is_shared(known) || known.kind == corner.kind) &&
           (known.at - corner.at).squaredNorm() <= reach_ * reach_;
  });
}

void DivisionPlanner::add_corner(const Vector<3>& at, Kind kind) {
  is_too_large_ |= corners_.size() == most_corners;
  if (is_too_large_) return;
  Corner corner{};
  corner.at = at;
  corner.kind = kind;
  corner.arrival = std::int32_t(corners_.size());
  if (!is_known(corner, corners_.size())) corners_.push_back(corner);
}

/// Only faces that the depths at the corners leave in question matter. Those that have cells come first.
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
  for (const bool has_cell : {true, false}) {
    for (const NearFace& face : near)
      if ((face.cell.volume != 0) == has_cell && least_depth[std::size_t(face.face)] <= reach + margin_)
        near_[owner].push_back(face);
    if (has_cell) cell_count_[owner] = int(near_[owner].size());
  }
  is_too_large_ |= near_[owner].size() > most_plan_faces;
}

DivisionPlanner::FacesOfCorner DivisionPlanner::faces_at(const Vector<3>& at) const {
  FacesOfCorner faces{};
  for (int owner = 0; owner < 2; ++owner) {
    const double least = least_depth_behind(near_[owner], at);
    for (int f = 0; f < near_count(owner); ++f) {
      const double depth = plane(owner, f).depth(at);
      faces.on[owner] |= FaceSet(depth <= rounding_) << f;
      faces.nearest[owner] |= FaceSet(depth <= least + rounding_) << f;
    }
  }
  return faces;
}

/// Cutting has rounded its place: its faces tell better where it is, and from there which these are.
bool DivisionPlanner::find_corner(Corner& corner) const {
  corner.faces = faces_at(corner.at);
  for (int round = 0; round < 4; ++round) {
    const bool is_located = locate(corner);
    if (corner.kind == none) return true;
    const FacesOfCorner faces = faces_at(corner.at);
    if (faces == corner.faces) return is_located;
    corner.faces = faces;
  }
  return false;
}

bool DivisionPlanner::find_corners() {
  for (std::size_t c = 0; c < corners_.size(); ++c) {
    if (!find_corner(corners_[c])) return false;
    if (is_known(corners_[c], c)) corners_[c].kind = none;
  }
  return sort_corners();
}

/// As who follows the plan finds it, too.
void DivisionPlanner::find_rounding() {
  double largest = 0;
  for (int owner = 0; owner < 2; ++owner)
    for (const NearFace& face : near_[owner])
      largest = std::max(largest, block_[owner]->outline.offset[face.face]);
  rounding_ = plan_rounding_made * plan_size(block_[1]->at - block_[0]->at, largest);
}

bool DivisionPlanner::is_vertex_of(int owner, Corner& corner) const {
  if (std::popcount(corner.faces.on[owner]) < 3) return false;
  const Outline<3>& outline = block_[owner]->outline;
  const Vector<3> at = corner.at - block_[owner]->at;
  for (std::int32_t v = 0; v < outline.vertex_count(); ++v) {
    if ((outline.vertex(v) - at).squaredNorm() > reach_ * reach_) continue;
    corner.vertex = v;
    corner.at = outline.vertex(v) + block_[owner]->at;
    corner.kind = owner == 0 ? vertex_of_a : vertex_of_b;
    return true;
  }
  return false;
}

/// Faces that all but agree tell where a corner is together with the plane between them.
bool DivisionPlanner::locate_by_faces(Corner& corner) const {
  PlanesOfCorner candidates;
  for (int owner = 0; owner < 2; ++owner) {
    const int first = owner == 0 ? 0 : near_count(0);
    const auto add_between = [&](int f, int g) {
      candidates.add({PlanCode(first + f), PlanCode(first + g)},
                     plane(owner, f).normal - plane(owner, g).normal,
                     plane(owner, f).depth(corner.at) - plane(owner, g).depth(corner.at));
    };
    const FaceSet on = corner.faces.on[owner], nearest = corner.faces.nearest[owner];
    for_each(on, [&](int f) {
      candidates.add({PlanCode(first + f), PlanCode(all_near())}, plane(owner, f).normal,
                     plane(owner, f).depth(corner.at));
    });
    const bool divides = corner.kind == of_cells(owner);
    const int one = std::countr_zero(nearest);
    if (divides) for_each(nearest & (nearest - 1), [&](int f) { add_between(one, f); });
    const FaceSet together = divides ? nearest & (nearest - 1) : on;
    for_each(together, [&](int f) {
      for_each(together & (~FaceSet(1) << f), [&](int g) {
        if ((plane(owner, f).normal - plane(owner, g).normal).squaredNorm() < least_turn * least_turn)
          add_between(f, g);
      });
    });
  }
  return candidates.locate(corner.at, corner.told_by);
}

/// A place where planes between faces cross what was but an edge of a part on the way is no corner.
bool DivisionPlanner::locate(Corner& corner) const {
  switch (corner.kind) {
    case shared:
      return is_vertex_of(0, corner) || is_vertex_of(1, corner) || locate_by_faces(corner);
    case of_cells_of_a:
    case of_cells_of_b:
      if (locate_by_faces(corner)) return true;
      corner.kind = none;
      return true;
    default:
      return true;
  }
}

/// In the order of their numbers. False when there are too many.
bool DivisionPlanner::sort_corners() {
  std::sort(corners_.begin(), corners_.end(), [](const Corner& p, const Corner& q) {
    return p.kind != q.kind ? p.kind < q.kind : p.arrival < q.arrival;
  });
  while (!corners_.empty() && corners_.back().kind == none) corners_.pop_back();
  return corners_.size() <= std::size_t(most_plan_corners);
}

void DivisionPlanner::list_corners_of_faces() {
  shared_ = of_cells_[0] = of_cells_[1] = {};
  for (int owner = 0; owner < 2; ++owner) {
    on_[owner].assign(near_[owner].size(), {});
    nearest_[owner].assign(near_[owner].size(), {});
  }
  places_.clear();
  for (const Corner& corner : corners_) {
    const int c = int(places_.size());
    places_.push_back(corner.at);
    if (is_shared(corner)) shared_.add(c);
    for (int owner = 0; owner < 2; ++owner) {
      if (is_of_cells(owner, corner)) of_cells_[owner].add(c);
      for_each(corner.faces.on[owner], [&](int f) { on_[owner][std::size_t(f)].add(c); });
      for_each(corner.faces.nearest[owner], [&](int f) { nearest_[owner][std::size_t(f)].add(c); });
    }
  }
}

void DivisionPlanner::put_faces() {
  for (int owner = 0; owner < 2; ++owner) {
    const int count = block_[owner]->outline.face_count(), padded = Outline<3>::padded(count);
    int which_matter[Outline<3>::padded(most_faces_to_plan) / 4] = {};
    const auto add = [&](int face) { which_matter[face / 4] |= 1 << face % 4; };
    for (const NearFace& face : near_[owner]) add(face.face);
    for (int repeated = count; repeated < padded; ++repeated) add(repeated);
    for (int f = 0; f < padded; f += 4) writer_.put({which_matter[f / 4]});
    writer_.begin_list();
    for (const NearFace& face : near_[owner]) writer_.put_in_list({face.face});
  }
}

void DivisionPlanner::put_planes_between() {
  between_.clear();
  for (const Corner& corner : corners_) {
    if (corner.kind < shared) continue;
    for (const FacePair& faces : corner.told_by)
      if (number_of_plane(faces) == all_near() + int(between_.size())) between_.push_back(faces);
  }
  is_too_large_ |= between_.size() > std::size_t(most_planes_between);
  writer_.begin_list();
  for (const FacePair& faces : between_) writer_.put_in_list({faces[0], faces[1]});
}

int DivisionPlanner::number_of_plane(const FacePair& faces) const {
  if (faces[1] == all_near()) return faces[0];
  return all_near() + int(std::find(between_.begin(), between_.end(), faces) - between_.begin());
}

void DivisionPlanner::put_corners() {
  for (const Kind kind : {vertex_of_a, vertex_of_b}) {
    writer_.begin_list();
    for (const Corner& corner : corners_)
      if (corner.kind == kind) writer_.put_in_list({corner.vertex});
  }
  writer_.begin_list();
  for (const Corner& corner : corners_) {
    if (corner.kind < shared) continue;
    const auto& [p, q, r] = corner.told_by;
    writer_.put_in_list({number_of_plane(p), number_of_plane(q), number_of_plane(r)});
  }
}

/// With the facets that lie in the blocks' own faces.
void DivisionPlanner::begin_solid(const CornerSet& corners) {
  solid_.begin(places_);
  for (int owner = 0; owner < 2; ++owner)
    for (int f = 0; f < near_count(owner); ++f)
      solid_.add_facet(corners & on(owner, f), plane(owner, f).normal);
}

bool DivisionPlanner::put_whole() {
  begin_solid(shared_);
  if (!solid_.close()) return false;
  const int top = solid_.top();
  writer_.put({top});
  writer_.begin_list();
  const double volume = solid_.divide(top, [&](int p, int q, int r) { writer_.put_in_list({p, q, r}); });
  writer_.fill_list_of_tetrahedra({top, top, top});
  return std::abs(volume - volume_) <= volume_error * volume_;
}

/// A shared corner on a face is nearest to it as well.
void DivisionPlanner::put_depths(int owner) {
  const auto put = [&](int face, const CornerSet& corners) {
    corners.for_each([&](int c) { writer_.put_in_list({plan_depth(face, c)}); });
  };
  writer_.begin_list();
  for (int f = 0; f < near_count(owner); ++f)
    put(f, (nearest(owner, f) & of_cells_[owner]).without(on(owner, f) & shared_));
  writer_.begin_list();
  for (int f = 0; f < near_count(owner); ++f) put(f, on(owner, f) & shared_);
}

bool DivisionPlanner::put_cells(int owner) {
  put_depths(owner);
  writer_.put({cell_count_[owner]});
  writer_.begin_list();
  for (int f = 0; f < cell_count_[owner]; ++f) {
    const CornerSet of_cell = of_cells_[owner] & nearest(owner, f);
    begin_solid(of_cell);
    for (int other = 0; other < near_count(owner); ++other)
      if (other != f)
        solid_.add_facet(of_cell & nearest(owner, other),
                         plane(owner, other).normal - plane(owner, f).normal);
    if (!solid_.close()) return false;
    const int top = solid_.top();
    const double volume = solid_.divide(top, [&](int p, int q, int r) {
      writer_.put_in_list({f, top, p, q, r});
    });
    const double expected = near_[owner][std::size_t(f)].cell.volume;
    if (!(std::abs(volume - expected) <= volume_error * volume_)) return false;
  }
  writer_.fill_list_of_tetrahedra({0, 0, 0, 0, 0});
  return true;
}

std::span<const PlanCode> DivisionPlanner::make() {
  if (is_too_large_) return {};
  find_rounding();
  if (!find_corners()) return {};
  list_corners_of_faces();
  writer_.begin();
  put_faces();
  put_planes_between();
  put_corners();
  const bool is_whole = put_whole() && put_cells(0) && put_cells(1);
  if (!is_whole || is_too_large_ || writer_.is_too_long()) return {};
  return writer_.plan();
}

}  // namespace halfspace
