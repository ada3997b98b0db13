// Elements of one link or joint to their parts: as ROS tools read them, with a word on what these skip silently.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "generator/diagnostic/diagnostics.hpp"
#include "generator/urdf/urdf.hpp"
#include "generator/xml/node.hpp"

namespace finemote::gen {

/// Of a length, angle, mass or inertia: what a robot has in m, rad, kg or kg m^2 is between this and its negative;
/// beyond it sums and products leave the range of a float.
constexpr double kLargestInUrdf = 1e9;

/// Reads the parts of one link or joint.
///
/// Reports FM2008 (malformed numbers), FM2012 (a number nothing has), FM3010 (a part that is missing) and FM3084 (a
/// needed one that is misspelt); collects a doubt where a part that may be missing is misspelt, or stands twice.
class ElementReader {
 public:
  enum class Owner { link, joint };
  /// @param owner  the `<link>` or `<joint>`, whose own name may be misspelt
  ElementReader(Owner kind, const xml::Node& owner, Diagnostics& diagnostics)
      : kind_(kind), owner_(owner), diagnostics_(diagnostics) {}

  enum class Need {
    optional,
    by_ros,  ///< urdfdom will say that it is missing
    strict,  ///< FM3010
  };
  /// The first child of that name, which is the one that counts; null: none.
  const xml::Node* child(const xml::Node& node, std::string_view name, Need need = Need::optional);
  const xml::Attribute* attribute(const xml::Node& node, std::string_view name, Need need = Need::optional);

  std::optional<double> number(const xml::Node& node, std::string_view name, Need need = Need::optional);
  /// A number of an inertial, from `least` to kLargestInUrdf; 0 where it is wrong.
  double amount(const xml::Node& node, std::string_view name, double least);
  /// `count` numbers up to kLargestInUrdf; none where they are missing or wrong.
  std::optional<std::vector<double>> numbers(const xml::Node& node, std::string_view name, std::size_t count);
  /// The `<origin>` of a joint or inertial.
  Pose origin(const xml::Node& node);

  /// An error about the owner.
  Diagnostic& mistake(Code code, Position at, std::string message);
  [[nodiscard]] bool is_wrong() const { return is_wrong_; }
  [[nodiscard]] std::vector<Doubt> take_doubts() { return std::move(doubts_); }

 private:
  void report_missing(const xml::Node& node, std::string_view name, bool is_attribute, Need need);
  void misspelt(Position at, std::size_t length, const std::string& what, const std::string& meant, Need need);
  void doubt(Diagnostic finding, bool is_missing);
  [[nodiscard]] std::string owner_text() const;
  bool check_range(const xml::Node& node, const xml::Attribute& found, const std::vector<double>& values, double least);
  std::array<double, 3> turned(const xml::Node& origin);

  Owner kind_;
  const xml::Node& owner_;
  Diagnostics& diagnostics_;
  std::vector<Doubt> doubts_;
  bool is_wrong_ = false;
};

}  // namespace finemote::gen
