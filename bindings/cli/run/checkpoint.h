#pragma once

#include <cstdint>
#include <string>

#include "model/model.h"
#include "scene/scene.h"

namespace halfspace::cli {

/// The name of a run's checkpoint in its directory.
inline constexpr const char* checkpoint_name = "checkpoint";

/// Hashes of everything that a checkpoint and a run that resumes from it have in common. Later stages,
/// durations and output may differ.
struct Fingerprint {
  std::uint64_t blocks = 0;   ///< kinds, materials, shapes and places
  std::uint64_t world = 0;    ///< the whole initial world
  std::uint64_t motions = 0;  ///< of prescribed blocks, and bolts
  std::uint64_t history = 0;  ///< its columns, with the tracked points and joints
};

Fingerprint fingerprint(const Model& start, const Scene& scene);

/// Names what differs; empty if nothing does.
std::string difference_of(const Fingerprint& one, const Fingerprint& other);

/// The state of a run with a version line and a checksum.
std::string sealed(const std::string& state);

/// The state in a checkpoint. @throws std::runtime_error if the file cannot be read, is damaged, or is no
/// checkpoint
std::string open_checkpoint(const std::string& file);

}  // namespace halfspace::cli
