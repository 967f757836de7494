#pragma once

#include "block/mesh/mesh.h"
#include "block/mesh/surface.h"
#include "context_handle.h"
#include "guard.h"
#include "halfspace/mesh.h"
#include "require.h"

/// Members of handles of both dimensions. MeshHandle adds the mesh.
struct hs_mesh {
  hs_context* context;
  std::int32_t dimension;
  std::int64_t surface_face_count;
};

namespace halfspace::capi {

/// Handle with its mesh.
template <int D>
struct MeshHandle : hs_mesh {
  MeshHandle(hs_context* owner, Mesh<D>&& made)
      : hs_mesh{owner, D, std::int64_t(surface_of(made, &owner->memory).size())}, mesh(std::move(made)) {}

  Mesh<D> mesh;
};

inline hs_context* context_of(const hs_mesh* mesh) { return mesh ? mesh->context : nullptr; }

/// Calls use(mesh) with the Mesh<2> or Mesh<3> of the handle.
template <class Use>
auto visit(const hs_mesh& handle, Use&& use) {
  return handle.dimension == 2 ? use(static_cast<const MeshHandle<2>&>(handle).mesh)
                               : use(static_cast<const MeshHandle<3>&>(handle).mesh);
}

/// Returns the mesh for a body in a world of D dimensions; refuses the other dimension.
template <int D>
const Mesh<D>& require_mesh(const hs_mesh* mesh) {
  require_pointer(mesh, "mesh");
  if (mesh->dimension != D)
    refuse(HS_ERROR_ARGUMENT, "mesh has dimension %d; the world has %d", mesh->dimension, D);
  return static_cast<const MeshHandle<D>&>(*mesh).mesh;
}

}  // namespace halfspace::capi
