#pragma once

namespace halfspace {

/// The work of the impulses of a contact, J.
struct ImpulseWork {
  double normal = 0;
  double friction = 0;
  double outer = 0;  // by prescribed blocks
  double size = 0;   // the sum of the magnitudes of all terms

  double sum() const { return normal + friction; }
  /// Between -1 and 1.
  double ratio() const { return size > 0 ? sum() / size : 0; }
  void add(const ImpulseWork& more) {
    normal += more.normal;
    friction += more.friction;
    outer += more.outer;
    size += more.size;
  }
};

}  // namespace halfspace
