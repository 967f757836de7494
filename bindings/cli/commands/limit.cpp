#include "commands/limit.h"

#include <charconv>
#include <stdexcept>
#include <utility>
#include <vector>

#include "common/interrupt.h"

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

/// A setting and the bracket of its value.
struct VariedSetting {
  std::string key;
  double low = 0, high = 0;
};

/// Takes the setting `key=low:high` from the settings.
std::optional<VariedSetting> take_varied(std::vector<std::string>& settings) {
  for (auto setting = settings.begin(); setting != settings.end(); ++setting) {
    const std::size_t equals = setting->find('=');
    if (equals == std::string::npos) continue;
    const auto bracket = bracket_of(std::string_view(*setting).substr(equals + 1));
    if (!bracket) continue;
    VariedSetting varied{setting->substr(0, equals), bracket->first, bracket->second};
    settings.erase(setting);
    return varied;
  }
  return std::nullopt;
}

/// Takes a varied setting from the settings. @throws std::invalid_argument for wrong usage
LimitOptions options_of(const LimitArguments& arguments, std::vector<std::string>& settings) {
  LimitOptions options = arguments.search;
  const std::optional<VariedSetting> setting = take_varied(settings);
  if (arguments.tilts + arguments.load.has_value() + setting.has_value() != 1 ||
      (setting && take_varied(settings)))
    throw std::invalid_argument("required: one of --tilt, --load and --set KEY=LOW:HIGH");
  if (setting && (options.low || options.high))
    throw std::invalid_argument("--low and --high: the bracket of a setting is KEY=LOW:HIGH");
  if (!arguments.tilts && !arguments.axis.empty()) throw std::invalid_argument("--axis: only with --tilt");
  options.varied = arguments.tilts ? Varied::tilt : setting ? Varied::setting : Varied::loads;
  options.name = arguments.tilts ? arguments.axis : setting ? setting->key : *arguments.load;
  if (setting) {
    options.low = setting->low;
    options.high = setting->high;
  }
  return options;
}

/// @throws std::invalid_argument for wrong usage
int find_limit(SceneFile file, const Target& target, const LimitArguments& arguments) {
  const LimitOptions options = options_of(arguments, file.settings);
  LimitSearch search(file, options, [&](const SceneFile& at) { return read(at, target.threads); });
  if (!search.faults().none()) return refuse(file, search.faults());
  OutputDirectory directory = directory_of(target, options.resumes, "trials.csv");
  print(stderr, search.faults().describe_notes(file.path));
  remember_interrupts();
  const SearchResult result = search.find(directory);
  print(stdout, result.report);
  if (result.end == SearchEnd::interrupted) print(stderr, "\nhalfspace: interrupted; --resume continues\n");
  return result.end == SearchEnd::found ? exit_ok : exit_failed;
}

}  // namespace

int limit(SceneFile file, const Target& target, const LimitArguments& arguments) {
  try {
    return find_limit(std::move(file), target, arguments);
  } catch (const std::invalid_argument& error) {
    print(stderr, std::string(error.what()) + '\n');
    return exit_usage;
  }
}

}  // namespace halfspace::cli
