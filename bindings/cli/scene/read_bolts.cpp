#include "scene/read_bolts.h"

#include <algorithm>

#include "common/suggestion.h"
#include "scene/read_values.h"

namespace halfspace::cli {
namespace {

hs_bolt_def read_forces(Keys& keys) {
  hs_bolt_def def;
  hs_bolt_def_init(&def, sizeof def);
  def.stiffness = keys.number("stiffness", above(0), required);
  def.is_tension_only = keys.word("bears", {"both", "tension"}, def.is_tension_only);
  def.yield_force = keys.number("yield_force", at_least(0), def.yield_force);
  Range tension = def.is_tension_only != 0 ? at_least(0) : any_number();
  if (def.yield_force > 0) {
    tension.high = def.yield_force;
    tension.low = std::max(tension.low, -def.yield_force);
  }
  def.pretension = keys.number("pretension", tension, def.pretension);
  if (keys.has_any({"rupture_elongation"}))
    def.rupture_elongation =
        keys.number("rupture_elongation", above(std::max(def.pretension / def.stiffness, 0.0)), required);
  return def;
}

Bolt read_bolt(Keys& keys) {
  Bolt bolt{.name = read_name(keys)};
  std::size_t end = 0;
  for (const char* key : {"from", "to"}) {
    bolt.ends[end] = keys.point(key, required);
    bolt.keys[end] = keys.path(key);
    bolt.places[end] = keys.place(key);
    ++end;
  }
  if (keys.has("from") && keys.has("to") && bolt.ends[0] == bolt.ends[1])
    keys.fault("to", "the same place as from; allowed: another one, so that the bolt has a length");
  std::vector<Place> places;
  const std::vector<std::string> blocks = keys.texts("blocks", places, std::vector<std::string>{});
  if (blocks.size() == 2) {
    std::copy(blocks.begin(), blocks.end(), bolt.blocks.begin());
    for (std::size_t i = 0; i < 2; ++i) {
      bolt.keys[i] = keys.path("blocks");
      bolt.places[i] = places[i];
    }
    if (blocks[0] == blocks[1]) keys.fault("blocks", "the same twice; allowed: two, [\"a\", \"b\"]");
  } else if (!blocks.empty()) {
    keys.fault("blocks", std::to_string(blocks.size()) + " blocks; allowed: two, [\"a\", \"b\"]");
  }
  bolt.def = read_forces(keys);
  return bolt;
}

}  // namespace

void read_bolts(std::vector<Keys> tables, Scene& scene) {
  for (Keys& keys : tables) {
    Bolt bolt = read_bolt(keys);
    const bool twice = std::any_of(scene.bolts.begin(), scene.bolts.end(),
                                   [&](const Bolt& other) { return other.name == bolt.name; });
    if (twice && !bolt.name.empty())
      keys.fault("name", "used twice: \"" + bolt.name + "\"; allowed: a new name");
    scene.bolts.push_back(std::move(bolt));
    keys.finish();
  }
}

std::vector<std::size_t> read_installed(Keys& keys, Scene& scene) {
  std::vector<std::size_t> installed;
  std::vector<Place> places;
  std::vector<std::string_view> names;
  for (const Bolt& bolt : scene.bolts) names.push_back(bolt.name);
  for (const std::string& name : keys.texts("install", places, std::vector<std::string>{})) {
    const auto found = std::find(names.begin(), names.end(), name);
    if (found == names.end()) {
      if (!scene.has_all_names) continue;  // reported already
      keys.fault("install", "no such bolt: \"" + name + '"' + suggestion(name, names) +
                                "; allowed: the name of a [[bolt]]");
      continue;
    }
    const auto index = static_cast<std::size_t>(found - names.begin());
    if (scene.bolts[index].is_installed_later)
      keys.fault("install", "installed twice: \"" + name + "\"; allowed: in one stage");
    scene.bolts[index].is_installed_later = true;
    installed.push_back(index);
  }
  return installed;
}

}  // namespace halfspace::cli
