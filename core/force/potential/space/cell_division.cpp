#include "force/potential/space/cell_division.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "simd/two_lanes.h"

namespace halfspace {
namespace {

void add(const VolumeAndMoment& content, NearFace& face) {
  face.cell.volume += content.volume;
  face.cell.moment += content.moment;
}

}  // namespace

void CellDivision::reserve(std::size_t edges, std::size_t vertices, std::size_t near) {
  parts_.reserve(edges, vertices);
  grow(lists_, vertices + near * near);
  waiting_.reserve(near);
  grow(depth_, vertices * near);
}

void CellDivision::divide(const DividedPolyhedron& polyhedron, DividedPolyhedron::Part whole,
                          const VolumeAndMoment& content, double largest_coordinate, Index first_new_face,
                          Array<NearFace>& near, DivisionRecord* record) {
  record_ = record;
  first_new_face_ = first_new_face;
  find_depths(polyhedron, whole, largest_coordinate, near);
  const std::size_t count = list_near_faces(near);
  if (count == 0) return;  // depths are NaN
  if (count == 1) {
    near[lists_[0]].cell = content;
    return;
  }
  parts_.begin(polyhedron);
  grow(lists_, count + whole.size());
  std::copy(whole.begin(), whole.end(), lists_.begin() + std::ptrdiff_t(count));
  // Parts may be left from a call that ran out of memory.
  waiting_.clear();
  waiting_.push_back({0, count, whole.size(), content, parts_.vertex_count()});
  while (!waiting_.empty()) {
    const Part part = waiting_.back();
    waiting_.pop_back();
    parts_.shrink_to(part.vertices_of_all);
    divide_part(part, near);
  }
}

void CellDivision::find_depths(const DividedPolyhedron& polyhedron, DividedPolyhedron::Part whole,
                               double largest_coordinate, Array<NearFace>& near) {
  stride_ = near.size() + (near.size() & 1);
  grow(depth_, polyhedron.vertex_count() * stride_);
  double largest = largest_coordinate;
  for (std::size_t k = 0; k < near.size(); k += 2) {
    NearFace &one = near[k], &other = near[std::min(k + 1, near.size() - 1)];
    const Halfspace<3>&p = one.plane, &q = other.plane;
    const TwoLanes nx{p.normal.x(), q.normal.x()}, ny{p.normal.y(), q.normal.y()},
        nz{p.normal.z(), q.normal.z()}, offset{p.offset, q.offset};
    TwoLanes least = both(HUGE_VAL), most = both(-HUGE_VAL);
    for (const Index v : whole) {
      const Vector<3> at = polyhedron.position(v);
      const TwoLanes depth = offset - (nx * both(at.x()) + ny * both(at.y()) + nz * both(at.z()));
      store_two(depths(v) + k, depth);
      least = min(least, depth);
      most = max(most, depth);
    }
    one.depths = {least[0], most[0]};
    other.depths = {least[1], most[1]};
    largest = std::max({largest, std::abs(p.offset), std::abs(q.offset)});
  }
  rounding_ = 0x1p-48 * largest;
}

/// No point is deeper than the minimum over the faces of the whole's largest depth. The faces that are the
/// nearest to most of it come first: this gives the fewest parts.
std::size_t CellDivision::list_near_faces(const Array<NearFace>& near) {
  double reach = HUGE_VAL;
  for (const NearFace& face : near) reach = std::min(reach, face.depths.most);
  grow(lists_, near.size());
  std::size_t count = 0;
  for (std::size_t k = 0; k < near.size(); ++k) {
    lists_[count] = Index(k);
    count += near[k].depths.least <= reach;
  }
  const auto sum = [&](Index k) { return near[k].depths.least + near[k].depths.most; };
  std::sort(lists_.begin(), lists_.begin() + std::ptrdiff_t(count),
            [&](Index e, Index f) { return std::pair(sum(e), e) < std::pair(sum(f), f); });
  return count;
}

/// Where no third face is nearer than both, the second face only takes its cell from the first: the part
/// stays whole and continues without this face.
void CellDivision::divide_part(const Part& part, Array<NearFace>& near) {
  Index* const face = lists_.data() + part.first;
  VolumeAndMoment rest = part.content;
  for (std::size_t count = find_rivals(part); count > 1; --count) {
    cut_edges(part);
    const VolumeAndMoment inside = parts_.measure_inside();
    if (record_) record_->add_crossings(parts_);
    rest.volume -= inside.volume;
    rest.moment -= inside.moment;
    if (!others_have_nothing_inside({face, count})) {
      const Index first_new = parts_.vertex_count();
      parts_.close_both(first_new_face_ + first_new);
      interpolate_depths(first_new, {face, count});
      return put_aside(part, count, inside, rest);
    }
    parts_.take_back_cut();
    add(inside, near[face[1]]);
    face[1] = face[count - 1];
  }
  add(rest, near[face[0]]);
}

/// Puts a near face first, then the one nearer than it by the largest difference somewhere, then all others
/// that are nearer somewhere. Faces that are nowhere nearer than the first are dropped, here and in parts of
/// this part. Returns the number of faces left.
std::size_t CellDivision::find_rivals(const Part& part) {
  Index* const near = lists_.data() + part.first;
  const DividedPolyhedron::Part vertices{near + part.near_count, part.vertex_count};
  std::size_t count = part.near_count, kept = 1;
  double least_lead = 0;
  for (std::size_t k = 1; k < count;) {
    const std::size_t pair_end = std::min(k + 2, count);
    const Index nearest = near[0];
    const std::array<DepthRange, 2> leads = find_leads(vertices, nearest, near[k], near[pair_end - 1]);
    for (std::size_t i = 0; k < pair_end; ++i, ++k) {
      const Index rival = near[k];
      if (leads[i].least >= -rounding_) continue;
      if (leads[i].most <= rounding_) {
        // Compared with this one, the others must be tested again.
        near[0] = rival;
        count = std::size_t(std::copy(near + k + 1, near + count, near + kept) - near);
        k = kept = 1;
        least_lead = 0;
        break;
      }
      near[kept] = rival;
      if (leads[i].least < least_lead) {
        least_lead = leads[i].least;
        std::swap(near[1], near[kept]);
      }
      ++kept;
    }
  }
  return kept;
}

/// The leads of the nearest face over two rivals: how much deeper the vertices are behind the rivals.
std::array<DepthRange, 2> CellDivision::find_leads(DividedPolyhedron::Part vertices, Index nearest,
                                                   Index rival, Index other) {
  TwoLanes least = both(HUGE_VAL), most = both(-HUGE_VAL);
  for (const Index v : vertices) {
    const double* const depth = depths(v);
    const TwoLanes lead = TwoLanes{depth[rival], depth[other]} - both(depth[nearest]);
    least = min(least, lead);
    most = max(most, lead);
  }
  return {{{least[0], most[0]}, {least[1], most[1]}}};
}

/// Inside is where the second face is nearer: usually the smaller part, which is cheaper to measure. The
/// plane between two faces often contains their common edge. Vertices equally near, to rounding, are outside,
/// so that no edges are cut there. The margin is below that of find_rivals(), so that where a third face is
/// equally near, it does not become a rival.
void CellDivision::cut_edges(const Part& part) {
  const Index* const near = lists_.data() + part.first;
  const DividedPolyhedron::Part vertices{near + part.near_count, part.vertex_count};
  parts_.cut_edges(vertices, [nearest = depths(0) + near[0], rival = depths(0) + near[1], stride = stride_,
                              margin = 0.25 * rounding_](Index v) {
    return nearest[v * stride] - rival[v * stride] - margin;
  });
}

/// Are the faces from the third on nowhere nearer in the region where the second is nearer than the first?
bool CellDivision::others_have_nothing_inside(std::span<const Index> faces) {
  for (const Index other : faces.subspan(2)) {
    const auto lead = [&](Index v) { return depths(v)[other] - depths(v)[faces[0]]; };
    for (const Index v : parts_.inside())
      if (lead(v) < -rounding_) return false;
    for (const DividedPolyhedron::Crossing& crossing : parts_.crossings()) {
      const double inner = lead(crossing.inner());
      if (inner + crossing.share * (lead(crossing.outer()) - inner) < -rounding_) return false;
    }
  }
  return true;
}

void CellDivision::interpolate_depths(Index first_new, std::span<const Index> faces) {
  grow(depth_, parts_.vertex_count() * stride_);
  const Index count = Index(parts_.crossings().size());
  Index added = first_new;
  for (const DividedPolyhedron::Crossing& crossing : parts_.crossings()) {
    const double *const inner = depths(crossing.inner()), *const outer = depths(crossing.outer());
    double *const depth = depths(added), *const other = depths(added + count);
    for (const Index k : faces) depth[k] = other[k] = inner[k] + crossing.share * (outer[k] - inner[k]);
    ++added;
  }
}

/// Replaces the part by those of the second and of the first face, each with the other faces.
void CellDivision::put_aside(const Part& part, std::size_t near_count, const VolumeAndMoment& inside,
                             const VolumeAndMoment& outside) {
  const DividedPolyhedron::Part vertices_inside = parts_.inside(), vertices_outside = parts_.outside();
  const std::size_t near = near_count - 1, first_inside = part.first + 1,
                    first_outside = first_inside + near + vertices_inside.size();
  grow(lists_, first_outside + near + vertices_outside.size());
  Index *const list = lists_.data() + part.first, *const list_outside = lists_.data() + first_outside;
  std::copy(vertices_inside.begin(), vertices_inside.end(), list + near_count);
  list_outside[0] = list[0];
  std::copy_n(list + 2, near - 1, list_outside + 1);
  std::copy(vertices_outside.begin(), vertices_outside.end(), list_outside + near);
  waiting_.push_back({first_inside, near, vertices_inside.size(), inside, parts_.vertex_count()});
  waiting_.push_back({first_outside, near, vertices_outside.size(), outside, parts_.vertex_count()});
}

}  // namespace halfspace
