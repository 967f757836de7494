#include <algorithm>
#include <limits>
#include <map>
#include <set>
#include <string>
#include <utility>

#include "common/text.h"
#include "notes/kinds.h"
#include "notes/separation.h"

namespace halfspace::cli {
namespace {

using Pair = std::pair<std::size_t, std::size_t>;

/// Max gap of faces that are probably meant to be bonded, as a fraction of the thinner block's thickness.
/// Faces cut by one joint have a gap of rounding only.
constexpr double reported_fraction = 0.01;

class BondNotes {
 public:
  BondNotes(const Start& start, Faults& faults)
      : start_(start), faults_(faults), bodies_(convex_bodies(start)) {
    for (std::int64_t i = 0; i < start.model.bond_report().bond_count; ++i) {
      const Pair& pair = start.model.blocks_of_bond(static_cast<std::size_t>(i));
      bonded_.insert(std::minmax(pair.first, pair.second));
      ++count_of_[std::minmax(material(pair.first), material(pair.second))];
    }
    near_ = neighbours_within(start, bodies_, reported_fraction);
  }

  void check(std::size_t index) {
    const PairBond& bond = start_.scene.bonds[index];
    const std::pair<int, int> materials = std::minmax(bond.a, bond.b);
    const std::string key = "bond[" + std::to_string(index) + "].between";
    const auto note = [&](const std::string& text) { faults_.note(bond.place, key, text); };
    if (bond.def.tensile_strength == 0 && bond.def.cohesion == 0)
      note("its bonds have neither tensile_strength nor cohesion and fail at once; usual: both above 0");
    if (!seen_.insert(materials).second) {
      note("an earlier [[bond]] joins these materials; this one makes no bond");
    } else if (count_of_[materials] > 0) {
      note_gaps(materials, note);
    } else {
      note(no_bond(materials));
    }
  }

 private:
  int material(std::size_t block) const { return start_.layout.blocks[block].material; }
  const std::string& name(std::size_t block) const { return start_.layout.blocks[block].name; }

  bool joins(const std::pair<int, int>& materials, std::size_t a, std::size_t b) const {
    const auto &one = start_.layout.blocks[a], &other = start_.layout.blocks[b];
    const bool is_one_body =
        (one.body && one.body == other.body) || (one.compound && one.compound == other.compound);
    const bool moves = moves_freely(one.kind) || moves_freely(other.kind);
    const std::pair<int, int> both = std::minmax(one.material, other.material);
    return both == materials && !is_one_body && moves;
  }

  /// Notes pairs with a small gap, where other pairs are bonded.
  template <class Note>
  void note_gaps(const std::pair<int, int>& materials, Note note) const {
    std::size_t count = 0;
    const Neighbours* widest = nullptr;
    for (const Neighbours& pair : near_) {
      const Body &a = start_.bodies[pair.a], &b = start_.bodies[pair.b];
      const bool is_gap = pair.separation > 0 &&
                          is_beyond_rounding(pair.separation, std::min(a.thickness, b.thickness), a, b);
      if (!is_gap || !joins(materials, pair.a, pair.b) || bonded_.contains({pair.a, pair.b})) continue;
      ++count;
      if (!widest || pair.separation > widest->separation) widest = &pair;
    }
    if (!widest) return;
    note(counted(count, "pair") + " of blocks without a bond, up to " + rounded(widest->separation, 3) +
         " m apart, as " + quoted(name(widest->b)) + " and " + quoted(name(widest->a)) +
         "; usual: common faces in one plane");
  }

  std::string no_bond(const std::pair<int, int>& materials) const {
    for (const int material : {materials.first, materials.second}) {
      const bool is_used = std::any_of(start_.layout.blocks.begin(), start_.layout.blocks.end(),
                                       [&](const LayoutBlock& block) { return block.material == material; });
      if (!is_used)
        return "no block is of " + quoted(start_.scene.materials[static_cast<std::size_t>(material)].name) +
               ", so that no bond is made";
    }
    const Neighbours nearest = nearest_of(materials);
    std::string text = "no two blocks of these materials have a common face, so that no bond is made";
    if (nearest.separation > 0 && nearest.separation < std::numeric_limits<double>::infinity())
      text += "; the nearest two, " + quoted(name(nearest.b)) + " and " + quoted(name(nearest.a)) + ", are " +
              rounded(nearest.separation, 3) + " m apart";
    return text + "; usual: faces in one plane, to a millionth of a block";
  }

  Neighbours nearest_of(const std::pair<int, int>& materials) const {
    Neighbours nearest{0, 0, std::numeric_limits<double>::infinity()};
    const auto compare = [&](std::size_t a, std::size_t b) {
      if (!joins(materials, a, b)) return;
      const double apart = separation(bodies_[a], bodies_[b]);
      if (apart < nearest.separation) nearest = {a, b, apart};
    };
    for (const Neighbours& pair : near_) compare(pair.a, pair.b);
    constexpr std::size_t max_pairs = 1'000'000;
    const std::size_t count = bodies_.size();
    if (nearest.separation < std::numeric_limits<double>::infinity() || count * count > max_pairs)
      return nearest;
    for (std::size_t b = 0; b < count; ++b)
      for (std::size_t a = 0; a < b; ++a) compare(a, b);
    return nearest;
  }

  const Start& start_;
  Faults& faults_;
  std::vector<ConvexBody> bodies_;
  std::vector<Neighbours> near_;
  std::set<Pair> bonded_;
  std::map<std::pair<int, int>, std::size_t> count_of_;
  std::set<std::pair<int, int>> seen_;
};

}  // namespace

void note_bonds(const Start& start, Faults& faults) {
  if (start.scene.bonds.empty() || start.layout.blocks.size() > max_compared_blocks) return;
  BondNotes notes(start, faults);
  for (std::size_t i = 0; i < start.scene.bonds.size(); ++i) notes.check(i);
}

}  // namespace halfspace::cli
