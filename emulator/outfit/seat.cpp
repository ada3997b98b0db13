#include "emulator/outfit/seat.hpp"

#include <numbers>

#include "emulator/outfit/figures.hpp"
#include "emulator/outfit/rows.hpp"

namespace finemote::emulator {
namespace {

using namespace scenario;

constexpr double kDegree = std::numbers::pi / 180;

}  // namespace

std::vector<Member> seat() {
  return {part("body", "body", "it sits on; without, events move it"),
          list(Kind::list, "way", "joints from the body to it", joint_steps())};
}

std::vector<Member> pose() {
  return {number("roll", "deg", ""), number("pitch", "deg", ""), number("yaw", "deg", ""),
          vector3("rate", "deg/s", "about its own axes"), vector3("acceleration", "m/s^2", "along the world's axes")};
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

double degrees_of(const Motion& motion, double Angles::*axis) { return angles_of(motion.attitude).*axis / kDegree; }

MotorShaft* shaft_of(Outfit& outfit, const Json& entry) {
  const auto name = need<std::string>(entry, "part");
  if (outfit.find<Element>(name) == nullptr) refuse(entry, "there is no such part");
  auto* motor = outfit.find<ShaftSource>(name);
  return motor == nullptr ? nullptr : &motor->shaft();
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

Body& body_of(Outfit& outfit, const Json& entry) {
  auto* source = outfit.find<BodySource>(need<std::string>(entry, "body"));
  if (source == nullptr) refuse(entry, "there is no such body");
  return source->body();
}

Body& SeatedElement::body() { return mount_ != nullptr ? static_cast<Body&>(*mount_) : own_; }

void SeatedElement::connect() {
  if (!part_.contains("body")) return;
  mount_ = std::make_unique<Mount>(body_of(outfit(), part_), way_of(outfit(), maybe(part_, "way", Json::array())));
}

void SeatedElement::move(const Json& event) {
  if (mount_ != nullptr) own_.place(now(), angles_of(mount_->motion(now()).attitude));
  mount_.reset();
  move_by_hand(own_, now(), event);
}

Verb SeatedElement::move_verb() {
  return with_member(Rows<SeatedElement>::stimulus("move", "holds it in this pose; it no longer follows its body",
                                                   pose(),
                                                   [](SeatedElement& part, const Json& event) { part.move(event); }));
}

}  // namespace finemote::emulator
