#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "generator/report/body.hpp"
#include "generator/report/table.hpp"
#include "generator/svg/svg.hpp"

namespace finemote::gen::report {
namespace {

using Flat = Eigen::Vector2d;

// In pixels.
constexpr double kSize = 340, kMargin = 56, kArrow = 34, kMark = 4, kLabel = 9;
constexpr std::size_t kMostParts = 200;

/// From where one looks: which way is right, up and towards the reader, and how people call the axes.
struct View {
  const char* title;
  Eigen::Vector3d right, up, near;
  const char* right_name;
  const char* up_name;
};

const std::array<View, 3> kViews{
    {{"From above", -Eigen::Vector3d::UnitY(), Eigen::Vector3d::UnitX(), Eigen::Vector3d::UnitZ(), "right", "ahead"},
     {"From the right", Eigen::Vector3d::UnitX(), Eigen::Vector3d::UnitZ(), -Eigen::Vector3d::UnitY(), "ahead", "up"},
     {"From behind", -Eigen::Vector3d::UnitY(), Eigen::Vector3d::UnitZ(), -Eigen::Vector3d::UnitX(), "right", "up"}}};

/// One scale and one middle for all views.
struct Scale {
  Eigen::Vector3d middle = Eigen::Vector3d::Zero();
  double pixels_per_m = 1;

  [[nodiscard]] Flat place(const View& view, const Eigen::Vector3d& point) const {
    const Eigen::Vector3d from_middle = point - middle;
    return {kSize / 2 + pixels_per_m * view.right.dot(from_middle),
            kSize / 2 - pixels_per_m * view.up.dot(from_middle)};
  }
};

Scale scale_of(const Body& body) {
  Eigen::Vector3d low = Eigen::Vector3d::Zero(), high = Eigen::Vector3d::Zero();
  const auto take = [&](const Eigen::Vector3d& point) {
    low = low.cwiseMin(point);
    high = high.cwiseMax(point);
  };
  for (const Body::Bone& bone : body.bones) take(bone.from), take(bone.to);
  for (const Body::Part& part : body.parts) take(part.point);
  const double widest = (high - low).maxCoeff();
  return {(low + high) / 2, (kSize - 2 * kMargin) / (widest > 1e-9 ? widest : 1.0)};
}

std::string line(std::string_view look, const Flat& a, const Flat& b) {
  return fmt::format("<line class=\"{}\" x1=\"{:.1f}\" y1=\"{:.1f}\" x2=\"{:.1f}\" y2=\"{:.1f}\"/>\n", look, a.x(),
                     a.y(), b.x(), b.y());
}

std::string circle(std::string_view look, const Flat& at, double radius) {
  return fmt::format("<circle class=\"{}\" cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"{:.1f}\"/>\n", look, at.x(), at.y(), radius);
}

std::string text(std::string_view look, const Flat& at, const std::string& words) {
  return fmt::format("<text class=\"{}\" x=\"{:.1f}\" y=\"{:.1f}\">{}</text>\n", look, at.x(), at.y(),
                     svg::escaped(words));
}

/// Towards the reader it is a dot in a circle, away from them a cross in one.
std::string arrow(std::string_view look, const View& view, const Flat& from, const Eigen::Vector3d& direction,
                  double length) {
  const Flat flat(view.right.dot(direction), -view.up.dot(direction));
  if (flat.norm() < 0.3) {
    const double r = 7, d = 4.2;
    const std::string ring = circle(fmt::format("{} ring", look), from, r);
    if (view.near.dot(direction) > 0) return ring + circle(fmt::format("{} tip", look), from, 2.2);
    return ring + line(look, from - Flat(d, d), from + Flat(d, d)) + line(look, from - Flat(d, -d), from + Flat(d, -d));
  }
  const Flat tip = from + length * flat;
  const Flat along = 7 * flat.normalized(), across(-along.y() / 2, along.x() / 2);
  const Flat left = tip - along + across, right = tip - along - across;
  return line(look, from, tip - along * 0.6) +
         fmt::format("<path class=\"{} tip\" d=\"M{:.1f} {:.1f}L{:.1f} {:.1f}L{:.1f} {:.1f}Z\"/>\n", look, tip.x(),
                     tip.y(), left.x(), left.y(), right.x(), right.y());
}

/// From where to where an arrow is drawn.
struct Shaft {
  Flat from, to;

  [[nodiscard]] double distance(const Flat& point) const {
    const Flat along = to - from;
    const double share = along.dot(point - from) / std::max(along.squaredNorm(), 1e-9);
    return (point - from - std::clamp(share, 0.0, 1.0) * along).norm();
  }
};

/// Puts numbers where none is yet, near what they stand for.
class Labels {
 public:
  /// @param taken  where marks are
  Labels(std::vector<Flat> taken, std::vector<Shaft> shafts) : taken_(std::move(taken)), shafts_(std::move(shafts)) {}

  Flat place(const Flat& point) {
    for (double distance = 2 * kLabel + 2; distance < 60; distance += 8) {
      for (int step = 0; step < 12; ++step) {
        const double angle = 0.5236 * (step % 2 == 0 ? step / 2 : -(step + 1) / 2) - 0.9;
        const Flat at = point + distance * Flat(std::cos(angle), std::sin(angle));
        if (is_free(at)) return taken_.push_back(at), at;
      }
    }
    taken_.push_back(point);
    return point;
  }

 private:
  [[nodiscard]] bool is_free(const Flat& at) const {
    const bool is_inside =
        at.x() > kLabel && at.y() > 2 * kLabel + 12 && at.x() < kSize - kLabel && at.y() < kSize - kLabel;
    const bool is_at_axes = at.x() < 100 && at.y() > kSize - 56;
    return is_inside && !is_at_axes &&
           std::none_of(taken_.begin(), taken_.end(),
                        [&](const Flat& other) { return (at - other).norm() < 2 * kLabel + 1; }) &&
           std::none_of(shafts_.begin(), shafts_.end(),
                        [&](const Shaft& shaft) { return shaft.distance(at) < kLabel + 4; });
  }

  std::vector<Flat> taken_;
  std::vector<Shaft> shafts_;
};

std::string axes_of(const View& view) {
  const Flat corner(16, kSize - 16);
  return line("axis", corner, corner + Flat(28, 0)) + line("axis", corner, corner - Flat(0, 28)) +
         text("axis-name", corner + Flat(32, 4), view.right_name) +
         text("axis-name", corner + Flat(6, -18), view.up_name);
}

/// Arrows from the middle: how hard the robot can push that way beside the hardest way.
std::string authority_of(const Body& body, const View& view, const Scale& scale) {
  const double most = body.authority.maxCoeff();
  if (most <= 0) return {};
  const Flat middle = scale.place(view, Eigen::Vector3d::Zero());
  std::string drawn;
  for (const Eigen::Vector3d& way : {view.right, view.up}) {
    const double share = std::abs(way.dot(body.authority)) / most;
    if (share < 0.02) continue;
    for (const double sign : {1.0, -1.0}) drawn += arrow("authority", view, middle, sign * way, 70 * share);
  }
  return drawn;
}

std::string picture_of(const Body& body, const View& view, const Scale& scale) {
  std::string drawn = authority_of(body, view, scale);
  for (const Body::Bone& bone : body.bones)
    drawn += line("bone", scale.place(view, bone.from), scale.place(view, bone.to));
  std::vector<Flat> points;
  std::vector<Shaft> shafts;
  const std::size_t count = std::min(body.parts.size(), kMostParts);
  for (std::size_t i = 0; i < count; ++i) {
    const Body::Part& part = body.parts[i];
    points.push_back(scale.place(view, part.point));
    if (part.axis) {
      drawn += arrow(part.pushes ? "push" : "spin", view, points.back(), *part.axis, kArrow);
      const Flat flat(view.right.dot(*part.axis), -view.up.dot(*part.axis));
      shafts.push_back({points.back(), points.back() + kArrow * flat});
    }
    drawn += circle("part-mark", points.back(), kMark);
  }
  Labels labels(points, std::move(shafts));
  for (std::size_t i = 0; i < count; ++i) {
    const Flat at = labels.place(points[i]);
    drawn += line("leader", points[i], at) + circle("number", at, kLabel) +
             text("number-text", at + Flat(0, 4), std::to_string(i + 1));
  }
  return fmt::format(
      "<figure><svg class=\"body\" viewBox=\"0 0 {0} {0}\" width=\"{0}\" height=\"{0}\" role=\"img\" "
      "aria-label=\"{1}\">\n{2}{3}</svg><figcaption>{1}</figcaption></figure>\n",
      kSize, view.title, axes_of(view), drawn);
}

/// Whose the numbers are, beside the pictures.
std::string key_of(const Body& body) {
  std::string items;
  for (std::size_t i = 0; i < std::min(body.parts.size(), kMostParts); ++i)
    items += "<li>" + svg::escaped(body.parts[i].device) + "</li>\n";
  return "<ol class=\"key\" aria-label=\"What the numbers stand for\">\n" + items + "</ol>\n";
}

/// How hard the parts that push can push together each way.
std::string authority_table(const Body& body) {
  if (body.authority.maxCoeff() <= 0) return {};
  const std::array<const char*, 3> ways{"ahead and back", "left and right", "up and down"};
  std::string rows;
  for (int k = 0; k < 3; ++k)
    rows += "<tr>" + row_title(ways[k]) + fmt::format("<td>{:.2f}</td></tr>\n", body.authority[k]);
  return table_of("authority-table", "How hard they push together, if each pushes with 1 N (N)",
                  {{"Way"}, {"Together", true}}, rows);
}

std::string part_table(const Body& body) {
  std::string rows;
  const auto metres = [](double value) { return fmt::format("<td>{:.3f}</td>", value); };
  for (std::size_t i = 0; i < body.parts.size(); ++i) {
    const Body::Part& part = body.parts[i];
    rows += "<tr>" + row_title(fmt::format("{} {}", i + 1, part.device)) + word(part.at);
    for (int k = 0; k < 3; ++k) rows += metres(part.point[k]);
    rows += part.axis ? word(fmt::format("{:.2f} {:.2f} {:.2f}", (*part.axis)[0], (*part.axis)[1], (*part.axis)[2]))
                      : word("");
    rows += "</tr>\n";
  }
  return table_of("parts-table", "Devices at their places, in the frame of link '" + body.base + "' (m)",
                  {{"Device"}, {"At"}, {"x", true}, {"y", true}, {"z", true}, {"Axis"}}, rows);
}

}  // namespace

std::string body_pictures(const Body& body) {
  if (body.parts.empty()) return {};
  const Scale scale = scale_of(body);
  std::string text =
      "<p>Links and joints of the URDF with every joint at zero; numbers stand for devices. An arrow is the axis of a "
      "device's joint: a ring with a dot points at you, one with a cross away.";
  if (body.authority.maxCoeff() > 0)
    text += " Wide arrows from the origin compare how hard the thrusters can push together each way.";
  text += "</p>\n<div class=\"views\">\n";
  for (const View& view : kViews) text += picture_of(body, view, scale);
  if (body.parts.size() > kMostParts) text += fmt::format("<p>Only the first {} devices are drawn.</p>\n", kMostParts);
  return text + "</div>\n" + key_of(body) + "<details><summary>Places and axes as a table</summary>\n" +
         part_table(body) + authority_table(body) + "</details>\n";
}

}  // namespace finemote::gen::report
