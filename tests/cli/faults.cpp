#include "scene/faults.h"

#include "catch.h"
#include "common/suggestion.h"
#include "scene/keys.h"

using namespace halfspace::cli;

TEST_CASE("faults are told in the order of the file") {
  Faults faults;
  CHECK(faults.none());
  faults.add({12, 3}, "b", "wrong");
  faults.add({2, 30}, "a", "missing");
  faults.add({2, 4}, "", "not TOML");
  CHECK(faults.count() == 3);
  CHECK(faults.describe("s.toml") ==
        "s.toml:2:4: not TOML\ns.toml:2:30: a: missing\ns.toml:12:3: b: wrong\n");
}

TEST_CASE("ranges say what they hold") {
  CHECK(above(0).describe() == "a number above 0");
  CHECK_FALSE(above(0).holds(0));
  CHECK(at_least(0).holds(0));
  const Range share{.low = 0, .high = 1, .with_high = false};
  CHECK(share.describe() == "a number, at least 0, below 1");
  CHECK(share.holds(0.5));
  CHECK_FALSE(share.holds(1));
  CHECK(any_number().describe() == "a number");
}

TEST_CASE("a misspelt name gets the nearest one, another word none") {
  CHECK(suggestion("safty", {"skin", "safety"}) == " (did you mean 'safety'?)");
  CHECK(suggestion("colour", {"color", "colours"}) != "");
  CHECK(suggestion("temperature", {"skin", "safety"}) == "");
}
