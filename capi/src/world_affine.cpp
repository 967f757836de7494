#include <cmath>

#include "halfspace/affine.h"
#include "sized_struct.h"
#include "tensor.h"
#include "world_handle.h"

using namespace halfspace;
using namespace halfspace::capi;

namespace halfspace::capi {

template <>
hs_elasticity_def default_definition() {
  hs_elasticity_def def{};
  def.young_modulus = 1e9;
  def.poisson_ratio = 0.25;
  return def;
}

namespace {

Elasticity read_elasticity(const hs_elasticity_def* given, int dimension) {
  const hs_elasticity_def def = read_definition(given, "elasticity");
  if (def.plane != HS_PLANE_STRAIN && !(dimension == 2 && def.plane == HS_PLANE_STRESS)) {
    refuse(HS_ERROR_ARGUMENT, "elasticity.plane is %d; it must be %s", def.plane,
           dimension == 2 ? "HS_PLANE_STRAIN or HS_PLANE_STRESS" : "HS_PLANE_STRAIN in 3D");
  }
  const double young = require_above_zero(def.young_modulus, "elasticity.young_modulus");
  const double poisson = require(def.poisson_ratio > -1 && def.poisson_ratio < 0.5, def.poisson_ratio,
                                 "elasticity.poisson_ratio", "above -1 and below 0.5");
  Elasticity elasticity;
  elasticity.lame = def.plane == HS_PLANE_STRESS ? young * poisson / (1 - poisson * poisson)
                                                 : young * poisson / ((1 + poisson) * (1 - 2 * poisson));
  elasticity.shear_modulus = young / (2 * (1 + poisson));
  require(elasticity.shear_modulus > 0, young, "elasticity.young_modulus",
          "so large that the shear modulus is above 0");
  elasticity.damping_time = require_from_zero(def.damping_time, "elasticity.damping_time");
  elasticity.young_modulus = young;
  elasticity.poisson_ratio = poisson;
  elasticity.is_plane_stress = def.plane == HS_PLANE_STRESS;
  return elasticity;
}

template <int D>
std::size_t affine_slot_of(const World<D>& world, hs_block block) {
  const std::size_t slot = std::size_t(slot_of(world.blocks(), block, "block"));
  if (!world.blocks().is_affine(slot))
    refuse(HS_ERROR_STATE, "block %#llx is not affine", static_cast<unsigned long long>(block));
  return slot;
}

template <int D>
hs_deformation deformation_of(const World<D>& world, std::size_t slot) {
  const Blocks<D>& blocks = world.blocks();
  hs_deformation out{};
  out.gradient[8] = 1;
  if (!blocks.is_deformable(slot)) {
    const Tensor<D> rotation = blocks.rotation[slot].tensor();
    write_tensor<D>(rotation, out.gradient);
    write_tensor<D>(cross_tensor(blocks.spin[slot]) * rotation, out.rate);
    return out;
  }
  const Deformation<D>& deformation = blocks.deformation(slot);
  const Elasticity& elasticity = world.model().materials.elasticity(blocks.material[slot]);
  write_tensor<D>(deformation.gradient, out.gradient);
  write_tensor<D>(deformation.rate, out.rate);
  write_tensor<D>(deformation.strain(), out.strain);
  write_tensor<D>(deformation.stress(elasticity), out.stress);
  out.strain_energy = deformation.strain_energy(elasticity);
  return out;
}

}  // namespace
}  // namespace halfspace::capi

hs_status hs_elasticity_def_init(hs_elasticity_def* def, size_t size) { return write_definition(def, size); }

hs_status hs_world_set_elasticity(hs_world* world, int32_t material, const hs_elasticity_def* elasticity) {
  return with_world_between_steps(world, __func__, [&]<int D>(World<D>& w) {
    require_material(w, material, "material");
    if (!w.set_elasticity(material, read_elasticity(elasticity, D))) {
      refuse(HS_ERROR_ARGUMENT,
             "elasticity.young_modulus is %g; it makes the stiffness of a cell of material %d too large to "
             "compute; decrease it",
             elasticity->young_modulus, material);
    }
    return HS_OK;
  });
}

hs_status hs_world_get_deformation(const hs_world* world, hs_block block, hs_deformation* deformation) {
  return with_world(world, __func__, [&]<int D>(const World<D>& w) {
    require_pointer(deformation, "deformation");
    *deformation = deformation_of(w, std::size_t(slot_of(w.blocks(), block, "block")));
    return HS_OK;
  });
}

hs_status hs_world_get_deformations(const hs_world* world, hs_deformation deformations[], int64_t capacity,
                                    int64_t* count) {
  return with_world(world, __func__, [&]<int D>(const World<D>& w) {
    require_count(capacity, "capacity");
    if (capacity > 0) require_pointer(deformations, "deformations");
    return write_blocks(w.blocks(), capacity, count,
                        [&](std::int64_t i, std::size_t slot) { deformations[i] = deformation_of(w, slot); });
  });
}

hs_status hs_world_set_deformation(hs_world* world, hs_block block, const double gradient[9],
                                   const double rate[9]) {
  return with_world(world, __func__, [&]<int D>(World<D>& w) {
    require_joined(w);
    const std::size_t slot = affine_slot_of(w, block);
    const Tensor<D> to = read_finite_tensor<D>(gradient, "gradient");
    const Tensor<D> speed = read_finite_tensor<D>(rate, "rate");
    require_gradient<D>(to, "gradient");
    w.set_deformation(std::int32_t(slot), to, speed);
    return HS_OK;
  });
}

hs_status hs_world_set_stress(hs_world* world, hs_block block, const double stress[9]) {
  return with_world(world, __func__, [&]<int D>(World<D>& w) {
    require_joined(w);
    const std::size_t slot = affine_slot_of(w, block);
    const Tensor<D> wanted = read_symmetric_tensor<D>(stress, "stress");
    w.set_stress(std::int32_t(slot), wanted);
    return HS_OK;
  });
}

hs_status hs_world_add_surface_load(hs_world* world, hs_block block, int32_t face, const double traction[3]) {
  return with_world_between_steps(world, __func__, [&]<int D>(World<D>& w) {
    const std::size_t slot = affine_slot_of(w, block);
    const int faces = w.blocks().outline(std::int32_t(slot)).face_count();
    if (face < 0 || face >= faces)
      refuse(HS_ERROR_ARGUMENT, "face is %d; the block has %d faces", face, faces);
    w.add_surface_load(std::int32_t(slot), face, read_finite_vector<D>(traction, "traction"));
    return HS_OK;
  });
}

hs_status hs_world_clear_surface_loads(hs_world* world, hs_block block) {
  return with_world_between_steps(world, __func__, [&]<int D>(World<D>& w) {
    w.clear_surface_loads(std::int32_t(affine_slot_of(w, block)));
    return HS_OK;
  });
}
