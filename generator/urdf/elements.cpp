#include "generator/urdf/elements.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "generator/diagnostic/code_urdf.hpp"
#include "generator/diagnostic/suggest.hpp"

namespace finemote::gen {
namespace {

/// What may stand in an element, read by us or not: none of it is a misspelt other one.
struct Vocabulary {
  std::string_view element;
  std::vector<std::string_view> words;
};

bool is_known(std::string_view element, std::string_view word) {
  static const std::vector<Vocabulary> kWords{
      {"joint",
       {"name", "type", "parent", "child", "origin", "axis", "limit", "dynamics", "mimic", "calibration",
        "safety_controller"}},
      {"link", {"name", "type", "inertial", "visual", "collision"}},
      {"inertial", {"origin", "mass", "inertia"}},
      {"inertia", {"ixx", "ixy", "ixz", "iyy", "iyz", "izz"}},
      {"origin", {"xyz", "rpy", "quat_xyzw"}},
      {"limit", {"lower", "upper", "effort", "velocity", "acceleration", "deceleration", "jerk"}},
      {"dynamics", {"damping", "friction"}},
      {"mimic", {"joint", "multiplier", "offset"}}};
  return std::any_of(kWords.begin(), kWords.end(), [&](const Vocabulary& entry) {
    return entry.element == element && std::find(entry.words.begin(), entry.words.end(), word) != entry.words.end();
  });
}

bool is_space(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; }

/// Numbers separated by white space; empty when one is malformed or not finite.
std::vector<double> parse_numbers(std::string_view text) {
  std::vector<double> numbers;
  while (true) {
    while (!text.empty() && is_space(text.front())) text.remove_prefix(1);
    if (text.empty()) return numbers;
    if (text.front() == '+') text.remove_prefix(1);
    double value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    const bool stops = end == text.data() + text.size() || is_space(*end);
    if (error != std::errc() || !std::isfinite(value) || !stops) return {};
    numbers.push_back(value);
    text.remove_prefix(static_cast<std::size_t>(end - text.data()));
  }
}

/// Roll, pitch and yaw of a quaternion x y z w of unit length.
std::array<double, 3> rpy_of(double x, double y, double z, double w) {
  const double sine = std::clamp(2 * (w * y - z * x), -1.0, 1.0);
  return {std::atan2(2 * (w * x + y * z), 1 - 2 * (x * x + y * y)), std::asin(sine),
          std::atan2(2 * (w * z + x * y), 1 - 2 * (y * y + z * z))};
}

/// What counts where an optional part is missing.
std::string default_text(std::string_view element, std::string_view name) {
  if (name == "xyz" || name == "rpy") return element == "axis" ? "1 0 0" : "0 0 0";
  return name == "lower" || name == "upper" || name == "damping" || name == "friction" ? "0" : "";
}

}  // namespace

std::string ElementReader::owner_text() const {
  const char* kind = kind_ == Owner::joint ? "joint" : "link";
  const xml::Attribute* name = owner_.attribute("name");
  return name == nullptr ? fmt::format("<{}>", kind) : fmt::format("{} '{}'", kind, name->value);
}

Diagnostic& ElementReader::mistake(Code code, Position at, std::string message) {
  is_wrong_ = true;
  return diagnostics_.error(code, at, std::move(message));
}

void ElementReader::doubt(Diagnostic finding, bool is_missing) {
  const xml::Attribute* name = owner_.attribute("name");
  const std::string owner = name == nullptr ? std::string() : name->value;
  const bool is_joint = kind_ == Owner::joint;
  doubts_.push_back({is_joint ? owner : "", is_joint ? "" : owner, is_missing, std::move(finding)});
}

void ElementReader::misspelt(Position at, std::size_t length, const std::string& what, const std::string& meant,
                             Need need) {
  Diagnostic finding{Severity::warning, code::urdf_misspelt, at, length, "unknown " + what, {}, {}};
  finding.hint(fmt::format("did you mean {}?", meant));
  if (need == Need::optional) {
    doubt(finding.note("ROS tools skip it silently, and so does finemote"), true);
  } else {
    finding.severity = Severity::error;
    mistake(finding.code, at, {}) = finding;
  }
}

void ElementReader::report_missing(const xml::Node& node, std::string_view name, bool is_attribute, Need need) {
  const std::string where = &node == &owner_ ? owner_text() : fmt::format("<{}> of {}", node.name, owner_text());
  const auto is_near = [&](const std::string& word) { return is_mistyped(word, name) && !is_known(node.name, word); };
  for (const xml::Attribute& other : node.attributes) {
    if (!is_attribute || !is_near(other.name)) continue;
    const std::string otherwise = default_text(node.name, name);
    return misspelt(other.at, other.name.size(),
                    fmt::format("attribute '{}' in {}{}", other.name, where,
                                otherwise.empty() ? "" : fmt::format(", where '{}' is {} by default", name, otherwise)),
                    fmt::format("'{}'", name), need);
  }
  for (const xml::Node& other : node.children) {
    if (is_attribute || !other.is_element() || !is_near(other.name)) continue;
    return misspelt(other.at, other.name.size() + 1, fmt::format("element <{}> in {}", other.name, where),
                    fmt::format("<{}>", name), need);
  }
  if (need != Need::strict) return;
  Diagnostic& finding = mistake(
      code::attribute_missing, node.at,
      fmt::format("<{}> has no {}", node.name, is_attribute ? fmt::format("'{}'", name) : fmt::format("<{}>", name)));
  finding.underline(node.name.size() + 1);
  if (!is_attribute) finding.hint(fmt::format("add <{} link=\"...\"/>", name));
}

const xml::Node* ElementReader::child(const xml::Node& node, std::string_view name, Need need) {
  const xml::Node* first = nullptr;
  for (const xml::Node& candidate : node.children) {
    if (!candidate.is_element(name)) continue;
    if (first != nullptr) {
      Diagnostic finding{Severity::warning, code::urdf_twice, candidate.at, name.size() + 1, {}, {}, {}};
      finding.message =
          fmt::format("{}{} has a second <{}>", &node == &owner_ ? "" : "<" + node.name + "> of ", owner_text(), name);
      doubt(finding.note("the first one is here; like ROS tools, finemote reads that one alone", first->at)
                .hint("remove one of them"),
            false);
    } else {
      first = &candidate;
    }
  }
  if (first == nullptr) report_missing(node, name, false, need);
  return first;
}

const xml::Attribute* ElementReader::attribute(const xml::Node& node, std::string_view name, Need need) {
  const xml::Attribute* found = node.attribute(name);
  if (found == nullptr) report_missing(node, name, true, need);
  return found;
}

bool ElementReader::check_range(const xml::Node& node, const xml::Attribute& found, const std::vector<double>& values,
                                double least) {
  for (const double value : values) {
    if (value >= least && value <= kLargestInUrdf) continue;
    mistake(code::urdf_range, found.value_at,
            fmt::format("'{}' of <{}> is out of range: {:g}", found.name, node.name, value))
        .underline(found.value.size())
        .hint(fmt::format("write {} from {:g} to {:g}", values.size() == 1 ? "a number" : "numbers", least,
                          kLargestInUrdf));
    return false;
  }
  return true;
}

std::optional<std::vector<double>> ElementReader::numbers(const xml::Node& node, std::string_view name,
                                                          std::size_t count) {
  const xml::Attribute* found = attribute(node, name);
  if (found == nullptr) return {};
  std::vector<double> values = parse_numbers(found->value);
  if (values.size() == count) {
    if (!check_range(node, *found, values, -kLargestInUrdf)) return {};
    return values;
  }
  mistake(code::urdf_number, found->value_at,
          fmt::format("'{}' of <{}> has to be {} numbers", name, node.name, count == 3 ? "three" : "four"))
      .underline(found->value.size())
      .hint(fmt::format("for example {}=\"{}\"", name, count == 3 ? "0.1 0 -0.25" : "0 0 0 1"));
  return {};
}

std::optional<double> ElementReader::number(const xml::Node& node, std::string_view name, Need need) {
  const xml::Attribute* found = attribute(node, name, need);
  if (found == nullptr) return {};
  const std::vector<double> values = parse_numbers(found->value);
  if (values.size() == 1) return values.front();
  mistake(code::urdf_number, found->value_at, fmt::format("'{}' of <{}> has to be a number", name, node.name))
      .underline(found->value.size());
  return {};
}

double ElementReader::amount(const xml::Node& node, std::string_view name, double least) {
  const auto value = number(node, name, Need::by_ros);
  const bool is_right = value && check_range(node, *node.attribute(name), {*value}, least);
  return is_right ? *value : 0;
}

/// `rpy`, or `quat_xyzw`, which newer ROS tools read as well.
std::array<double, 3> ElementReader::turned(const xml::Node& origin) {
  const xml::Attribute* quaternion = origin.attribute("quat_xyzw");
  if (quaternion == nullptr) {
    const auto rpy = numbers(origin, "rpy", 3);
    return rpy ? std::array<double, 3>{(*rpy)[0], (*rpy)[1], (*rpy)[2]} : std::array<double, 3>{};
  }
  if (origin.attribute("rpy") != nullptr) {
    mistake(code::urdf_twice, quaternion->at, "<origin> has both 'rpy' and 'quat_xyzw'")
        .underline(quaternion->name.size())
        .hint("remove one of them");
    return {};
  }
  const auto q = numbers(origin, "quat_xyzw", 4);
  if (!q) return {};
  const double length = std::hypot(std::hypot((*q)[0], (*q)[1]), std::hypot((*q)[2], (*q)[3]));
  constexpr double kShortest = 1e-9;
  if (length > kShortest) return rpy_of((*q)[0] / length, (*q)[1] / length, (*q)[2] / length, (*q)[3] / length);
  mistake(code::urdf_range, quaternion->value_at, "'quat_xyzw' of <origin> has length 0, and turns to nowhere")
      .underline(quaternion->value.size())
      .hint("write for example quat_xyzw=\"0 0 0 1\", which does not turn");
  return {};
}

Pose ElementReader::origin(const xml::Node& node) {
  Pose pose;
  const xml::Node* tag = child(node, "origin");
  if (tag == nullptr) return pose;
  if (const auto xyz = numbers(*tag, "xyz", 3)) std::copy(xyz->begin(), xyz->end(), pose.xyz.begin());
  pose.rpy = turned(*tag);
  return pose;
}

}  // namespace finemote::gen
