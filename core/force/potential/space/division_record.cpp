#include "force/potential/space/division_record.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "force/potential/space/division_plan.h"

namespace halfspace {
namespace {

constexpr std::uint8_t not_near = 255;

}  // namespace

void DivisionRecord::reserve(std::size_t edges) {
  corners_.reserve(most_plan_corners);
  for (int owner = 0; owner < 2; ++owner) {
    near_[owner].reserve(max_near_faces);
    place_[owner].reserve(edges);
    meet_[owner].reserve(edges);
  }
}

void DivisionRecord::begin(const PlacedBlock& a, const PlacedBlock& b, int whole,
                           const Array<NearFace>& near_a, const Array<NearFace>& near_b) {
  block_[0].emplace(a);
  block_[1].emplace(b);
  whole_ = whole;
  corners_.clear();
  is_complete_ = std::max(near_a.size(), near_b.size()) <= max_near_faces &&
                 std::max(a.outline.face_count(), b.outline.face_count()) <= most_faces_to_plan;
  if (!is_complete_) return;
  near_[0].assign(near_a.begin(), near_a.end());
  near_[1].assign(near_b.begin(), near_b.end());
  double largest_offset = 0;
  for (int owner = 0; owner < 2; ++owner) {
    const Outline<3>& outline = block(owner).outline;
    const Topology& t = *outline.topology;
    place_[owner].assign(std::size_t(t.face_count), not_near);
    meet_[owner].assign(std::size_t(t.vertex_count), 0);
    for (std::size_t k = 0; k < near_[owner].size(); ++k) {
      const int face = near_[owner][k].face;
      largest_offset = std::max(largest_offset, outline.offset[face]);
      place_[owner][std::size_t(face)] = std::uint8_t(k);
      for (std::int32_t i = t.first_of_face[face]; i < t.first_of_face[face + 1]; ++i)
        meet_[owner][std::size_t(t.face_vertex[i])] |= face_set(k);
    }
  }
  rounding_ = plan_rounding_made * plan_size(b.at - a.at, largest_offset);
}

void DivisionRecord::add_corners(const DividedPolyhedron& intersection, DividedPolyhedron::Part vertices) {
  if (!is_complete_) return;
  for (const Index v : vertices) {
    DivisionCorner corner;
    corner.is_shared = true;
    corner.at = intersection.position(v);
    for (const Index plane : intersection.faces_at(v)) lay_on(plane, corner);
    find_nearest(0, corner);
    find_nearest(1, corner);
    add(corner);
  }
}

void DivisionRecord::add_crossings(const DividedPolyhedron& parts) {
  if (!is_complete_) return;
  Index added = parts.vertex_count();
  for (const DividedPolyhedron::Crossing& crossing : parts.crossings()) {
    DivisionCorner corner;
    corner.at = parts.position(added++);
    for (const Index plane : parts.faces_along(crossing)) lay_on(plane, corner);
    find_nearest(owner_, corner);
    add(corner);
  }
}

/// Faces of the cut block are numbered first, then those of the other one, then planes between faces.
void DivisionRecord::lay_on(Index plane, DivisionCorner& corner) const {
  Index face = plane;
  for (const int block : {whole_, 1 - whole_}) {
    const Array<std::uint8_t>& place = place_[block];
    if (face < place.size()) {
      if (place[face] != not_near) corner.on[block] |= face_set(place[face]);
      return;
    }
    face -= Index(place.size());
  }
}

/// If the corner is on any faces, these are the nearest.
void DivisionRecord::find_nearest(int owner, DivisionCorner& corner) const {
  double depth[max_near_faces], least = HUGE_VAL;
  const std::size_t count = near_[owner].size();
  for (std::size_t k = 0; k < count; ++k) {
    depth[k] = near_[owner][k].plane.depth(corner.at);
    least = std::min(least, depth[k]);
  }
  FaceSet& nearest = corner.nearest[owner];
  for (std::size_t k = 0; k < count; ++k)
    if (depth[k] <= least + rounding_) nearest |= face_set(k);
  if (corner.on[owner] != 0 || least <= rounding_) {
    corner.on[owner] |= nearest;
    nearest = corner.on[owner];
  }
}

void DivisionRecord::add(DivisionCorner& corner) {
  if (!is_corner(corner)) return;
  const auto known = std::find_if(corners_.begin(), corners_.end(), [&](const DivisionCorner& other) {
    return (other.at - corner.at).squaredNorm() <= rounding_ * rounding_;
  });
  if (known != corners_.end()) {
    for (int owner = 0; owner < 2; ++owner) {
      known->on[owner] |= corner.on[owner];
      known->nearest[owner] |= corner.nearest[owner];
    }
    return;
  }
  is_complete_ &= corners_.size() < std::size_t(most_plan_corners);
  if (is_complete_) corners_.push_back(corner);
}

/// Planes between two faces also cross cells of a third one in intermediate cuts: no cell has a corner there.
bool DivisionRecord::is_corner(DivisionCorner& corner) const {
  if (make_vertex(0, corner) || make_vertex(1, corner)) return true;
  int planes = std::popcount(corner.on[0]) + std::popcount(corner.on[1]);
  if (!corner.is_shared && corner.on[owner_] == 0) planes += std::popcount(corner.nearest[owner_]) - 1;
  return planes >= 3;
}

/// False when the faces at the corner do not identify a vertex of the block.
bool DivisionRecord::make_vertex(int block, DivisionCorner& corner) const {
  const FaceSet faces = corner.on[block];
  if (std::popcount(faces) < 3) return false;
  const Topology& t = *block_[block]->outline.topology;
  const int face = near_[block][std::size_t(std::countr_zero(faces))].face;
  for (std::int32_t k = t.first_of_face[face]; k < t.first_of_face[face + 1]; ++k) {
    const std::int32_t v = t.face_vertex[k];
    const FaceSet meet = meet_[block][std::size_t(v)];
    if ((faces & ~meet) != 0) continue;
    corner.on[block] = meet;
    if (corner.nearest[block] != 0) corner.nearest[block] = meet;
    corner.block = block;
    corner.vertex = v;
    corner.at = block_[block]->outline.vertex(v) + block_[block]->at;
    return true;
  }
  return false;
}

}  // namespace halfspace
