#include "model/model.h"

namespace halfspace::cli {

std::vector<std::string> Model::names() const {
  std::vector<std::string> names;
  for (const hs_block block : all_records(context_, world_.get(), hs_world_get_blocks)) {
    const auto compound = index_of_compound_.find(block);
    if (compound == index_of_compound_.end()) {
      names.push_back(layout_.blocks[index_of(block)].name);
    } else {  // its parts are name.0, name.1, ...
      const std::string& part = layout_.blocks[layout_.compounds[compound->second].first_block].name;
      names.push_back(part.substr(0, part.rfind('.')));
    }
  }
  return names;
}

}  // namespace halfspace::cli
