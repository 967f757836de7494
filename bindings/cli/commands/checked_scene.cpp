#include "commands/checked_scene.h"

#include <algorithm>
#include <cstdio>

#include "common/files.h"
#include "scene/read_scene.h"

namespace halfspace::cli {

namespace {

std::string bytes_in(const SceneFile& file) { return file.content ? *file.content : content_of(file.path); }

}  // namespace

void print(std::FILE* stream, const std::string& text) { std::fputs(text.c_str(), stream); }

CheckedScene read(const SceneFile& file, int threads) {
  CheckedScene checked;
  checked.scene = read_scene_text(bytes_in(file), file.path, checked.faults, file.settings);
  if (threads > 0) checked.scene.threads = threads;
  checked.context = make_context(checked.scene.threads);
  return checked;
}

void lay_out(CheckedScene& checked) {
  checked.layout = lay_out_blocks(checked.context, checked.scene, checked.faults);
}

CheckedScene load(const SceneFile& file, int threads) {
  CheckedScene checked = read(file, threads);
  lay_out(checked);
  return checked;
}

int refuse(const SceneFile& file, const Faults& faults) {
  print(stderr, faults.describe(file.path) + std::to_string(faults.count()) +
                    (faults.count() == 1 ? " fault in " : " faults in ") + file.path + '\n');
  return exit_failed;
}

std::string bytes_of(const SceneFile& file, const Scene& scene) {
  std::string bytes = bytes_in(file);
  for (const std::string& setting : file.settings) bytes += '\n' + setting;
  for (const Block& block : scene.blocks)
    if (!block.file.empty()) bytes += content_of(block.file);
  for (const Mesh& mesh : scene.meshes)
    if (!mesh.file.empty()) bytes += content_of(mesh.file);
  for (const Terrain& terrain : scene.terrains) bytes += content_of(terrain.file);
  for (const Action& action : scene.actions)
    if (!action.file.empty()) bytes += content_of(action.file);
  return bytes;
}

void require_free_block(CheckedScene& checked, const std::string& by) {
  const auto is_free = [](const LayoutBlock& block) { return moves_freely(block.kind); };
  const std::vector<LayoutBlock>& blocks = checked.layout.blocks;
  if (checked.faults.none() && std::none_of(blocks.begin(), blocks.end(), is_free))
    checked.faults.add({}, "", "no free block; required for " + by + ": a rigid, affine or mesh block");
}

}  // namespace halfspace::cli
