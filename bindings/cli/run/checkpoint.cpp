#include "run/checkpoint.h"

#include <cstdint>
#include <stdexcept>

#include "common/archive.h"
#include "common/files.h"
#include "common/hash.h"
#include "output/history.h"

namespace halfspace::cli {
namespace {

std::string first_line() { return std::string("halfspace checkpoint ") + hs_version() + '\n'; }

/// Blocks are alike if they have the same kinds, materials and vertices.
std::uint64_t hash_of_blocks(const Model& start) {
  Archive archive;
  for (const LayoutBlock& block : start.layout().blocks) {
    int kind = block.kind, material = block.material;
    archive.add(kind);
    archive.add(material);
  }
  Frame frame = start.frame();
  for (BlockFrame& block : frame.blocks) archive.add(block.vertices);
  return hash_of(archive.bytes());
}

}  // namespace

Fingerprint fingerprint(const Model& start, const Scene& scene) {
  Archive motions, history;
  for (const LayoutBlock& block : start.layout().blocks) {
    Motion motion = block.motion;
    if (block.kind == HS_BLOCK_PRESCRIBED) motions.add(motion);
  }
  for (Bolt bolt : scene.bolts) {
    motions.add(bolt.name);
    motions.add(bolt.def);
    motions.add(bolt.ends);
    for (std::string& block : bolt.blocks) motions.add(block);
  }
  std::string columns = History(scene, start).text();
  history.add(columns);
  for (LayoutPoint point : start.layout().points) history.add(point.at);
  for (LayoutJoint joint : start.layout().joints) {
    history.add(joint.block_a);
    history.add(joint.block_b);
  }
  return {hash_of_blocks(start), hash_of(start.snapshot()), hash_of(motions.bytes()),
          hash_of(history.bytes())};
}

std::string difference_of(const Fingerprint& one, const Fingerprint& other) {
  if (one.blocks != other.blocks) return "its blocks differ";
  if (one.world != other.world) return "its materials, laws, bonds or keys of [world] differ";
  if (one.motions != other.motions) return "its prescribed motions or bolts differ";
  if (one.history != other.history) return "its tracked blocks, points or joints differ";
  return {};
}

std::string sealed(const std::string& state) {
  Archive head;
  std::uint64_t hash = hash_of(state);
  std::size_t size = state.size();
  head.add(hash);
  head.add(size);
  std::string file = first_line() + head.bytes();
  file.reserve(file.size() + size);  // one copy only: states of large scenes have gigabytes
  return file.append(state);
}

std::string open_checkpoint(const std::string& file) {
  const std::string bytes = content_of(file);
  const std::string begin = "halfspace checkpoint ";
  if (!bytes.starts_with(begin)) throw std::runtime_error(file + " is not a checkpoint");
  if (!bytes.starts_with(first_line())) {
    throw std::runtime_error(file + " was written by version " +
                             bytes.substr(begin.size(), bytes.find('\n') - begin.size()).substr(0, 20) +
                             " of halfspace; required: by version " + hs_version());
  }
  Archive archive(bytes.substr(first_line().size()));
  std::uint64_t hash = 0;
  std::string state;
  try {
    archive.add(hash);
    archive.add(state);
  } catch (const std::runtime_error& error) {
    throw std::runtime_error("the checkpoint " + file + " is damaged: " + error.what());
  }
  if (hash != hash_of(state)) throw std::runtime_error("the checkpoint " + file + " is damaged");
  return state;
}

}  // namespace halfspace::cli
