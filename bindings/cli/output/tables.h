#pragma once

#include <string>

#include "model/model.h"

namespace halfspace::cli {

/// blocks.csv: the number, name, kind and material of each block.
std::string blocks_table(const Scene& scene, const Layout& layout);

/// contacts.csv: a row for each contact of a frame.
std::string contacts_table(const Layout& layout, const Frame& frame);

/// cracks.csv: a row for each point of a bond that has failed so far, in order of time.
std::string cracks_table(const Model& model);

}  // namespace halfspace::cli
