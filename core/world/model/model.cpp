#include "world/model/model.h"

namespace halfspace {
namespace {

double edge_length(const Outline<2>& o, int i) { return (o.vertex(o.next(i)) - o.vertex(i)).norm(); }
double edge_length(const Outline<3>& o, int i) {
  return (o.vertex(o.topology->edge_end[i]) - o.vertex(o.topology->edge_start[i])).norm();
}

template <int D>
double mean_edge_length(const Blocks<D>& blocks) {
  double sum = 0;
  std::int64_t edges = 0;
  for (std::size_t slot = 0; slot < blocks.slot_count(); ++slot) {
    if (!blocks.lives(slot)) continue;
    const Outline<D> outline = blocks.outline(std::int32_t(slot));
    for (int i = 0; i < outline.edge_count(); ++i) sum += edge_length(outline, i);
    edges += outline.edge_count();
  }
  return edges > 0 ? sum / double(edges) : 0;
}

}  // namespace

template <int D>
double Model<D>::potential_length() const {
  if (settings.potential_length > 0) return settings.potential_length;
  return fixed_length > 0 ? fixed_length : mean_edge_length(blocks);
}

template struct Model<2>;
template struct Model<3>;

}  // namespace halfspace
