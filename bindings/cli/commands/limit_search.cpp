#include "commands/limit_search.h"

#include <cmath>
#include <stdexcept>
#include <utility>
#include <vector>

#include "common/suggestion.h"
#include "common/text.h"
#include "notes/notes.h"
#include "output/summary.h"
#include "studies/safety/failure.h"
#include "studies/safety/safety.h"
#include "studies/safety/start.h"

namespace halfspace::cli {
namespace {

/// @throws std::invalid_argument
void require_bracket(double low, double high) {
  if (!(low < high && std::isfinite(high - low))) {
    throw std::invalid_argument("the bracket " + shortest(low) + " to " + shortest(high) +
                                ": the low end must be below the high end, and both finite");
  }
}

/// The axis of a tilt. @throws std::invalid_argument
Point axis_of(const std::string& name, int dimension) {
  const std::string word = name.empty() ? (dimension == 2 ? "z" : "x") : name;
  const bool is_back = word.starts_with('-');
  const std::size_t axis = std::string("xyz").find(word.substr(is_back ? 1 : 0));
  const bool is_axis = word.size() == (is_back ? 2u : 1u) && axis != std::string::npos;
  if (!is_axis || (dimension == 2 && axis != 2)) {
    throw std::invalid_argument("not an axis: " + word +
                                "; allowed: " + (dimension == 2 ? "z, -z" : "x, y, z, -x, -y, -z"));
  }
  Point vector{};
  vector[axis] = is_back ? -1 : 1;
  return vector;
}

void scale(MeshLoad& load, double factor) {
  load.pressure *= factor;
  load.traction = times(factor, load.traction);
}

/// Scales the loads of a group or of a mesh; without a name all. @return false if there is none
bool scale_loads(Scene& scene, const std::string& name, double factor) {
  bool is_found = false;
  for (Mesh& mesh : scene.meshes) {
    for (MeshLoad& load : mesh.loads) {
      if (!name.empty() && name != load.part.group && name != mesh.making.name &&
          name != mesh.making.name + '/' + load.part.group)
        continue;
      scale(load, factor);
      is_found = true;
    }
  }
  return is_found;
}

/// The names of all loads, for suggestions.
std::string no_such_load(const Scene& scene, const std::string& name) {
  if (name.empty()) return "no loads; required: a [[mesh.load]]";
  std::vector<std::string_view> names;
  for (const Mesh& mesh : scene.meshes) {
    if (!mesh.loads.empty()) names.push_back(mesh.making.name);
    for (const MeshLoad& load : mesh.loads)
      if (!load.part.group.empty()) names.push_back(load.part.group);
  }
  return "no such load: \"" + name + '"' + suggestion(name, names) +
         "; allowed: the group of a [[mesh.load]], or the name of its mesh";
}

/// The varied quantity, for the report.
std::string described(const LimitOptions& options) {
  if (options.varied == Varied::setting) return options.name;
  return options.name.empty() ? "factor of loads" : "factor of loads of " + options.name;
}

}  // namespace

LimitSearch::LimitSearch(SceneFile file, LimitOptions options, ReadScene read)
    : file_(std::move(file)),
      options_(std::move(options)),
      read_(std::move(read)),
      low_(options_.low.value_or(0)),
      high_(options_.high.value_or(options_.varied == Varied::tilt ? 90 : 10)) {
  require_bracket(low_, high_);
  low_end_ = made_at(low_);
  if (low_end_.faults.none() && options_.varied != Varied::tilt) {
    Faults at_high = made_at(high_).faults;
    if (!at_high.none()) low_end_.faults = std::move(at_high);
  }
  if (!low_end_.faults.none()) return;
  if (options_.varied == Varied::tilt) axis_ = axis_of(options_.name, low_end_.scene.world.dimension);
  low_end_.scene.settings = joined(file_.settings);  // without the value that is varied
  model_ = std::make_shared<Model>(low_end_.context, low_end_.scene, std::move(low_end_.layout));
  note_start(low_end_.context, low_end_.scene, *model_, low_end_.faults);
}

/// A scene with its blocks, with a value.
CheckedScene LimitSearch::made_at(double value) const {
  SceneFile file = file_;
  if (options_.varied == Varied::setting) file.settings.push_back(options_.name + '=' + shortest(value));
  CheckedScene checked = read_(file);
  if (options_.varied == Varied::loads && checked.faults.none() &&
      !scale_loads(checked.scene, options_.name, value))
    checked.faults.add({}, "mesh", no_such_load(checked.scene, options_.name));
  lay_out(checked);
  require_free_block(checked, "a limit");
  return checked;
}

/// A trial from the start of the scene with this value. @throws std::runtime_error
TrialStart LimitSearch::begin(double value) const {
  struct Made {
    CheckedScene checked;
    Model model;
    explicit Made(CheckedScene of)
        : checked(std::move(of)), model(checked.context, checked.scene, std::move(checked.layout)) {}
  };
  const auto make = [this, value] {
    CheckedScene checked = made_at(value);
    if (!checked.faults.none())
      throw std::runtime_error("the scene at " + shortest(value) + " is faulty\n" +
                               checked.faults.describe(file_.path));
    return std::make_shared<Made>(std::move(checked));
  };
  const auto made = make();
  TrialStart start{.model = std::shared_ptr<Model>(made, &made->model),
                   .stages = stages_of_search(made->checked.scene),
                   .are_of_scene = !made->checked.scene.stages.empty(),
                   .limits = limits_at_start(made->model.frame())};
  if (options_.limit > 0) {
    start.limits.assign(start.limits.size(), options_.limit);
  } else if (!last_runs(made->checked.scene)) {
    start.confirms = [make, made](const Model& at_end) {
      Progress progress([](double, const std::string&) {});
      return has_come_to_its_place(made->checked.scene, at_end, make()->model, progress);
    };
  }
  return start;
}

SearchResult LimitSearch::find(OutputDirectory& directory) {
  const Scene& scene = low_end_.scene;
  const std::string bytes = bytes_of(file_, scene);
  const SearchOptions options{
      .low = low_,
      .high = high_,
      .resolution = options_.resolution > 0 ? options_.resolution : (high_ - low_) / 1000,
      .limit = options_.limit,
      .smallest = options_.smallest,
      .resumes = options_.resumes,
      .on_progress = options_.on_progress};
  if (options_.varied == Varied::tilt)
    return find_tilt(scene, std::move(model_), axis_, bytes, options, directory);
  model_.reset();  // each trial makes its own
  const std::string sought = options_.smallest ? "smallest value" : "largest value";
  const std::string varied = described(options_);
  Progress progress(options_.on_progress);
  return search(
      scene, [&](double value) { return begin(value); },
      {.sought = sought, .column = "value", .report = "limit.txt"}, options,
      bytes + '\n' + sought + " of " + varied, scene_lines(scene) + report_line("varied", varied), progress,
      directory);
}

}  // namespace halfspace::cli
