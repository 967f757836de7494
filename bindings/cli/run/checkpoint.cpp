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

}  // namespace

std::string fingerprint(const Scene& scene, const Model& start) {
  Archive archive;
  for (std::uint64_t hash : {hash_of(start.snapshot()), hash_of(History(scene, start.layout()).text())})
    archive.add(hash);
  for (const LayoutBlock& block : start.layout().blocks) {
    Motion motion = block.motion;
    if (block.kind == HS_BLOCK_PRESCRIBED) archive.add(motion);
  }
  for (Bolt bolt : scene.bolts) {
    archive.add(bolt.name);
    archive.add(bolt.def);
    archive.add(bolt.ends);
    for (std::string& block : bolt.blocks) archive.add(block);
  }
  std::uint64_t hash = hash_of(archive.bytes());
  Archive whole;
  whole.add(hash);
  return whole.bytes();
}

std::string sealed(const std::string& state) {
  Archive archive;
  std::uint64_t hash = hash_of(state);
  std::string content = state;
  archive.add(hash);
  archive.add(content);
  return first_line() + archive.bytes();
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
