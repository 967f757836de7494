// The parts of a trade: laws of equal stiffness, orders of convergence, results that are read back.

#include "catch.h"
#include "scene/read_scene.h"
#include "studies/trade/convergence.h"
#include "studies/trade/measure.h"
#include "studies/trade/results.h"
#include "studies/trade/runs.h"

using namespace halfspace::cli;

namespace {

/// Two cubes, or squares, of side 2 that overlap by 1e-4, one of them fixed.
std::string scene_of(int dimension) {
  const bool in_space = dimension == 3;
  const std::string low = in_space ? "[[0,0,0],[2,0,0],[2,2,0],[0,2,0],[0,0,2],[2,0,2],[2,2,2],[0,2,2]]"
                                   : "[[0,0],[2,0],[2,2],[0,2]]";
  return "dimension = " + std::to_string(dimension) +
         "\n[world]\nduration = 1\ngravity = " + (in_space ? "[0,0,0]" : "[0,0]") +
         "\n[[material]]\nname = \"m\"\ndensity = 1\n[default_law]\nstiffness = \"per contact\"\n"
         "normal_stiffness = 1e6\n[[block]]\nname = \"a\"\nkind = \"fixed\"\nmaterial = \"m\"\nvertices = " +
         low + "\n[[block]]\nname = \"b\"\nmaterial = \"m\"\nvertices = " + low +
         "\nshift = " + (in_space ? "[1.9999,0,0]" : "[1.9999,0]") + "\n";
}

double force_under(int law, const Scene& scene) {
  Setting setting;
  setting.law = law;
  const Scene of_law = with_setting(scene, setting, typical_face(scene));
  const Context context = make_context();
  Faults faults;
  Model model(context, of_law, lay_out_blocks(context, of_law, faults));
  return model.contacts().at(0).force[0];
}

}  // namespace

TEST_CASE("laws of equal stiffness push faces that meet squarely with the same force") {
  for (const int dimension : {2, 3}) {
    Faults faults;
    const Scene scene = read_scene_text(scene_of(dimension), "scene.toml", faults);
    REQUIRE(faults.describe("scene") == "");
    CHECK(typical_face(scene).area == Approx(dimension == 2 ? 2 : 4));
    for (const int law : {HS_STIFFNESS_PER_CONTACT, HS_STIFFNESS_PER_AREA, HS_STIFFNESS_POTENTIAL}) {
      INFO(dimension << "D, " << name_of_law(law));
      CHECK(std::abs(force_under(law, scene)) == Approx(100).epsilon(2e-4));
    }
  }
}

TEST_CASE("springs in place of none are as stiff as a layer of cells, times what is asked for") {
  std::string text = scene_of(2);
  const auto put = [&](const std::string& old, const std::string& now) {
    text.replace(text.find(old), old.size(), now);
  };
  put("density = 1", "density = 1\nyoung_modulus = 1e6\npoisson_ratio = 0.2");
  put("\"per contact\"\nnormal_stiffness = 1e6", "\"none\"");
  Faults faults;
  const Scene scene = read_scene_text(text, "scene.toml", faults);
  REQUIRE(faults.describe("scene") == "");
  for (const double factor : {1.0, 100.0}) {
    const Setting setting{.stiffness = factor, .law = HS_STIFFNESS_PER_AREA};
    const Scene of_law = with_setting(scene, setting, typical_face(scene));
    CHECK(of_law.default_law.normal_stiffness == Approx(factor * 1e6 / 2));  // E / h
    CHECK(of_law.default_law.shear_stiffness == Approx(factor * 1e6 / 2));
  }
}

TEST_CASE("without springs and elements a step is a share of the scene's own") {
  std::string text = scene_of(2);
  const std::string law = "\"per contact\"\nnormal_stiffness = 1e6";
  text.replace(text.find(law), law.size(), "\"none\"");
  text.replace(text.find("duration"), 0, "time_step = 0.01\n");
  Faults faults;
  const Scene scene = read_scene_text(text, "scene.toml", faults);
  REQUIRE(faults.describe("scene") == "");
  CHECK(with_setting(scene, {.step = 0.25}, {}).world.time_step == 0.0025);
  CHECK(scene_lines({.step = 0.25}, scene, {}).find("time_step = 0.0025\n") != std::string::npos);
}

TEST_CASE("the order of convergence and the limit follow from three values") {
  const auto values = [](double order) {
    std::vector<double> all;
    for (const double step : step_ladder) all.push_back(3 + 0.1 * std::pow(step, order));
    return all;
  };
  for (const double order : {1.0, 2.0, 3.5}) {
    const Convergence found = convergence_of(values(order), 1e-15);
    CHECK(found.converges);
    CHECK(found.order == Approx(order));
    CHECK(found.limit == Approx(3));
  }
  CHECK_FALSE(convergence_of({1, 2}, 0).is_known);
  CHECK_FALSE(convergence_of({1, 2, 4}, 0).converges);
  CHECK_FALSE(convergence_of({1, 2, 1}, 0).converges);
  CHECK(convergence_of({1, 2, 2}, 0).converges);
  CHECK(convergence_of({1, 2, 2 + 1e-12}, 1e-9).order == 0);
}

TEST_CASE("results are read back as they were written, and only for their scene") {
  std::vector<Result> results(2);
  results[0].setting.law = HS_STIFFNESS_POTENTIAL;
  results[0].setting.damping = 0.1;
  results[0].outcomes = {RunEnd::whole, 1.0 / 3, 0, 1e-3, 2};
  results[1].setting.disturbance = 3;
  results[1].outcomes.end = RunEnd::unstable;
  const std::string csv = csv_of(results, "scene");
  const std::vector<Result> read = results_from(csv, "scene");
  REQUIRE(read.size() == 2);
  for (std::size_t i = 0; i < 2; ++i) {
    CHECK(read[i].setting == results[i].setting);
    CHECK(read[i].outcomes.value == results[i].outcomes.value);
    CHECK(read[i].outcomes.end == results[i].outcomes.end);
  }
  CHECK_THROWS_WITH(results_from(csv, "another"), Catch::Contains("another scene"));
  CHECK_THROWS_WITH(results_from(csv + "1,2\n", "scene"), Catch::Contains("too few cells"));
  CHECK_THROWS_WITH(results_from(csv + "x" + csv.substr(csv.rfind('\n', csv.size() - 2) + 1), "scene"),
                    Catch::Contains("not a number"));
}
