#include "emulator/outfit/bodies.hpp"

#include "emulator/outfit/models.hpp"
#include "emulator/outfit/rows.hpp"
#include "emulator/outfit/seat.hpp"
#include "emulator/plants/standing_body.hpp"
#include "emulator/scenario/values.hpp"
#include "generator/diagnostic/code_scenario.hpp"

namespace finemote::emulator {
namespace {

using namespace scenario;

class StandingElement : public BodyElement {
 public:
  StandingElement(Outfit& outfit, const Json&, const std::string& name) : BodyElement(outfit, name) {}
  Body& body() override { return body_; }
  void move(const Json& event) { move_by_hand(body_, now(), event); }

 private:
  StandingBody body_;
};

SubmergedBody::Parameters submerged(const Json& part) {
  SubmergedBody::Parameters p;
  p.mass = need<double>(part, "mass");
  p.inertia = inertia_of(need<std::vector<double>>(part, "inertia"));
  p.added_mass = need<double>(part, "added_mass");
  p.linear_drag = need<double>(part, "linear_drag");
  p.quadratic_drag = need<double>(part, "quadratic_drag");
  p.buoyancy = need<double>(part, "buoyancy");
  p.righting = need<double>(part, "righting");
  return p;
}

class SubmergedElement : public BodyElement, public ThrustTarget {
 public:
  SubmergedElement(Outfit& outfit, const Json& part, const std::string& name)
      : BodyElement(outfit, name), body_(submerged(part)) {}
  Body& body() override { return body_; }
  SubmergedBody& hull() override { return body_; }
  void disturb(const Json& event) { body_.disturb(now(), vector(event, "force"), vector(event, "moment")); }

 private:
  SubmergedBody body_;
};

std::vector<Member> water() {
  const SubmergedBody::Parameters usual;
  return {usually(usual.added_mass, number("added_mass", "", "share of mass and inertia", 0)),
          usually(usual.linear_drag, number("linear_drag", "N s/m", "per kg", 0)),
          usually(usual.quadratic_drag, number("quadratic_drag", "N s^2/m^2", "per kg", 0)),
          usually(usual.buoyancy, number("buoyancy", "", "lift as share of the weight")),
          usually(usual.righting, number("righting", "m", "centre of buoyancy above that of mass"))};
}

void check_inertia(const gen::json::Value& entry, const Model&, const scenario::World&, gen::Diagnostics& diagnostics) {
  const auto inertia = given_inertia(entry);
  if (inertia && inertia_of(*inertia).determinant() <= 0) refuse_inertia(*entry.find("inertia"), diagnostics);
}

}  // namespace

std::vector<Quantity> BodyElement::values() {
  using Row = Rows<BodyElement>;
  return {
      Row::value("roll", "deg", "", [](BodyElement& part) { return degrees_of(part.motion_now(), &Angles::roll); }),
      Row::value("pitch", "deg", "", [](BodyElement& part) { return degrees_of(part.motion_now(), &Angles::pitch); }),
      Row::value("yaw", "deg", "", [](BodyElement& part) { return degrees_of(part.motion_now(), &Angles::yaw); }),
      Row::value("x", "m", "", [](BodyElement& part) { return part.motion_now().position.x(); }),
      Row::value("y", "m", "", [](BodyElement& part) { return part.motion_now().position.y(); }),
      Row::value("depth", "m", "below the world's z = 0",
                 [](BodyElement& part) { return -part.motion_now().position.z(); })};
}

std::vector<Member> weight(double mass, const Eigen::Matrix3d& inertia) {
  const Eigen::Matrix3d& i = inertia;
  return {usually(mass, positive("mass", "kg", "")),
          usually({i(0, 0), i(0, 1), i(0, 2), i(1, 1), i(1, 2), i(2, 2)},
                  row(Kind::six, "inertia", "kg m^2", "xx xy xz yy yz zz, about its origin"))};
}

Eigen::Matrix3d inertia_of(const std::vector<double>& i) {
  Eigen::Matrix3d inertia;
  inertia << i[0], i[1], i[2], i[1], i[3], i[4], i[2], i[4], i[5];
  return inertia;
}

void refuse_inertia(const gen::json::Value& word, gen::Diagnostics& diagnostics) {
  diagnostics
      .error(gen::code::scenario_range, word.at, "'inertia' must be above zero: a body with this one cannot turn")
      .hint("\"inertia\": [0.1, 0, 0, 0.1, 0, 0.1]");
}

std::optional<std::vector<double>> given_inertia(const gen::json::Value& entry) {
  const gen::json::Value* word = entry.find("inertia");
  if (word == nullptr || word->items.size() != 6) return std::nullopt;
  std::vector<double> numbers;
  for (const gen::json::Value& item : word->items)
    numbers.push_back(item.is(gen::json::Value::Kind::number) ? number_of(item) : 1);
  return numbers;
}

std::vector<Member> push() {
  return {vector3("force", "N", "along the world's axes"), vector3("moment", "N m", "about the body's axes")};
}

Model standing_body() {
  using Row = Rows<StandingElement>;
  return {
      .type = "standing_body",
      .summary = "stays still until events move it",
      .is = {"body"},
      .verbs = {with_member(Row::stimulus("move", "holds it in this pose", pose(),
                                          [](StandingElement& part, const Json& event) { part.move(event); }))},
      .values = BodyElement::values(),
      .make = Row::make,
  };
}

Model submerged_body() {
  using Row = Rows<SubmergedElement>;
  const SubmergedBody::Parameters usual;
  return {
      .type = "submerged_body",
      .summary = "floating rigid body with added mass, drag, and buoyancy above its centre of mass",
      .is = {"body", "hull"},
      .figures = weight(usual.mass, usual.inertia) + water(),
      .verbs = {Row::stimulus("disturb", "from now on; without members, no more", push(),
                              [](SubmergedElement& part, const Json& event) { part.disturb(event); })},
      .values = BodyElement::values(),
      .make = Row::make,
      .check = check_inertia,
  };
}

}  // namespace finemote::emulator
