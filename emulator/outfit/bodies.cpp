// Bodies that sensors sit on and thrusters push.
#include "emulator/outfit/bodies.hpp"

#include <numbers>

#include "emulator/plants/standing_body.hpp"
#include "emulator/plants/submerged_body.hpp"

namespace finemote::emulator {
namespace {

constexpr double kDegree = std::numbers::pi / 180;

class StandingElement : public BodyElement {
 public:
  explicit StandingElement(Outfit& outfit) : BodyElement(outfit) {
    on("move", [this, &outfit](const Json& event) { move_by_hand(body_, outfit.now(), event); });
  }
  Body& body() override { return body_; }

 private:
  StandingBody body_;
};

SubmergedBody::Parameters submerged(const Json& part) {
  SubmergedBody::Parameters p;
  p.mass = maybe(part, "mass", p.mass);
  p.inertia = inertia_of(part, p.inertia);
  p.added_mass = maybe(part, "added_mass", p.added_mass);
  p.linear_drag = maybe(part, "linear_drag", p.linear_drag);
  p.quadratic_drag = maybe(part, "quadratic_drag", p.quadratic_drag);
  p.buoyancy = maybe(part, "buoyancy", p.buoyancy);
  p.righting = maybe(part, "righting", p.righting);
  if (p.mass <= 0 || p.inertia.determinant() <= 0) refuse(part, "mass and inertia are above zero");
  return p;
}

class SubmergedElement : public BodyElement, public ThrustTarget {
 public:
  SubmergedElement(Outfit& outfit, const Json& part) : BodyElement(outfit), body_(submerged(part)) {
    on("disturb", [this, &outfit](const Json& event) {
      body_.disturb(outfit.now(), vector(event, "force"), vector(event, "moment"));
    });
  }
  Body& body() override { return body_; }
  SubmergedBody& hull() override { return body_; }

 private:
  SubmergedBody body_;
};

}  // namespace

double degrees_of(const Motion& motion, double Angles::*axis) { return angles_of(motion.attitude).*axis / kDegree; }

BodyElement::BodyElement(Outfit& outfit) {
  const auto now = [this, &outfit] { return body().motion(outfit.now()); };
  show("roll", [now] { return degrees_of(now(), &Angles::roll); });
  show("pitch", [now] { return degrees_of(now(), &Angles::pitch); });
  show("yaw", [now] { return degrees_of(now(), &Angles::yaw); });
  show("x", [now] { return now().position.x(); });
  show("y", [now] { return now().position.y(); });
  show("depth", [now] { return -now().position.z(); });
}

Eigen::Matrix3d inertia_of(const Json& part, const Eigen::Matrix3d& fallback) {
  if (!part.contains("inertia")) return fallback;
  const auto i = need<std::vector<double>>(part, "inertia");
  if (i.size() != 6) refuse(part, "'inertia' has six numbers: xx xy xz yy yz zz");
  Eigen::Matrix3d inertia;
  inertia << i[0], i[1], i[2], i[1], i[3], i[4], i[2], i[4], i[5];
  return inertia;
}

std::vector<JointStep> way_of(Outfit& outfit, const Json& list) {
  std::vector<JointStep> way;
  for (const Json& entry : list) {
    const Eigen::Vector3d rpy = vector(entry, "rpy");
    JointStep step;
    step.xyz = vector(entry, "xyz");
    step.rpy = Angles{rpy[0], rpy[1], rpy[2]};
    step.axis = vector(entry, "axis", step.axis).normalized();
    if (entry.contains("part")) step.shaft = shaft_of(outfit, entry);
    way.push_back(step);
  }
  return way;
}

MotorShaft* shaft_of(Outfit& outfit, const Json& entry) {
  const auto name = need<std::string>(entry, "part");
  if (outfit.find<Element>(name) == nullptr) refuse(entry, "there is no such part");
  auto* motor = outfit.find<ShaftSource>(name);
  return motor == nullptr ? nullptr : &motor->shaft();
}

void move_by_hand(StandingBody& body, Time now, const Json& event) {
  if (event.contains("roll") || event.contains("pitch") || event.contains("yaw")) {
    const Angles was = angles_of(body.motion(now).attitude);
    body.place(now, Angles{maybe(event, "roll", was.roll / kDegree) * kDegree,
                           maybe(event, "pitch", was.pitch / kDegree) * kDegree,
                           maybe(event, "yaw", was.yaw / kDegree) * kDegree});
  }
  if (event.contains("rate")) body.turn(now, vector(event, "rate") * kDegree);
  if (event.contains("acceleration")) body.push(now, vector(event, "acceleration"));
}

Body& Seat::body() { return mount_ != nullptr ? static_cast<Body&>(*mount_) : own_; }

void Seat::connect(Outfit& outfit) {
  if (!part_.contains("body")) return;
  auto* source = outfit.find<BodySource>(need<std::string>(part_, "body"));
  if (source == nullptr) refuse(part_, "there is no such body");
  mount_ = std::make_unique<Mount>(source->body(), way_of(outfit, maybe(part_, "way", Json::array())));
}

/// Moved by an event, it follows its body no more.
void Seat::move(Time now, const Json& event) {
  if (mount_ != nullptr) own_.place(now, angles_of(mount_->motion(now).attitude));
  mount_.reset();
  move_by_hand(own_, now, event);
}

std::unique_ptr<Element> make_standing_body(Outfit& outfit, const Json&, const std::string&) {
  return std::make_unique<StandingElement>(outfit);
}

std::unique_ptr<Element> make_submerged_body(Outfit& outfit, const Json& part, const std::string&) {
  return std::make_unique<SubmergedElement>(outfit, part);
}

}  // namespace finemote::emulator
