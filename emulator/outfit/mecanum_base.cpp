// A base on mecanum wheels that motors turn.
#include "emulator/plants/mecanum_base.hpp"

#include "emulator/outfit/bodies.hpp"
#include "emulator/outfit/figures.hpp"
#include "emulator/outfit/models.hpp"
#include "emulator/outfit/rows.hpp"
#include "emulator/outfit/seat.hpp"

namespace finemote::emulator {
namespace {

using namespace scenario;

MecanumBase::Parameters base_of(const Json& part) {
  MecanumBase::Parameters p;
  p.mass = need<double>(part, "mass");
  p.inertia = inertia_of(need<std::vector<double>>(part, "inertia"))(2, 2);
  p.grip = need<double>(part, "grip");
  p.friction = need<double>(part, "friction");
  p.drag = need<double>(part, "drag");
  return p;
}

/// Rollers as an X seen from above: those at the ground point from a corner of the base to the one across.
MecanumBase::Wheel wheel_of(Outfit& outfit, const Json& entry, double radius) {
  const Eigen::Vector3d place = vector(entry, "xyz"), axis = vector(entry, "axis").normalized();
  const Eigen::Vector3d way = axis.cross(Eigen::Vector3d::UnitZ());
  MotorShaft* shaft = shaft_of(outfit, entry);
  if (shaft == nullptr) refuse(entry, "the part turns no wheel");
  const double side = place.x() * place.y() > 0 ? -1 : 1;
  return {shaft, radius, place.head<2>(), way.head<2>(), Eigen::Vector2d(1, side).normalized()};
}

class MecanumElement : public BodyElement {
 public:
  MecanumElement(Outfit& outfit, const Json& part, const std::string& name)
      : BodyElement(outfit, name), part_(part), body_(base_of(part)) {}
  Body& body() override { return body_; }
  void connect() override {
    const auto radius = need<double>(part_, "wheel_radius");
    for (const Json& entry : need<Json>(part_, "wheels")) body_.add_wheel(wheel_of(outfit(), entry, radius));
    keep_stepping(outfit().board().world(), body_);
  }
  void disturb(const Json& event) { body_.disturb(now(), vector(event, "force"), vector(event, "moment").z()); }

 private:
  Json part_;
  MecanumBase body_;
};

std::vector<Member> mecanum_figures() {
  const MecanumBase::Parameters usual;
  return weight(usual.mass, Eigen::Matrix3d::Identity() * usual.inertia) +
         std::vector{required(positive("wheel_radius", "m", "")),
                     required(list(Kind::list, "wheels", "",
                                   {required(part("part", "shaft", "that turns it")), vector3("xyz", "m", ""),
                                    usually({0, 1, 0}, vector3("axis", "", ""))})),
                     usually(usual.grip, positive("grip", "N s/m", "force of a contact per speed of sliding")),
                     usually(usual.friction, number("friction", "", "of a contact", 0)),
                     usually(usual.drag, number("drag", "N s/m", "", 0))};
}

/// A base on wheels only yaws.
void check_yaw_inertia(const gen::json::Value& entry, const Model&, const scenario::World&,
                       gen::Diagnostics& diagnostics) {
  const auto inertia = given_inertia(entry);
  if (inertia && inertia_of(*inertia)(2, 2) <= 0) refuse_inertia(*entry.find("inertia"), diagnostics);
}

}  // namespace

Model mecanum_base() {
  using Row = Rows<MecanumElement>;
  return {
      .type = "mecanum_base",
      .summary = "rolls on the `wheels` that motors turn, and slides where they push too hard",
      .is = {"body"},
      .figures = mecanum_figures(),
      .verbs = {Row::stimulus("disturb", "from now on; without members, no more", push(),
                              [](MecanumElement& part, const Json& event) { part.disturb(event); })},
      .values = BodyElement::values(),
      .make = Row::make,
      .check = check_yaw_inertia,
  };
}

}  // namespace finemote::emulator
