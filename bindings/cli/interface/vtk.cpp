#include <filesystem>

#include "common/files.h"
#include "interface/scene_handle.h"
#include "output/vtk_series.h"
#include "output/vtk_world.h"

namespace halfspace::cli {
namespace {

void write(const std::filesystem::path& file, const std::string& content) {
  const std::filesystem::path folder = file.has_parent_path() ? file.parent_path() : ".";
  OutputDirectory(folder, Earlier::keep).write(file.filename().string(), content);
}

}  // namespace
}  // namespace halfspace::cli

using namespace halfspace::cli;

hs_status hs_scene_write_vtk(hs_scene* scene, hs_context* context, const hs_world* world,
                             const hs_pose* start, const char* blocks, const char* contacts) {
  return guarded(scene, [&] {
    require_given(context, "context");
    require_given(world, "world");
    require_given(blocks, "blocks");
    const WorldPicture picture = picture_of(borrowed(context), world, start);
    write(blocks,
          vtk_polygons(picture.layout, picture.frame, picture.start, {0, picture.layout.blocks.size()}));
    if (contacts) write(contacts, vtk_contacts(picture.frame));
  });
}
