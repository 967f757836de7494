#pragma once

#include <algorithm>
#include <cstdint>
#include <numeric>

#include "geometry/vector.h"

namespace halfspace {

/// Integrals over a body.
struct VolumeAndMoment {
  double volume = 0;
  Vector<3> moment = Vector<3>::Zero();  // of the position
};

/// The vertices of what is cut again and again: room that is filled anew asks for no memory that it had
/// before.
class PieceVertices {
 public:
  explicit PieceVertices(Memory* memory) : x_(memory), y_(memory), z_(memory) {}

  int count() const { return count_; }
  const double* x() const { return x_.data(); }
  const double* y() const { return y_.data(); }
  const double* z() const { return z_.data(); }

  void reserve(std::size_t most) {
    if (z_.size() > most) return;
    for (Array<double>* coordinates : {&x_, &y_, &z_}) coordinates->resize(most + 1);
  }
  void begin(std::size_t most) {
    reserve(most);
    count_ = 0;
  }
  /// Without a branch: whether it belongs to the piece is as good as random.
  std::int32_t add(double x, double y, double z, bool belongs = true) {
    const std::size_t v = std::size_t(count_);
    x_[v] = x;
    y_[v] = y;
    z_[v] = z;
    count_ += belongs;
    return std::int32_t(v);
  }
  /// Pads them, so that a pair can be read at a time.
  void end() {
    if (count_ == 0) return;
    const std::size_t last = std::size_t(count_) - 1;
    add(x_[last], y_[last], z_[last], false);
  }

 private:
  Array<double> x_;
  Array<double> y_;
  Array<double> z_;
  int count_ = 0;
};

/// Calls `add(x, y, z)` for the point so far from one vertex of a view to another.
template <class View, class Add>
inline auto add_between(const View& view, int from, int to, double share, Add add) {
  return add(view.x[from] + share * (view.x[to] - view.x[from]),
             view.y[from] + share * (view.y[to] - view.y[from]),
             view.z[from] + share * (view.z[to] - view.z[from]));
}

/// Pieces to use again, known by their numbers.
template <class Piece>
class PiecePool {
 public:
  explicit PiecePool(Memory* memory) : pieces_(memory), free_(memory) {}

  /// So many at a time ask for no memory, apart from what each of them needs.
  void reserve(std::size_t pieces) {
    free_.reserve(std::max(pieces, pieces_.size()));
    while (pieces_.size() < pieces) {
      pieces_.emplace_back(pieces_.get_allocator().resource());
      free_.push_back(std::int32_t(pieces_.size() - 1));
    }
  }
  Array<Piece>& all() { return pieces_; }

  std::int32_t take() {
    if (free_.empty()) {
      free_.push_back(std::int32_t(pieces_.size()));
      pieces_.emplace_back(pieces_.get_allocator().resource());
    }
    const std::int32_t piece = free_.back();
    free_.pop_back();
    return piece;
  }
  void give_back(std::int32_t piece) { free_.push_back(piece); }
  void give_back_all() {
    free_.resize(pieces_.size());
    std::iota(free_.begin(), free_.end(), 0);
  }
  Piece& operator[](std::int32_t piece) { return pieces_[std::size_t(piece)]; }

 private:
  Array<Piece> pieces_;
  Array<std::int32_t> free_;
};

}  // namespace halfspace
