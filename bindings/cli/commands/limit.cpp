#include "commands/limit.h"

#include <charconv>
#include <cmath>
#include <memory>
#include <stdexcept>
#include <utility>
#include <vector>

#include "common/interrupt.h"
#include "common/suggestion.h"
#include "common/text.h"
#include "output/summary.h"
#include "studies/safety/safety.h"

namespace halfspace::cli {
namespace {

/// The two numbers of `low:high`, if the text has this form.
std::optional<std::pair<double, double>> bracket_of(std::string_view text) {
  double low = 0, high = 0;
  const char* const end = text.data() + text.size();
  const auto first = std::from_chars(text.data(), end, low);
  if (first.ec != std::errc() || first.ptr == end || *first.ptr != ':') return std::nullopt;
  const auto second = std::from_chars(first.ptr + 1, end, high);
  if (second.ec != std::errc() || second.ptr != end) return std::nullopt;
  return std::pair(low, high);
}

/// The value that is varied, and its bracket.
struct Varied {
  std::string name;  ///< for the report
  double low = 0, high = 0;
  std::string key = {};  ///< of a setting; empty: a tilt or loads
};

/// Takes the setting `key=low:high` from the settings.
std::optional<Varied> take_varied(std::vector<std::string>& settings) {
  for (auto setting = settings.begin(); setting != settings.end(); ++setting) {
    const std::size_t equals = setting->find('=');
    if (equals == std::string::npos) continue;
    const auto bracket = bracket_of(std::string_view(*setting).substr(equals + 1));
    if (!bracket) continue;
    const std::string key = setting->substr(0, equals);
    settings.erase(setting);
    return Varied{key, bracket->first, bracket->second, key};
  }
  return std::nullopt;
}

/// @throws std::invalid_argument for wrong usage
Varied varied_of(std::vector<std::string>& settings, const LimitOptions& options) {
  const std::optional<Varied> setting = take_varied(settings);
  if (options.tilts + options.load.has_value() + setting.has_value() != 1 ||
      (setting && take_varied(settings)))
    throw std::invalid_argument("required: one of --tilt, --load and --set KEY=LOW:HIGH");
  if (setting && (options.low || options.high))
    throw std::invalid_argument("--low and --high: the bracket of a setting is KEY=LOW:HIGH");
  if (!options.tilts && !options.axis.empty()) throw std::invalid_argument("--axis: only with --tilt");
  const Varied varied = setting ? *setting
                                : Varied{options.tilts ? "tilt" : "factor of loads", options.low.value_or(0),
                                         options.high.value_or(options.tilts ? 90 : 10)};
  if (!(varied.low < varied.high && std::isfinite(varied.high - varied.low))) {
    throw std::invalid_argument("the bracket " + shortest(varied.low) + " to " + shortest(varied.high) +
                                ": the low end must be below the high end, and both finite");
  }
  return varied;
}

/// The axis of a tilt. @throws std::invalid_argument
Point axis_of(const std::string& name, const Scene& scene) {
  const int dimension = scene.world.dimension;
  const std::string word = name.empty() ? (dimension == 2 ? "z" : "x") : name;
  const bool is_back = word.starts_with('-');
  const std::size_t axis = std::string("xyz").find(word.substr(is_back ? 1 : 0));
  const bool is_axis = word.size() == (is_back ? 2u : 1u) && axis != std::string::npos;
  if (!is_axis || (dimension == 2 && axis != 2)) {
    throw std::invalid_argument("--axis: not an axis: " + word +
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

/// A scene with its blocks, with a value.
class Maker {
 public:
  Maker(SceneFile file, const Varied& varied, const LimitOptions& options, int threads)
      : file_(std::move(file)), varied_(varied), options_(options), threads_(threads) {}

  CheckedScene at(double value) const {
    SceneFile file = file_;
    if (!varied_.key.empty()) file.settings.push_back(varied_.key + '=' + shortest(value));
    CheckedScene checked = read(file, threads_);
    if (options_.load && checked.faults.none() && !scale_loads(checked.scene, *options_.load, value))
      checked.faults.add({}, "mesh", no_such_load(checked.scene, *options_.load));
    lay_out(checked);
    require_free_block(checked, "a limit");
    require_rest(checked, "a limit");
    return checked;
  }

  /// A trial from the start of the scene with this value. @throws std::runtime_error
  TrialStart begin(double value) const {
    struct Made {
      CheckedScene checked;
      Model model;
      explicit Made(CheckedScene of)
          : checked(std::move(of)), model(checked.context, checked.scene, std::move(checked.layout)) {}
    };
    CheckedScene checked = at(value);
    if (!checked.faults.none())
      throw std::runtime_error("the scene at " + shortest(value) + " is faulty\n" +
                               checked.faults.describe(file_.path));
    const auto made = std::make_shared<Made>(std::move(checked));
    std::vector<double> limits = limits_at_start(made->model.frame());
    if (options_.limit > 0) limits.assign(limits.size(), options_.limit);
    return {.model = std::shared_ptr<Model>(made, &made->model),
            .stages = stages_to_rest(made->checked.scene),
            .are_of_scene = !made->checked.scene.stages.empty(),
            .limits = std::move(limits)};
  }

 private:
  const SceneFile file_;
  const Varied varied_;
  const LimitOptions& options_;
  int threads_;
};

/// Each trial is a new scene with a value of the setting, or a factor of the loads.
SearchResult find_value(const Scene& scene, const Maker& maker, const std::string& varied,
                        const std::string& first_lines, const std::string& bytes,
                        const SearchOptions& options, OutputDirectory& directory) {
  Progress progress;
  const std::string sought = options.smallest ? "smallest value" : "largest value";
  return search(
      scene, [&](double value) { return maker.begin(value); },
      {.sought = sought, .column = "value", .report = "limit.txt"}, options,
      bytes + '\n' + sought + " of " + varied, first_lines + report_line("varied", varied), progress,
      directory);
}

/// @throws std::invalid_argument for wrong usage
int find_limit(SceneFile file, const Target& target, const LimitOptions& options) {
  Varied varied = varied_of(file.settings, options);
  if (options.load && !options.load->empty()) varied.name += " of " + *options.load;
  const Maker maker(file, varied, options, target.threads);
  CheckedScene at_high = maker.at(varied.high), checked = maker.at(varied.low);
  for (const CheckedScene* end : {&at_high, &checked})
    if (!end->faults.none()) return refuse(file, end->faults);
  const Point axis = options.tilts ? axis_of(options.axis, checked.scene) : Point{};
  OutputDirectory directory = directory_of(target, options.resumes, "trials.csv");
  const std::string bytes = bytes_of(file, checked.scene);
  const SearchOptions search_options{
      .low = varied.low,
      .high = varied.high,
      .resolution = options.resolution > 0 ? options.resolution : (varied.high - varied.low) / 1000,
      .limit = options.limit,
      .smallest = options.smallest,
      .resumes = options.resumes};
  checked.scene.settings = joined(file.settings);  // without the value that is varied
  remember_interrupts();
  SearchResult result;
  if (options.tilts) {
    const auto model = std::make_shared<Model>(checked.context, checked.scene, std::move(checked.layout));
    result = find_tilt(checked.scene, model, axis, bytes, search_options, directory);
  } else {
    result = find_value(checked.scene, maker, varied.name, scene_lines(checked.scene), bytes, search_options,
                        directory);
  }
  print(stdout, result.report);
  if (result.end == SearchEnd::interrupted) print(stderr, "\nhalfspace: interrupted; --resume continues\n");
  return result.end == SearchEnd::found ? exit_ok : exit_failed;
}

}  // namespace

int limit(const SceneFile& file, const Target& target, const LimitOptions& options) {
  try {
    return find_limit(file, target, options);
  } catch (const std::invalid_argument& error) {
    print(stderr, std::string(error.what()) + '\n');
    return exit_usage;
  }
}

}  // namespace halfspace::cli
