#include "force/potential/space/plan_writer.h"

#include <algorithm>
#include <array>
#include <bit>
#include <initializer_list>
#include <span>

#include "force/potential/space/planes_of_corner.h"
#include "force/potential/space/planned_solid.h"

namespace halfspace {
namespace {

constexpr int most_near = int(max_near_faces);

/// Encodes a record as a plan. Every solid is the convex hull of the corners in its faces.
class PlanWriter {
 public:
  PlanWriter(const DivisionRecord& record, Array<PlanCode>& room) : record_(record), codes_(room) {}

  std::span<const PlanCode> write() {
    codes_.resize(most_plan_codes);
    if (!record_.is_complete() || !number_corners() || !number_faces() || !number_planes()) return {};
    put_faces();
    put_planes_between();
    put_corners();
    if (!put_whole() || !put_cells(0) || !put_cells(1) || !fits_) return {};
    return {codes_.data(), code_count_};
  }

 private:
  using Corner = DivisionCorner;

  /// Vertices of a, then of b, then others. Where planes meet only in a line, no cell has a corner.
  bool number_corners() {
    for (const int block : {0, 1, -1}) {
      for (const Corner& corner : record_.corners()) {
        if (corner.block != block) continue;
        corners_[corner_count_] = &corner;
        if (block >= 0) {
          ++corner_count_;
        } else if (const auto faces = planes_at(corner).best()) {
          told_by_[corner_count_++] = *faces;
        }
      }
    }
    return corner_count_ > 0;
  }

  PlanesOfCorner planes_at(const Corner& corner) const {
    PlanesOfCorner planes;
    for (int owner = 0; owner < 2; ++owner) {
      const FaceSet on = corner.on[owner];
      const FaceSet together = on != 0 || corner.is_shared ? on : corner.nearest[owner];
      const int first = std::countr_zero(on);
      if (on != 0) planes.add({first, -1, owner}, near(owner, first).plane.normal);
      for_each(together & (together - 1), [&](int f) {
        const int other = closest_before(owner, together, f);
        planes.add({other, f, owner}, near(owner, f).plane.normal - near(owner, other).plane.normal);
      });
    }
    return planes;
  }

  /// Faces with cells come first, then other relevant ones: those whose least depth is at most that of the
  /// deepest corner, and those that contain a corner.
  bool number_faces() {
    for (int owner = 0; owner < 2; ++owner) {
      FaceSet met = 0, with_cells = 0;
      double deepest = 0;
      for (std::size_t c = 0; c < corner_count_; ++c) {
        const FaceSet nearest = corners_[c]->nearest[owner];
        met |= corners_[c]->on[owner];
        with_cells |= nearest;
        if (nearest != 0 && corners_[c]->on[owner] == 0)
          deepest = std::max(deepest, near(owner, std::countr_zero(nearest)).plane.depth(corners_[c]->at));
      }
      for (std::size_t f = 0; f < record_.near(owner).size(); ++f)
        if (near(owner, int(f)).depths.least <= deepest) met |= face_set(f);
      const auto number = [&](int f) {
        number_of_face_[owner][f] = face_count_ + face_count_of_[owner];
        faces_[owner][face_count_of_[owner]++] = f;
      };
      for_each(with_cells, number);
      cell_count_[owner] = face_count_of_[owner];
      for_each(met & ~with_cells, number);
      face_count_ += face_count_of_[owner];
      if (face_count_of_[owner] > most_plan_faces) return false;
    }
    return true;
  }

  bool number_planes() {
    for (std::size_t c = 0; c < corner_count_; ++c)
      if (corners_[c]->block < 0)
        for (std::size_t k = 0; k < 3; ++k) planes_[c][k] = number_of(told_by_[c][k]);
    return fits_;
  }

  /// The preceding face with the normal nearest to a face's: for nearly coplanar faces, the planes between
  /// them locate their intersection most accurately.
  int closest_before(int owner, FaceSet together, int face) const {
    const auto turn = [&](int f) { return near(owner, f).plane.normal.dot(near(owner, face).plane.normal); };
    int closest = std::countr_zero(together);
    for_each(together & (together - 1) & (face_set(face) - 1), [&](int f) {
      if (turn(f) > turn(closest)) closest = f;
    });
    return closest;
  }

  int number_of(const PlanesOfCorner::Faces& faces) {
    const int one = number_of_face_[faces.owner][faces.one];
    return faces.other < 0 ? one : number_between(one, number_of_face_[faces.owner][faces.other]);
  }

  int number_between(int one, int other) {
    const int faces = most_near * one + other;
    const auto end = between_.begin() + between_count_, known = std::find(between_.begin(), end, faces);
    if (known == end) {
      fits_ &= between_count_ < most_planes_between;
      if (!fits_) return 0;
      *end = faces;
      ++between_count_;
    }
    return face_count_ + int(known - between_.begin());
  }

  void put(std::initializer_list<int> codes) {
    fits_ &= code_count_ + codes.size() <= most_plan_codes;
    if (!fits_) return;
    for (const int code : codes) codes_[code_count_++] = PlanCode(code);
  }

  /// Writes the count of a list before its entries.
  template <class PutAll>
  void put_list(std::size_t codes_each, PutAll put_all) {
    const std::size_t head = code_count_;
    put({0});
    put_all();
    if (fits_) codes_[head] = PlanCode((code_count_ - head - 1) / codes_each);
  }

  void put_faces() {
    for (int owner = 0; owner < 2; ++owner) {
      const int count = record_.block(owner).outline.face_count(), padded = Outline<3>::padded(count);
      const std::size_t head = code_count_;
      for (int f = 0; f < padded; f += 4) put({0});
      if (!fits_) return;
      const auto mark = [&](int face) { codes_[head + std::size_t(face / 4)] |= PlanCode(1 << face % 4); };
      for (const int f : faces(owner)) mark(near(owner, f).face);
      for (int repeated = count; repeated < padded; ++repeated) mark(repeated);
      put_list(1, [&] {
        for (const int f : faces(owner)) put({near(owner, f).face});
      });
    }
  }

  void put_planes_between() {
    put_list(2, [&] {
      for (int k = 0; k < between_count_; ++k)
        put({between_[std::size_t(k)] / most_near, between_[std::size_t(k)] % most_near});
    });
  }

  void put_corners() {
    for (const int block : {0, 1, -1}) {
      put_list(block < 0 ? 3 : 1, [&] {
        for (std::size_t c = 0; c < corner_count_; ++c) {
          const auto& [p, q, r] = planes_[c];
          if (corners_[c]->block == block) block < 0 ? put({p, q, r}) : put({corners_[c]->vertex});
        }
      });
    }
  }

  /// No plan without volume: where blocks touch along an edge, all corners are nearly in a line.
  bool put_whole() {
    PlannedSolid solid;
    for (std::size_t c = 0; c < corner_count_; ++c) {
      const Corner& corner = *corners_[c];
      if (corner.is_shared && !solid.add_corner(int(c), corner.at, corner.on[0], corner.on[1])) return false;
    }
    if (!solid.divide([&](int owner, int f) { return near(owner, f).plane.normal; })) return false;
    if (solid.triangles().empty()) return false;
    put({solid.top()});
    put_list(3, [&] {
      for (const auto& [p, q, r] : solid.triangles()) put({p, q, r});
      for (std::size_t k = solid.triangles().size(); k % 4 != 0; ++k)
        put({solid.top(), solid.top(), solid.top()});
    });
    return true;
  }

  bool put_cells(int owner) {
    put_depths(owner);
    put({cell_count_[owner]});
    bool all_are_closed = true;
    put_list(5, [&] {
      std::size_t count = 0;
      for (int cell = 0; cell < cell_count_[owner] && all_are_closed; ++cell)
        all_are_closed = put_cell(owner, cell, count);
      for (; count % 4 != 0; ++count) put({0, 0, 0, 0, 0});
    });
    return all_are_closed;
  }

  /// The planes of the cell are those of the other block, its own face, and those between it and other faces.
  bool put_cell(int owner, int cell, std::size_t& count) {
    PlannedSolid solid;
    const int face = faces_[owner][cell];
    for (std::size_t c = 0; c < corner_count_; ++c) {
      const FaceSet nearest = corners_[c]->nearest[owner];
      if ((nearest & face_set(face)) == 0) continue;
      const Corner& corner = *corners_[c];
      const FaceSet own = nearest & (corners_[c]->on[owner] | ~face_set(face));
      if (!solid.add_corner(int(c), corner.at, corner.on[1 - owner], own)) return false;
    }
    const auto outward = [&](int sort, int f) -> Vector<3> {
      if (sort == 0) return near(1 - owner, f).plane.normal;
      if (f == face) return near(owner, f).plane.normal;
      return near(owner, f).plane.normal - near(owner, face).plane.normal;
    };
    if (!solid.divide(outward)) return false;
    for (const auto& [p, q, r] : solid.triangles()) put({cell, solid.top(), p, q, r});
    count += solid.triangles().size();
    return true;
  }

  void put_depths(int owner) {
    const int first = owner == 0 ? 0 : face_count_of_[0];
    const auto put_each = [&](FaceSet faces, std::size_t c) {
      for_each(faces, [&](int f) { put({plan_depth(number_of_face_[owner][f] - first, int(c))}); });
    };
    const auto is_on = [&](std::size_t c) { return corners_[c]->is_shared && corners_[c]->on[owner] != 0; };
    put_list(1, [&] {
      for (std::size_t c = 0; c < corner_count_; ++c)
        if (!is_on(c)) put_each(corners_[c]->nearest[owner], c);
    });
    put_list(1, [&] {
      for (std::size_t c = 0; c < corner_count_; ++c)
        if (is_on(c)) put_each(corners_[c]->on[owner], c);
    });
  }

  const NearFace& near(int owner, int face) const { return record_.near(owner)[std::size_t(face)]; }
  std::span<const int> faces(int owner) const { return {faces_[owner], std::size_t(face_count_of_[owner])}; }

  const DivisionRecord& record_;
  Array<PlanCode>& codes_;
  std::size_t code_count_ = 0;
  std::array<const Corner*, most_plan_corners> corners_;
  std::size_t corner_count_ = 0;
  std::array<std::array<PlanesOfCorner::Faces, 3>, most_plan_corners> told_by_;
  int faces_[2][max_near_faces];
  int number_of_face_[2][max_near_faces];
  int face_count_of_[2] = {};
  int cell_count_[2] = {};
  int face_count_ = 0;  // of both
  std::array<std::array<int, 3>, most_plan_corners> planes_;
  std::array<int, most_planes_between> between_;  // two faces in one number
  int between_count_ = 0;
  bool fits_ = true;
};

}  // namespace

std::span<const PlanCode> encode_division(const DivisionRecord& record, Array<PlanCode>& room) {
  return PlanWriter(record, room).write();
}

}  // namespace halfspace
