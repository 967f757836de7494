#include "common/text.h"

#include <cstdlib>

#include "catch.h"
#include "output/picture/svg.h"
#include "output/progress.h"
#include "output/summary.h"

using namespace halfspace::cli;

TEST_CASE("numbers as text") {
  for (double value : {0.0, 0.1, 1.0 / 3, -2.5e-300, 1.7976931348623157e308}) {
    CHECK(std::strtod(shortest(value).c_str(), nullptr) == value);
  }
  CHECK(shortest(0.1) == "0.1");
  CHECK(rounded(1234.5678, 3) == "1.23e+03");
  CHECK(decimals(2, 3) == "2.000");
}

TEST_CASE("a loss below zero is told, and rounding is not") {
  hs_world_report report{};
  report.energy.kinetic = 10;
  report.energy.friction_loss = -1e-12;
  CHECK(negative_losses_text(report, 0).empty());
  report.energy.friction_loss = -0.25;
  CHECK(negative_losses_text(report, 0).find("the loss by friction is -0.25 J, below zero") !=
        std::string::npos);
}

TEST_CASE("no energy is created where the method loses as much, or friction does work in an impact") {
  hs_world_report report{};
  report.energy.kinetic = 10;
  report.energy.contact_damping_loss = -0.25;
  report.energy.residual = -0.5;
  CHECK(negative_losses_text(report, 0).empty());
  report.energy.residual = -0.125;
  CHECK(!negative_losses_text(report, 0).empty());
  report.energy.contact_damping_loss = report.energy.residual = 0;
  report.energy.friction_loss = -0.25;
  report.impact_loss = 5;
  CHECK(negative_losses_text(report, 0).empty());
}

TEST_CASE("a residual above 1 % of the released energy is noted, and rounding is not") {
  hs_world_report report{};
  report.energy.gravity = -1e5;
  report.energy.kinetic = 10;
  report.energy.residual = 0.09;
  CHECK(residual_note(report, 0).empty());
  report.energy.residual = 1.9;
  CHECK(residual_note(report, 0).find("created 0.19 of the energy released") != std::string::npos);
  report.energy.residual = -1.9;
  CHECK(residual_note(report, 0).find("lost 0.19 of the energy released") != std::string::npos);
  report.energy.kinetic = 1e-5;
  report.energy.residual = 5e-6;
  CHECK(residual_note(report, 0).empty());
}

TEST_CASE("axis steps are 1, 2 or 5 times a power of ten") {
  CHECK(even_step(100, 10) == 10);
  CHECK(even_step(3, 5) == Approx(1.0));
  CHECK(even_step(0.07, 4) == Approx(0.02));
  CHECK(decimals_for(0.02) == 2);
  CHECK(decimals_for(0.1) == 1);
  CHECK(decimals_for(20) == 0);
}

TEST_CASE("a progress line") {
  CHECK(progress_line(0.5, "t = 2.5 of 5 s", 60) ==
        "[###############               ] 50 %  t = 2.5 of 5 s  1:00 left");
  CHECK(progress_line(0, "t = 0 of 5 s", 1) == "[                              ] 0 %  t = 0 of 5 s");
  CHECK(progress_line(1.0 / 11, "t = 1 of 11 s", 720) ==
        "[##                            ] 9 %  t = 1 of 11 s  2:00:00 left");
}
