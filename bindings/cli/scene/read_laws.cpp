#include "scene/read_laws.h"

#include <algorithm>

#include "scene/law_numbers.h"

namespace halfspace::cli {
namespace {

/// Reads the keys of a law; missing keys keep their value in `law`.
void read_law_values(Keys& keys, hs_law_def& law, bool is_whole) {
  const bool changes_kind = !is_whole && keys.has("stiffness");
  const std::optional<int> kind = is_whole ? std::nullopt : std::optional(law.stiffness_kind);
  law.stiffness_kind = keys.kind("stiffness", {law_names.begin(), law_names.end()}, kind);
  // A stiffness in other units cannot be inherited from the default law.
  if (changes_kind && has_spring(law)) law.shear_stiffness = 0;
  read_law_numbers(keys, law, !is_whole && !changes_kind);
  clear_refused_numbers(law);
}

/// The law between two materials among those of pairs; empty if they follow the default law.
std::vector<PairLaw>::iterator find_law(std::vector<PairLaw>& laws, int a, int b) {
  return std::find_if(laws.begin(), laws.end(),
                      [&](const PairLaw& law) { return std::minmax(law.a, law.b) == std::minmax(a, b); });
}

void report_given_before(Keys& keys, const std::pair<int, int>& between, const Scene& scene) {
  const auto name = [&](int material) {
    return '"' + scene.materials[static_cast<std::size_t>(material)].name + '"';
  };
  keys.fault("between", "a law between " + name(between.first) + " and " + name(between.second) +
                            " was given before; allowed: one law for a pair of materials");
}

}  // namespace

void read_default_law(Keys keys, Scene& scene) {
  hs_law_def_init(&scene.default_law, sizeof scene.default_law);
  read_law_values(keys, scene.default_law, true);
  scene.places.default_law = keys.place();
  scene.is_law_set = keys.has("stiffness") && keys.place("stiffness").is_setting;
  scene.places.restitution = keys.place_if_given("restitution");
  keys.finish();
}

void read_laws(std::vector<Keys> tables, Scene& scene) {
  for (Keys& keys : tables) {
    const std::optional<std::pair<int, int>> between = read_between(keys, scene);
    hs_law_def law = scene.default_law;
    if (scene.is_law_set) keys.leave_out_others();
    read_law_values(keys, law, false);
    keys.finish();
    if (!between) continue;
    const auto [a, b] = *between;
    if (find_law(scene.laws, a, b) != scene.laws.end()) report_given_before(keys, *between, scene);
    scene.laws.push_back({a, b, law, keys.place("between"), keys.place_if_given("restitution")});
  }
}

void read_stage_laws(Keys& keys, const Scene& scene, Laws& present, SceneStage& stage) {
  Keys of_all = keys.table("default_law", false);
  if (scene.is_law_set) of_all.leave_out_others();
  read_law_values(of_all, present.of_all, false);
  of_all.finish();
  if (keys.has("default_law")) stage.default_law = present.of_all;
  for (Keys& of_pair : keys.tables("law", false)) {
    const std::optional<std::pair<int, int>> between = read_between(of_pair, scene);
    const auto before =
        between ? find_law(present.of_pairs, between->first, between->second) : present.of_pairs.end();
    hs_law_def law = before == present.of_pairs.end() ? present.of_all : before->law;
    if (scene.is_law_set) of_pair.leave_out_others();
    read_law_values(of_pair, law, false);
    of_pair.finish();
    if (!between) continue;
    if (find_law(stage.laws, between->first, between->second) != stage.laws.end())
      report_given_before(of_pair, *between, scene);
    stage.laws.push_back({between->first, between->second, law, of_pair.place("between"), {}});
    if (before == present.of_pairs.end()) {
      present.of_pairs.push_back(stage.laws.back());
    } else {
      before->law = law;
    }
  }
}

}  // namespace halfspace::cli
