#include "generator/report/plot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "generator/svg/svg.hpp"

namespace finemote::gen::report {
namespace {

// In pixels.
constexpr double kWidth = 360, kHeight = 150, kLeft = 54, kRight = 14, kTop = 10, kBottom = 24;
constexpr double kTextToEdge = 4;  // of texts to the edge
constexpr double kLetter = 7;      // as wide as one of a text, at most

/// From values to pixels along one axis.
struct Axis {
  double low, high, from, to;

  [[nodiscard]] double place(double value) const {
    return from + (std::clamp(value, low, high) - low) / (high - low) * (to - from);
  }
};

/// Round numbers within the axis, about `wanted` of them.
std::vector<double> ticks_of(const Axis& axis, int wanted) {
  const double rough = (axis.high - axis.low) / wanted;
  const double power = std::pow(10, std::floor(std::log10(rough)));
  double step = 10 * power;
  for (const double factor : {5.0, 2.0, 1.0}) {
    if (factor * power >= rough * 0.999) step = factor * power;
  }
  std::vector<double> ticks;
  for (double i = std::ceil(axis.low / step - 1e-9); i * step <= axis.high + 1e-9 * step && ticks.size() < 20; ++i)
    ticks.push_back(i * step);
  const bool is_enough = ticks.size() > 2 || wanted > 8;
  return is_enough ? ticks : ticks_of(axis, 2 * wanted);
}

struct TimeUnit {
  double ns;
  const char* name;
};

TimeUnit unit_of(double longest) {
  if (longest >= 2e9) return {1e9, "s"};
  if (longest >= 2e6) return {1e6, "ms"};
  return {1e3, "µs"};
}

/// Without the noise of a sum of steps, and never `-0`.
std::string number(double value, double range) {
  return fmt::format("{:.6g}", std::abs(value) < range * 1e-6 ? 0.0 : value);
}

Axis x_axis(const Plot& plot) {
  const double low = plot.points.front().x, high = plot.points.back().x;
  return {low, high > low ? high : low + 1, kLeft, kWidth - kRight};
}

Axis y_axis(const Plot& plot) {
  double low = plot.points.front().y, high = low;
  for (const Plot::Point& point : plot.points) low = std::min(low, point.y), high = std::max(high, point.y);
  if (plot.limit > 0) low = 0, high = std::max(high, plot.limit);
  const double room = high > low ? 0.06 * (high - low) : std::max(std::abs(high) * 0.1, 1e-9);
  return {plot.limit > 0 ? 0 : low - room, high + (plot.limit > 0 ? 3 : 1) * room, kHeight - kBottom, kTop};
}

std::string axes_drawn(const Plot& plot, const Axis& x, const Axis& y) {
  const TimeUnit time = unit_of(x.high), value = plot.is_time ? unit_of(y.high) : TimeUnit{1, ""};
  std::string text;
  const Axis in_value{y.low / value.ns, y.high / value.ns, y.from, y.to};
  for (const double tick : ticks_of(in_value, 4)) {
    const double at = in_value.place(tick);
    text += fmt::format("<line class=\"grid\" x1=\"{:.0f}\" y1=\"{:.1f}\" x2=\"{:.0f}\" y2=\"{:.1f}\"/>\n", kLeft, at,
                        kWidth - kRight, at);
    text += fmt::format("<text class=\"y\" x=\"{:.0f}\" y=\"{:.1f}\">{}{}{}</text>\n", kLeft - 6, at + 4,
                        number(tick, in_value.high - in_value.low), plot.is_time ? " " : "", value.name);
  }
  const Axis in_time{x.low / time.ns, x.high / time.ns, x.from, x.to};
  for (const double tick : ticks_of(in_time, 5)) {
    const double at = in_time.place(tick);
    const std::string words = fmt::format("{} {}", number(tick, in_time.high - in_time.low), time.name);
    const double half = static_cast<double>(words.size()) * kLetter / 2, rightmost = kWidth - kTextToEdge - half;
    if (at > rightmost + half / 2) continue;  // what is moved as far seems to be of another place
    text += fmt::format("<text class=\"x\" x=\"{:.1f}\" y=\"{:.0f}\">{}</text>\n", std::min(at, rightmost), kHeight - 7,
                        words);
  }
  return text;
}

std::string band_drawn(const Plot::Band& band, const Axis& x, const Axis& y) {
  if (band.x_to < x.low || band.x_from > x.high || band.y_to < y.low || band.y_from > y.high) return {};
  const double left = x.place(band.x_from), top = y.place(band.y_to);
  return fmt::format("<rect class=\"wanted\" x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\"/>\n", left,
                     top, std::max(3.0, x.place(band.x_to) - left), std::max(1.0, y.place(band.y_from) - top));
}

std::string line_drawn(const Plot& plot, const Axis& x, const Axis& y) {
  std::string way;
  for (const Plot::Point& point : plot.points)
    way += fmt::format("{}{:.1f} {:.1f}", way.empty() ? "M" : "L", x.place(point.x), y.place(point.y));
  return fmt::format("<path class=\"line\"{} d=\"{}\"/>\n", plot.attributes, way);
}

std::string limit_drawn(const Plot& plot, const Axis& y) {
  if (plot.limit <= 0) return {};
  const double at = y.place(plot.limit);
  return fmt::format("<line class=\"limit\"{} x1=\"{:.0f}\" y1=\"{:.1f}\" x2=\"{:.0f}\" y2=\"{:.1f}\"/>\n",
                     plot.limit_attributes, kLeft, at, kWidth - kRight, at) +
         fmt::format("<text class=\"limit-name\" x=\"{:.0f}\" y=\"{:.1f}\">bound</text>\n", kWidth - kRight, at - 4);
}

}  // namespace

bool Plot::is_constant() const {
  return std::all_of(points.begin(), points.end(), [&](const Point& point) { return point.y == points.front().y; });
}

std::string drawn(const Plot& plot) {
  if (plot.points.empty()) return {};
  const Axis x = x_axis(plot), y = y_axis(plot);
  if (!std::isnormal(x.high - x.low) || !std::isnormal(y.high - y.low)) return {};
  std::string text = fmt::format(
      "<svg class=\"plot\" viewBox=\"0 0 {0} {1}\" width=\"{0}\" height=\"{1}\" role=\"img\" aria-label=\"{2}\">\n",
      kWidth, kHeight, svg::escaped(plot.title));
  for (const Plot::Band& band : plot.bands) text += band_drawn(band, x, y);
  return text + axes_drawn(plot, x, y) + limit_drawn(plot, y) + line_drawn(plot, x, y) + "</svg>\n";
}

}  // namespace finemote::gen::report
