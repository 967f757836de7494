#include "blocks/mesh/convex_solid.h"
#include "blocks/mesh/digits.h"
#include "blocks/mesh/file_summary.h"
#include "blocks/mesh/surface.h"
#include "catch.h"

using namespace halfspace::cli;

namespace {

double last_digit_of(std::initializer_list<const char*> words) {
  Digits digits;
  for (const char* word : words) digits.add(word);
  return digits.last();
}

/// A unit cube of triangles, at x, whose upper face has a vertex so much below it.
std::string obj_cube(double x, const std::string& height_of_middle, int first_vertex) {
  std::string text = "o cube\n";
  for (const char* corner : {"0 0.000000", "1 0.000000", "1 1.000000", "0 1.000000"}) {
    const std::string place(corner);
    for (const char* z : {" 0.000000\n", " 1.000000\n"}) {
      text += "v " + std::to_string(x + (place[0] - '0')) + place.substr(1) + z;
    }
  }
  text += "v " + std::to_string(x + 0.5) + " 0.500000 " + height_of_middle + '\n';
  // Lower corners 1, 3, 5, 7, upper ones 2, 4, 6, 8, the middle 9.
  for (const auto& face : {std::vector<int>{1, 7, 5, 3},
                           {1, 3, 4, 2},
                           {3, 5, 6, 4},
                           {5, 7, 8, 6},
                           {7, 1, 2, 8},
                           {2, 4, 9},
                           {4, 6, 9},
                           {6, 8, 9},
                           {8, 2, 9}}) {
    text += 'f';
    for (const int v : face) text += ' ' + std::to_string(first_vertex + v - 1);
    text += '\n';
  }
  return text;
}

FileSummary summary_of(const std::string& obj, std::optional<double> tolerance) {
  const Context context = make_context();
  FileSummary summary;
  for (const Solid& solid : solids_of(read_obj("a.obj", obj))) {
    try {
      summary.add(solid, make_convex(context, solid, 1, tolerance).report);
    } catch (const NotConvex& fault) {
      summary.add(fault);
    }
  }
  return summary;
}

}  // namespace

TEST_CASE("the last digit of a file is that of its longest coordinates") {
  CHECK(last_digit_of({}) == 0);
  CHECK(last_digit_of({"0", "0"}) == 0);
  CHECK(last_digit_of({"0", "1", "-12"}) == 1);
  CHECK(last_digit_of({"0.5", "1.250"}) == Approx(1e-3));
  // Six decimals, and zeros dropped at the end of others.
  CHECK(last_digit_of({"1.5", "-0.333333", "123.25"}) == Approx(1e-6));
  // Six significant digits, as %g writes them: the largest number is the coarsest.
  CHECK(last_digit_of({"0.000123457", "1.23457", "-123.457"}) == Approx(1e-3));
  CHECK(last_digit_of({"1.234567e+02", "+3.2e-05"}) == Approx(1e-4));
  CHECK(last_digit_of({"0.70710678118654757", "1"}) == Approx(1e-17));
}

TEST_CASE("all faulty blocks of a file are listed, with the tolerance that takes them") {
  const std::string file =
      obj_cube(0, "0.999999", 1) + obj_cube(2, "0.990000", 10) + obj_cube(4, "0.980000", 19);
  const FileSummary by_digits = summary_of(file, {});
  const std::vector<std::string> faults = by_digits.faults();
  REQUIRE(faults.size() == 3);
  CHECK(faults[0].find("not convex: a dent 0.01 m deep at [2.5, 0.5, 0.99]") != std::string::npos);
  CHECK(faults[1].find("not convex: a dent 0.02 m deep at [4.5, 0.5, 0.98]") != std::string::npos);
  CHECK(faults[2].starts_with("2 faulty blocks in the file; tolerance = 0.01"));
  const FileSummary stated = summary_of(file, 0.02);
  CHECK(stated.faults().empty());
  REQUIRE(stated.notes().size() == 1);
  CHECK(stated.notes()[0].find("planes fitted to 3 blocks: 9 facets merged") != std::string::npos);
}

TEST_CASE("of many faulty blocks the first are listed") {
  std::string file;
  for (int i = 0; i < 30; ++i) file += obj_cube(2 * i, "0.900000", 9 * i + 1);
  const std::vector<std::string> faults = summary_of(file, {}).faults();
  REQUIRE(faults.size() == 21);
  CHECK(faults.back().starts_with("30 faulty blocks in the file, the first 20 of them above; tolerance = "));
}
