#pragma once

#include "geometry/piece_vertices.h"
#include "geometry/sounding.h"

namespace halfspace {

/// A face of a block that can be the nearest one to some point of what it has in common with another, and its
/// cell: where it is the nearest.
struct NearFace {
  int face;
  CuttingPlane plane;
  DepthRange depths;  // of what the blocks have in common
  VolumeAndMoment cell;
};

/// Divides pieces among the faces that they are nearest to. One face after the other takes what is nearer to
/// it than to those before: so each bit goes to exactly one face, however rounding places the planes between
/// them, and it is no worse than rounding when that is not quite the nearest.
template <class Piece>
class CellDivision {
 public:
  explicit CellDivision(Memory* memory) : cutter_(memory), pieces_(memory), waiting_(memory) {}

  /// For polyhedra of no more faces than this, and so many pieces at a time.
  void reserve(std::size_t faces, std::size_t pieces) {
    cutter_.reserve(faces);
    waiting_.reserve(pieces);
    pieces_.reserve(pieces);
    for (Piece& piece : pieces_.all()) piece.reserve(faces);
  }

  /// Adds to the cells.
  template <class View>
  void divide(const View& whole, const VolumeAndMoment& content, Array<NearFace>& near, Sounding& sounding) {
    // Where memory ran out before there may be work left.
    waiting_.clear();
    pieces_.give_back_all();
    divide_part(whole, {none, content, 0, 1}, near, sounding);
    while (!waiting_.empty()) {
      const Part part = waiting_.back();
      waiting_.pop_back();
      divide_part(pieces_[part.piece].view(), part, near, sounding);
    }
  }

 private:
  static constexpr std::int32_t none = -1;

  /// Of the near faces before `next`, one is the nearest to it.
  struct Part {
    std::int32_t piece;
    VolumeAndMoment content;
    std::size_t nearest;
    std::size_t next;
  };

  template <class View>
  void divide_part(View view, Part part, Array<NearFace>& near, Sounding& sounding) {
    for (; part.next < near.size(); ++part.next) {
      const CuttingPlane &nearest = near[part.nearest].plane, &rival = near[part.next].plane;
      const DepthRange lead =
          sounding.take(view, {rival.normal - nearest.normal, rival.offset - nearest.offset});
      if (lead.least >= 0) continue;
      if (lead.most <= 0) {
        part.nearest = part.next;
      } else {
        view = keep_lead(view, part, near, sounding);
      }
    }
    add(part.content, near[part.nearest]);
    give_back(part.piece);
  }

  /// The rest waits; behind the last face there is nothing to do but add it to that one's cell. Its content
  /// is what is left of the whole.
  template <class View>
  View keep_lead(const View& view, Part& part, Array<NearFace>& near, const Sounding& sounding) {
    const std::int32_t kept = pieces_.take();
    const bool is_last = part.next + 1 == near.size();
    const std::int32_t rest = is_last ? none : pieces_.take();
    if (is_last) {
      cutter_.keep_inside(view, sounding, pieces_[kept]);
    } else {
      cutter_.part(view, sounding, pieces_[kept], pieces_[rest]);
    }
    const VolumeAndMoment content = measure(pieces_[kept].view());
    const VolumeAndMoment left{part.content.volume - content.volume, part.content.moment - content.moment};
    if (is_last) {
      add(left, near[part.next]);
    } else {
      waiting_.push_back({rest, left, part.next, part.next + 1});
    }
    give_back(part.piece);
    part.piece = kept;
    part.content = content;
    return pieces_[kept].view();
  }

  void give_back(std::int32_t piece) {
    if (piece != none) pieces_.give_back(piece);
  }

  static void add(const VolumeAndMoment& content, NearFace& face) {
    face.cell.volume += content.volume;
    face.cell.moment += content.moment;
  }

  typename Piece::Cutter cutter_;
  PiecePool<Piece> pieces_;
  Array<Part> waiting_;
};

}  // namespace halfspace
