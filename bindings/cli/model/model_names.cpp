#include <cstdlib>

#include "model/model.h"

namespace halfspace::cli {

std::string Model::name(hs_block block) const {
  const auto compound = index_of_compound_.find(block);
  if (compound == index_of_compound_.end()) return layout_.blocks[index_of(block)].name;
  const std::string& part = layout_.blocks[layout_.compounds[compound->second].first_block].name;
  return part.substr(0, part.rfind('.'));  // its parts are name.0, name.1, ...
}

std::vector<std::string> Model::names() const {
  std::vector<std::string> names;
  for (const hs_block block : all_records(context_, world_.get(), hs_world_get_blocks))
    names.push_back(name(block));
  return names;
}

std::string Model::with_names(const std::string& text) const {
  std::string named;
  std::size_t from = 0;
  for (std::size_t at = text.find("0x"); at != std::string::npos; at = text.find("0x", from)) {
    char* end = nullptr;
    const hs_block block = std::strtoull(text.c_str() + at, &end, 16);
    const auto behind = static_cast<std::size_t>(end - text.c_str());
    const bool is_block = index_of_block_.count(block) > 0 || index_of_compound_.count(block) > 0;
    named += text.substr(from, at - from);
    named += is_block ? '"' + name(block) + '"' : text.substr(at, behind - at);
    from = behind;
  }
  return named + text.substr(from);
}

}  // namespace halfspace::cli
