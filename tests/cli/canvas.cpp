#include "output/picture/canvas.h"

#include <cmath>
#include <numbers>
#include <vector>

#include "catch.h"
#include "output/picture/camera.h"
#include "output/picture/png.h"
#include "recording/encoding.h"

using namespace halfspace::cli;
using halfspace::viewer::base64;

namespace {

constexpr Rgb red{255, 0, 0};
constexpr Rgb blue{0, 0, 255};

/// Clockwise as seen, so that its outside shows.
std::vector<Point> rectangle(double left, double top, double right, double bottom, double depth) {
  return {{left, top, depth}, {left, bottom, depth}, {right, bottom, depth}, {right, top, depth}};
}

Rgb at(const Image& image, int x, int y) {
  const auto first = static_cast<std::size_t>(3 * (y * image.width + x));
  return {image.bytes[first], image.bytes[first + 1], image.bytes[first + 2]};
}

bool same(Rgb a, Rgb b) { return a.red == b.red && a.green == b.green && a.blue == b.blue; }

}  // namespace

TEST_CASE("the nearer face hides the farther, whichever is drawn first") {
  const bool near_first = GENERATE(true, false);
  Canvas canvas(40, 40);
  const auto near = rectangle(10, 10, 30, 30, 2), far = rectangle(5, 5, 35, 35, 1);
  canvas.draw(near_first ? near : far, near_first ? red : blue);
  canvas.draw(near_first ? far : near, near_first ? blue : red);
  const Image image = canvas.image(1);
  CHECK(same(at(image, 20, 20), red));
  CHECK(same(at(image, 7, 20), blue));
  CHECK(same(at(image, 2, 2), {255, 255, 255}));
  CHECK(at(image, 9, 20).blue < 255);  // the line between them is dark
}

TEST_CASE("faces that pass through each other hide each other in part") {
  Canvas canvas(40, 40);
  // Depths x and 40 - x: they cross in the middle.
  canvas.draw({{0, 0, 0}, {0, 40, 0}, {40, 40, 40}, {40, 0, 40}}, red);
  canvas.draw({{0, 0, 40}, {0, 40, 40}, {40, 40, 0}, {40, 0, 0}}, blue);
  const Image image = canvas.image(1);
  CHECK(same(at(image, 10, 20), blue));
  CHECK(same(at(image, 30, 20), red));
}

TEST_CASE("the inside of a face is not drawn, nor what is outside of the picture") {
  Canvas canvas(10, 10);
  canvas.draw({{2, 2, 0}, {8, 2, 0}, {8, 8, 0}, {2, 8, 0}}, red);
  canvas.draw(rectangle(-20, -20, -5, 30, 0), red);
  const Image inside_and_outside = canvas.image(1);
  CHECK(inside_and_outside.bytes == std::vector<std::uint8_t>(300, 255));
  canvas.draw(rectangle(-20, -20, 30, 30, 0), red);
  CHECK(same(at(canvas.image(1), 5, 5), red));
}

TEST_CASE("a triangle covers its area, to its edges") {
  Canvas canvas(100, 100);
  const std::vector<Point> corners = {{10.3, 8.1, 0}, {20.7, 91.9, 1}, {88.2, 40.4, 2}};
  canvas.draw(corners, {0, 0, 0});
  const Image image = canvas.image(0);
  double covered = 0;
  for (std::size_t i = 0; i < image.bytes.size(); i += 3) covered += (255 - image.bytes[i]) / 255.0;
  const auto [a, b, c] = std::tuple(corners[0], corners[1], corners[2]);
  const double area = std::abs((b[0] - a[0]) * (c[1] - a[1]) - (c[0] - a[0]) * (b[1] - a[1])) / 2;
  // Of every sample row, 3 to a pixel, both ends are off by at most half a sample: 252 rows of 1/9 pixel; on
  // average far less.
  CHECK(std::abs(covered - area) < 252.0 / 9);
  CHECK(std::abs(covered - area) < 0.005 * area);
}

TEST_CASE("a camera in the south sees east to the right, one in the east north; lengths stay") {
  constexpr double quarter = std::numbers::pi / 2;
  const auto is = [](const Point& p, const Point& q) {
    return std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]) < 1e-15;
  };
  CHECK(is(Camera(2 * quarter, 0).seen({1, 0, 0}), {1, 0, 0}));
  CHECK(is(Camera(2 * quarter, 0).seen({0, 0, 1}), {0, 1, 0}));
  CHECK(is(Camera(2 * quarter, 0).seen({0, -1, 0}), {0, 0, 1}));
  CHECK(is(Camera(quarter, 0).seen({0, 1, 0}), {1, 0, 0}));
  CHECK(is(Camera(2 * quarter, quarter).seen({0, 0, 1}), {0, 0, 1}));  // from above
  const Point p = Camera(2.5, 0.4).seen({1, 2, -3});
  CHECK(std::abs(std::hypot(p[0], p[1], p[2]) - std::sqrt(14.0)) < 1e-14);
}

TEST_CASE("base64 is that of RFC 4648") {
  CHECK(base64("") == "");
  CHECK(base64("f") == "Zg==");
  CHECK(base64("fo") == "Zm8=");
  CHECK(base64("foobar") == "Zm9vYmFy");
  CHECK(base64("\xff\xfe\xfd") == "//79");
}

TEST_CASE("an image becomes the bytes of a PNG file, the same each time") {
  Canvas canvas(20, 10);
  canvas.draw(rectangle(2, 2, 8, 8, 0), red);
  const std::string bytes = png(canvas.image(1));
  CHECK(bytes.substr(0, 8) == "\x89PNG\r\n\x1a\n");
  CHECK(bytes.substr(16, 8) == std::string("\0\0\0\x14\0\0\0\x0a", 8));  // width and height
  CHECK(bytes == png(canvas.image(1)));
}
