#include "scene/read_reference.h"

#include <muParser.h>

#include <cmath>

#include "common/text.h"
#include "scene/read_values.h"

namespace halfspace::cli {
namespace {

/// The value of a formula, which may have the time `t`, `pi`, and `deg`, a degree in radians.
/// @throws mu::Parser::exception_type
double value_of(const std::string& formula, double time) {
  mu::Parser parser;
  parser.DefineConst("t", time);
  parser.DefineConst("pi", std::numbers::pi);
  parser.DefineConst("deg", degree);
  parser.SetExpr(formula);
  int count = 0;
  const double* values = parser.Eval(count);  // as "1, 2" has two of them
  return count == 1 ? values[0] : NAN;
}

/// A number, or a formula in quotes.
std::optional<double> read_value(Keys& keys, double time) {
  if (!keys.has_text("value")) {
    if (!keys.has("value")) return std::nullopt;
    return keys.number("value", any_number(), required);
  }
  const std::string formula = keys.text("value", required);
  try {
    const double value = value_of(formula, time);
    if (std::isfinite(value)) return value;
    keys.fault("value", '"' + formula + "\" has no finite value; allowed: a number or a formula in t");
  } catch (const mu::Parser::exception_type& error) {
    keys.fault("value", '"' + formula + "\" is no formula: " + error.GetMsg() +
                            "; allowed: a number or a formula in t, as \"0.5 * 9.81 * sin(30 * deg) * t^2\"");
  }
  return std::nullopt;
}

}  // namespace

void read_reference(Keys keys, Scene& scene) {
  Reference& reference = scene.reference;
  reference.is_given = keys.has("quantity");
  reference.time = scene.duration;
  reference.quantity = static_cast<Quantity>(keys.kind(
      "quantity", {"run-out", "height", "position", "force", "stands", "friction angle"}, required));
  const Quantity quantity = reference.quantity;
  if (quantity == Quantity::position || quantity == Quantity::force) {
    reference.block = keys.text("block", required);
    reference.block_place = keys.place("block");
    if (keys.has_text("block") && reference.block.empty())
      keys.fault("block", "empty; allowed: the name of a block");
  }
  if (quantity == Quantity::position) {
    reference.axis =
        static_cast<std::size_t>(keys.dimension() == 2 ? keys.word("axis", {"x", "y"}, required)
                                                       : keys.word("axis", {"x", "y", "z"}, required));
  }
  if (quantity == Quantity::stands || quantity == Quantity::friction_angle)
    reference.limit = keys.number("limit", above(0), reference.limit);
  keys.has_any({"value", "scale"});
  if (!scene.stages.empty() && keys.has("time"))
    keys.fault("time", "a scene with stages is measured at its end; allowed: no time");
  reference.time = keys.number("time", above(0), scene.duration);
  reference.value = read_value(keys, reference.time);
  if (keys.has("scale")) reference.scale = keys.number("scale", above(0), required);
  keys.finish();
}

}  // namespace halfspace::cli
