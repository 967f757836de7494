#include <iterator>
#include <numbers>

#include "halfspace/check.h"
#include "strided_view.h"
#include "world_handle.h"

using namespace halfspace;
using namespace halfspace::capi;

namespace {

struct Usual {
  double low, high;
  const char* text;
};

constexpr double degree = std::numbers::pi / 180;

/// The one table of usual ranges, by HS_SETTING_ values.
constexpr Usual usual_values[] = {
    {1, 25, "9.81 m/s2, 1.62 on the moon"},
    {0, 100, "up to 100 1/s"},
    {0.05 * degree, 28 * degree, "0, or 0.00087 to 0.49 rad, which is 0.05 to 28 degrees"},
    {50, 19500, "50 to 19500 kg/m3, 2700 of rock"},
    {1e6, 2e12, "1e6 to 2e12 Pa, 5e10 of rock"},
    {0, 0.495, "0 to 0.49"},
    {0, 0.02, "up to 0.02 s"},
    {1e3, 1e14, "1e3 to 1e14 in N/m, Pa/m or Pa"},
    {1e2, 1e14, "0, or 1e2 to 1e14 in N/m or Pa/m"},
    {2 * degree, 75 * degree, "0, or 0.035 to 1.3 rad, which is 2 to 75 degrees"},
    {100, 1e9, "0, or 100 to 1e9 Pa"},
    {100, 1e9, "0, or 100 to 1e9 Pa"},
    {0, 1, "0 to 1, a fraction of critical damping"},
    {0, 1, "0 to 1, a fraction of critical damping"},
    {1e6, 1e17, "1e6 to 1e17 Pa/m"},
    {1e5, 1e17, "0, or 1e5 to 1e17 Pa/m"},
    {0.1, 1e6, "0, or 0.1 to 1e6 J/m2"},
    {0.1, 1e6, "0, or 0.1 to 1e6 J/m2"},
    {0, 1000, "up to 1000 m/s"},
};
static_assert(std::size(usual_values) == HS_SETTING_VELOCITY + 1);

const Usual* usual_of(std::int32_t setting) {
  return setting >= 0 && setting <= HS_SETTING_VELOCITY ? &usual_values[setting] : nullptr;
}

/// Writes as many notes as fit.
class Notes {
 public:
  Notes(hs_note* notes, std::int64_t capacity) : notes_(notes), capacity_(capacity) {}

  struct Owner {
    std::int32_t material_a = -1, material_b = -1;
    hs_block block = 0;
  };

  void look_at(std::int32_t setting, double value, const Owner& owner) {
    const auto& [low, high, text] = usual_values[setting];
    if (value == 0 || (value >= low && value <= high)) return;
    if (count_ < capacity_)
      notes_[count_] = {setting, owner.material_a, owner.material_b, 0, owner.block, value, low, high};
    ++count_;
  }
  void look_at(const ContactLaw& law, const Owner& owner) {
    if (!law.has_no_spring()) {
      look_at(HS_SETTING_NORMAL_STIFFNESS, law.normal_stiffness, owner);
      look_at(HS_SETTING_SHEAR_STIFFNESS, law.given.shear_stiffness, owner);
      look_at(HS_SETTING_NORMAL_DAMPING, law.normal_damping, owner);
      look_at(HS_SETTING_SHEAR_DAMPING, law.shear_damping, owner);
    }
    look_at(HS_SETTING_FRICTION_ANGLE, law.given.friction_angle, owner);
    look_at(HS_SETTING_COHESION, law.given.cohesion, owner);
    look_at(HS_SETTING_TENSILE_STRENGTH, law.given.tensile_strength, owner);
  }
  template <int D>
  void look_at(const WorldSettings<D>& settings) {
    look_at(HS_SETTING_GRAVITY, settings.gravity.norm(), {});
    look_at(HS_SETTING_MASS_DAMPING, settings.mass_damping, {});
    look_at(HS_SETTING_PARALLEL_ANGLE, settings.detect.parallel_angle, {});
  }
  void look_at(const Materials& materials) {
    look_at(materials.laws().default_law(), {});
    for (std::int32_t i = 0; i < materials.count(); ++i) {
      const Elasticity& elasticity = materials.elasticity(i);
      look_at(HS_SETTING_DENSITY, materials.density(i), {i});
      look_at(HS_SETTING_YOUNG_MODULUS, elasticity.young_modulus, {i});
      look_at(HS_SETTING_POISSON_RATIO, elasticity.poisson_ratio, {i});
      look_at(HS_SETTING_DAMPING_TIME, elasticity.damping_time, {i});
    }
    for (std::int32_t b = 0; b < materials.count(); ++b) {
      for (std::int32_t a = 0; a <= b; ++a)
        if (materials.laws().has_own(a, b)) look_at(materials.laws().between(a, b), {a, b});
    }
  }
  /// Cells of meshes and parts of compounds do not move by themselves.
  template <int D>
  void look_at(const Blocks<D>& blocks) {
    for_each_block(blocks, [&](std::int64_t, std::int32_t slot) {
      const std::size_t s = std::size_t(slot);
      if (blocks.is_of_mesh(s) || blocks.is_part(s)) return;
      look_at(HS_SETTING_VELOCITY, blocks.velocity[s].norm(), {.block = id_of(blocks, s)});
    });
  }

  std::int64_t count() const { return count_; }

 private:
  hs_note* notes_;
  std::int64_t capacity_, count_ = 0;
};

}  // namespace

hs_status hs_setting_get_usual(int32_t setting, double* low, double* high) {
  const Usual* const usual = usual_of(setting);
  if (!usual || !low || !high) return HS_ERROR_ARGUMENT;
  *low = usual->low;
  *high = usual->high;
  return HS_OK;
}

const char* hs_setting_usual_text(int32_t setting) {
  const Usual* const usual = usual_of(setting);
  return usual ? usual->text : "";
}

hs_status hs_world_check(const hs_world* world, hs_note notes[], int64_t capacity, int64_t* count) {
  return with_world(world, __func__, [&]<int D>(const World<D>& w) {
    require_count(capacity, "capacity");
    if (capacity > 0) require_pointer(notes, "notes");
    Notes found(notes, capacity);
    found.look_at(w.model().settings);
    found.look_at(w.model().materials);
    found.look_at(w.blocks());
    if (count) *count = found.count();
    return fits(found.count(), capacity);
  });
}
