#include "output/picture/svg.h"

#include <algorithm>
#include <cmath>

#include "common/text.h"

namespace halfspace::cli {
namespace {

std::string pixels(double value) { return decimals(std::round(100 * value) / 100 + 0.0, 2); }

std::string escaped(std::string_view text) {
  std::string result;
  for (char c : text) {
    if (c == '&') {
      result += "&amp;";
    } else if (c == '<') {
      result += "&lt;";
    } else if (c == '>') {
      result += "&gt;";
    } else {
      result += c;
    }
  }
  return result;
}

std::string position(const char* x, const char* y, Point at) {
  return std::string(" ") + x + "=\"" + pixels(at[0]) + "\" " + y + "=\"" + pixels(at[1]) + '"';
}

std::string box(Point corner, double width, double height) {
  return "<rect" + position("x", "y", corner) + " width=\"" + pixels(width) + "\" height=\"" +
         pixels(height) + '"';
}

}  // namespace

double even_step(double length, int count) {
  const double rough = length / count;
  const double power = std::pow(10.0, std::floor(std::log10(rough)));
  for (double factor : {1.0, 2.0, 5.0}) {
    if (factor * power >= rough) return factor * power;
  }
  return 10 * power;
}

std::vector<double> multiples_of(double step, double low, double high) {
  std::vector<double> multiples;
  const double first = std::ceil(low / step - 1e-9);
  if (first == first + 1) return multiples;
  for (double k = first; k * step <= high; ++k) multiples.push_back(k * step);
  return multiples;
}

int decimals_for(double step) { return std::max(0, -static_cast<int>(std::floor(std::log10(step) + 1e-9))); }

std::string number_on_scale(double value, double step, double low, double high) {
  const double size = std::max(std::abs(low), std::abs(high));
  return size < 1e-3 || size >= 1e6 ? rounded(value + 0.0, 4) : decimals(value + 0.0, decimals_for(step));
}

Svg::Svg(double width, double height) {
  const std::string w = pixels(width);
  const std::string h = pixels(height);
  text_ = "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" + w + "\" height=\"" + h +
          "\" viewBox=\"0 0 " + w + ' ' + h +
          "\" font-family=\"Helvetica, Arial, sans-serif\" fill=\"#222\">\n";
}

void Svg::rectangle(Point corner, double width, double height, std::string_view style) {
  text_ += box(corner, width, height) + " " + std::string(style) + "/>\n";
}

void Svg::image(Point corner, double width, double height, std::string_view png) {
  text_ += "<image" + position("x", "y", corner) + " width=\"" + pixels(width) + "\" height=\"" +
           pixels(height) + "\" href=\"data:image/png;base64," + std::string(png) + "\"/>\n";
}

void Svg::line(Point from, Point to, std::string_view style) {
  text_ +=
      "<line" + position("x1", "y1", from) + position("x2", "y2", to) + " " + std::string(style) + "/>\n";
}

void Svg::polygon(const std::vector<Point>& vertices, std::string_view style) {
  text_ += "<path d=\"";
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    text_ += i == 0 ? 'M' : 'L';
    text_ += pixels(vertices[i][0]) + ' ' + pixels(vertices[i][1]);
  }
  text_ += "Z\" " + std::string(style) + "/>\n";
}

void Svg::label(Point at, std::string_view text, double size, std::string_view anchor, double rotation) {
  text_ += "<text" + position("x", "y", at) + " font-size=\"" + pixels(size) + "\" text-anchor=\"" +
           std::string(anchor) + '"';
  if (rotation != 0) {
    text_ += " transform=\"rotate(" + pixels(rotation) + ' ' + pixels(at[0]) + ' ' + pixels(at[1]) + ")\"";
  }
  text_ += '>' + escaped(text) + "</text>\n";
}

void Svg::begin_clip(Point corner, double width, double height) {
  text_ +=
      "<clipPath id=\"plot\">" + box(corner, width, height) + "/></clipPath>\n<g clip-path=\"url(#plot)\">\n";
}

void Svg::end_clip() { text_ += "</g>\n"; }

}  // namespace halfspace::cli
