#include "common/files.h"
#include "interface/scene_handle.h"
#include "output/vtk_series.h"
#include "output/vtk_world.h"

using namespace halfspace::cli;

hs_status hs_scene_write_vtk(hs_scene* scene, hs_context* context, const hs_world* world,
                             const hs_pose* start, const char* blocks, const char* contacts) {
  return guarded(scene, [&] {
    require_given(context, "context");
    require_given(world, "world");
    require_given(blocks, "blocks");
    const WorldPicture picture = picture_of(borrowed(context), world, start);
    write_file(blocks,
               vtk_polygons(picture.layout, picture.frame, picture.start, {0, picture.layout.blocks.size()}));
    if (contacts) write_file(contacts, vtk_contacts(picture.frame));
  });
}
