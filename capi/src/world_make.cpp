#include <cstddef>

#include "block_definition.h"
#include "law_numbers.h"
#include "pair_arguments.h"

using namespace halfspace;
using namespace halfspace::capi;

namespace halfspace::capi {

template <>
hs_world_def default_definition() {
  const WorldSettings<2> defaults;  // the same in both dimensions, except gravity
  hs_world_def def{};
  def.safety = defaults.safety;
  def.skin = defaults.skin;
  def.parallel_angle = defaults.detect.parallel_angle;
  def.vertex_zone = defaults.detect.vertex_zone;
  def.impulse_tolerance = defaults.impulse_tolerance;
  def.max_impulse_iterations = defaults.max_impulse_iterations;
  return def;
}

template <>
hs_law_def default_definition() {
  hs_law_def def{};
  write_numbers({}, def);
  return def;
}

template <>
hs_block_def default_definition() {
  hs_block_def def{};
  def.kind = HS_BLOCK_RIGID;
  def.pose.rotation[3] = 1;
  return def;
}

namespace {

constexpr std::size_t end_of_gravity = offsetof(hs_world_def, gravity) + sizeof hs_world_def::gravity;

bool is_dimension(int32_t number) { return number == 2 || number == 3; }

/// Sets the default gravity, which depends on the dimension.
void point_gravity_down(hs_world_def& def) { def.gravity[def.dimension - 1] = -9.81; }

template <int D>
WorldSettings<D> read_settings(const hs_world_def& def) {
  WorldSettings<D> settings;
  settings.gravity = read_finite_vector<D>(def.gravity, "def.gravity");
  settings.time_step = require_from_zero(def.time_step, "def.time_step");
  settings.safety =
      require(def.safety > 0 && def.safety <= 1, def.safety, "def.safety", "above 0 and at most 1");
  settings.local_damping = require(def.local_damping >= 0 && def.local_damping < 1, def.local_damping,
                                   "def.local_damping", "at least 0 and below 1");
  settings.mass_damping = require_from_zero(def.mass_damping, "def.mass_damping");
  settings.skin = require(def.skin > 0 && def.skin <= 1, def.skin, "def.skin", "above 0 and at most 1");
  settings.potential_length = require_from_zero(def.potential_length, "def.potential_length");
  settings.detect = read_detect_options(def.parallel_angle, def.vertex_zone);
  if (def.fast_blocks != HS_FAST_DIVIDE && def.fast_blocks != HS_FAST_REFUSE) {
    refuse(HS_ERROR_ARGUMENT, "def.fast_blocks is %d; it must be an HS_FAST_ value", def.fast_blocks);
  }
  settings.fast_blocks = FastBlocks(def.fast_blocks);
  settings.sleep_tolerance = require_from_zero(def.sleep_tolerance, "def.sleep_tolerance");
  settings.impulse_tolerance = require_above_zero(def.impulse_tolerance, "def.impulse_tolerance");
  if (def.max_impulse_iterations < 1) {
    refuse(HS_ERROR_ARGUMENT, "def.max_impulse_iterations is %d; it must be at least 1",
           def.max_impulse_iterations);
  }
  settings.max_impulse_iterations = def.max_impulse_iterations;
  if (def.locate_impacts != 0 && def.locate_impacts != 1) {
    refuse(HS_ERROR_ARGUMENT, "def.locate_impacts is %d; it must be 0 or 1", def.locate_impacts);
  }
  settings.locate_impacts = def.locate_impacts;
  return settings;
}

ContactLaw read_law(const hs_law_def* given) {
  const hs_law_def def = read_definition(given, "law");
  if (def.stiffness_kind < HS_STIFFNESS_PER_CONTACT ||
      StiffnessKind(def.stiffness_kind) > StiffnessKind::last) {
    refuse(HS_ERROR_ARGUMENT, "law.stiffness_kind is %d; it must be an HS_STIFFNESS_ value",
           def.stiffness_kind);
  }
  return ContactLaw(StiffnessKind(def.stiffness_kind), read_numbers(def));
}

/// Refuses a share's first law of potentials without its length, where blocks have deformed since the share
/// took the mean edge of all.
template <int D>
void require_known_length(const World<D>& w, const ContactLaw& law) {
  if (w.state().share.is_whole() || !law.is_potential() || w.model().materials.laws().knows_potential())
    return;
  if (!w.blocks().deformations().empty() && !(w.model().settings.potential_length > 0))
    refuse(HS_ERROR_STATE,
           "law is of potentials; a share with affine blocks needs potential_length in hs_world_def");
}

}  // namespace
}  // namespace halfspace::capi

hs_status hs_world_def_init(hs_world_def* def, size_t size, int32_t dimension) {
  if (!is_dimension(dimension) || size < end_of_gravity) return HS_ERROR_ARGUMENT;
  const hs_status status = write_definition(def, size);
  if (status == HS_OK) {
    def->dimension = dimension;
    point_gravity_down(*def);
  }
  return status;
}

hs_status hs_law_def_init(hs_law_def* def, size_t size) { return write_definition(def, size); }

hs_status hs_block_def_init(hs_block_def* def, size_t size, const hs_shape* shape) {
  constexpr std::size_t up_to_pose = offsetof(hs_block_def, pose) + sizeof(hs_pose);
  if (!shape || size < up_to_pose) return HS_ERROR_ARGUMENT;
  const hs_status status = write_definition(def, size);
  if (status == HS_OK) {
    visit(*shape, [&](const auto& form) { write_vector(form.centroid(), def->pose.position); });
  }
  return status;
}

hs_status hs_world_create(hs_context* context, const hs_world_def* def, hs_world** world) {
  return guarded(context, __func__, [&] {
    require_pointer(context, "context");
    require_pointer(world, "world");
    hs_world_def known = read_definition(def, "def");
    if (is_dimension(known.dimension) && def->struct_size < end_of_gravity) point_gravity_down(known);
    if (known.dimension == 2) {
      *world = create<WorldHandle<2>>(context, context, read_settings<2>(known));
    } else if (known.dimension == 3) {
      *world = create<WorldHandle<3>>(context, context, read_settings<3>(known));
    } else {
      refuse(HS_ERROR_ARGUMENT, "def.dimension is %d; it must be 2 or 3", known.dimension);
    }
    return HS_OK;
  });
}

void hs_world_destroy(hs_world* world) {
  if (!world) return;
  if (world->dimension == 2) {
    destroy(world->context, static_cast<WorldHandle<2>*>(world));
  } else {
    destroy(world->context, static_cast<WorldHandle<3>*>(world));
  }
}

hs_status hs_world_add_material(hs_world* world, double density, int32_t* material) {
  return with_world_between_steps(world, __func__, [&]<int D>(World<D>& w) {
    require_pointer(material, "material");
    require_above_zero(density, "density");
    *material = w.add_material(density);
    return HS_OK;
  });
}

hs_status hs_world_set_default_law(hs_world* world, const hs_law_def* law) {
  return with_world_between_steps(world, __func__, [&]<int D>(World<D>& w) {
    const ContactLaw read = read_law(law);
    require_known_length(w, read);
    w.set_default_law(read);
    return HS_OK;
  });
}

hs_status hs_world_set_law(hs_world* world, int32_t material_a, int32_t material_b, const hs_law_def* law) {
  return with_world_between_steps(world, __func__, [&]<int D>(World<D>& w) {
    require_material(w, material_a, "material_a");
    require_material(w, material_b, "material_b");
    const ContactLaw read = read_law(law);
    require_known_length(w, read);
    w.set_law(material_a, material_b, read);
    return HS_OK;
  });
}

hs_status hs_world_add_block(hs_world* world, const hs_shape* shape, const hs_block_def* def,
                             hs_block* block) {
  return with_world(world, __func__, [&]<int D>(World<D>& w) {
    require_joined(w);
    const Shape<D>& form = require_shape<D>(shape, "shape");
    require_pointer(block, "block");
    const BlockStart<D> start = read_block(w, def, form.bounding_radius(), HS_BLOCK_AFFINE,
                                           "an HS_BLOCK_ value other than HS_BLOCK_MESH");
    const double density = w.model().materials.density(start.material), mass = mass_of(form, density);
    const Inertia<D> inertia = Inertia<D>::of(form, density);
    require_mass(mass, inertia, "shape");
    if (start.kind == BlockKind::affine && !w.model().materials.elasticity(start.material).is_given()) {
      refuse(HS_ERROR_STATE,
             "def.material is %d, which has no elasticity; call hs_world_set_elasticity() first",
             start.material);
    }
    require_energy(mass, inertia, start.pose.rotation, start.velocity, start.spin, "def.");
    const std::int32_t slot =
        w.add_block(form, start.kind, start.material, start.pose.position, start.pose.rotation);
    w.set_velocity(slot, start.velocity, start.spin);
    *block = id_of(w.blocks(), std::size_t(slot));
    return HS_OK;
  });
}

hs_status hs_world_remove_block(hs_world* world, hs_block block) {
  return with_world(world, __func__, [&]<int D>(World<D>& w) {
    require_joined(w);
    const std::int32_t slot = slot_of(w.blocks(), block, "block");
    require_moved_by_itself(w.blocks(), slot, "block");
    w.blocks().is_compound(std::size_t(slot)) ? w.remove_compound(slot) : w.remove_block(slot);
    return HS_OK;
  });
}
