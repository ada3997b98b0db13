// What motors move besides themselves: a base on mecanum wheels, the weight of what hangs at joints.
#include "emulator/outfit/bodies.hpp"
#include "emulator/plants/mecanum_base.hpp"
#include "emulator/plants/weights.hpp"

namespace finemote::emulator {
namespace {

/// Steps it now, and again after every step of its own.
template <class Plant>
void keep_stepping(World& world, Plant& plant) {
  plant.step(world.now());
  world.after(Plant::kStep, [&world, &plant] { keep_stepping(world, plant); });
}

MecanumBase::Parameters base_of(const Json& part) {
  MecanumBase::Parameters p;
  p.mass = maybe(part, "mass", p.mass);
  p.inertia = inertia_of(part, Eigen::Matrix3d::Identity() * p.inertia)(2, 2);
  p.grip = maybe(part, "grip", p.grip);
  p.friction = maybe(part, "friction", p.friction);
  p.drag = maybe(part, "drag", p.drag);
  if (p.mass <= 0 || p.inertia <= 0) refuse(part, "mass and inertia are above zero");
  return p;
}

class MecanumElement : public BodyElement {
 public:
  MecanumElement(Outfit& outfit, const Json& part) : BodyElement(outfit), part_(part), body_(base_of(part)) {
    on("disturb", [this, &outfit](const Json& event) {
      body_.disturb(outfit.now(), vector(event, "force"), vector(event, "moment").z());
    });
  }
  Body& body() override { return body_; }
  void connect(Outfit& outfit) override {
    const auto radius = need<double>(part_, "wheel_radius");
    for (const Json& entry : need<Json>(part_, "wheels")) body_.add_wheel(wheel(outfit, entry, radius));
    keep_stepping(outfit.board().world(), body_);
  }

 private:
  /// Rollers as an X seen from above: those at the ground point from a corner of the base to the one across.
  static MecanumBase::Wheel wheel(Outfit& outfit, const Json& entry, double radius) {
    const Eigen::Vector3d place = vector(entry, "xyz"), axis = vector(entry, "axis", {0, 1, 0}).normalized();
    const Eigen::Vector3d way = axis.cross(Eigen::Vector3d::UnitZ());
    MotorShaft* shaft = shaft_of(outfit, entry);
    if (shaft == nullptr) refuse(entry, "the part turns no wheel");
    const double side = place.x() * place.y() > 0 ? -1 : 1;
    return {shaft, radius, place.head<2>(), way.head<2>(), Eigen::Vector2d(1, side).normalized()};
  }

  Json part_;
  MecanumBase body_;
};

class WeightsElement : public Element {
 public:
  explicit WeightsElement(const Json& part) : part_(part) {}
  void connect(Outfit& outfit) override {
    auto* source = outfit.find<BodySource>(need<std::string>(part_, "body"));
    if (source == nullptr) refuse(part_, "there is no such body");
    weights_ = std::make_unique<Weights>(source->body());
    for (const Json& entry : need<Json>(part_, "joints")) add(outfit, entry);
    keep_stepping(outfit.board().world(), *weights_);
  }

 private:
  void add(Outfit& outfit, const Json& entry) {
    Weights::Node node;
    node.shaft = shaft_of(outfit, entry);
    if (entry.contains("before")) {
      const auto before = numbers_.find(need<std::string>(entry, "before"));
      if (before == numbers_.end()) refuse(entry, "the joint before it comes after it");
      node.before = before->second;
    }
    node.way = way_of(outfit, maybe(entry, "way", Json::array()));
    node.axis = vector(entry, "axis", node.axis).normalized();
    node.mass = need<double>(entry, "mass");
    node.centre = vector(entry, "centre");
    numbers_[need<std::string>(entry, "part")] = weights_->add(node);
  }

  Json part_;
  std::unique_ptr<Weights> weights_;
  std::map<std::string, std::size_t> numbers_;
};

}  // namespace

std::unique_ptr<Element> make_mecanum_base(Outfit& outfit, const Json& part, const std::string&) {
  return std::make_unique<MecanumElement>(outfit, part);
}
std::unique_ptr<Element> make_weights(Outfit&, const Json& part, const std::string&) {
  return std::make_unique<WeightsElement>(part);
}

}  // namespace finemote::emulator
