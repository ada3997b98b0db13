// How elements sit on bodies and push them.
#pragma once

#include "emulator/outfit.hpp"
#include "emulator/plants/mount.hpp"
#include "emulator/plants/standing_body.hpp"
#include "emulator/plants/submerged_body.hpp"

namespace finemote::emulator {

class ThrustTarget {
 public:
  virtual ~ThrustTarget() = default;
  virtual SubmergedBody& hull() = 0;
};

/// An element that shows where a body is and how it lies: `roll` `pitch` `yaw` [deg], `x` `y` `depth` [m].
class BodyElement : public Element, public BodySource {
 protected:
  explicit BodyElement(Outfit& outfit);
};

/// Degrees of an attitude about one axis.
double degrees_of(const Motion& motion, double Angles::*axis);

/// `inertia` of an entry: xx xy xz yy yz zz [kg m^2].
Eigen::Matrix3d inertia_of(const Json& part, const Eigen::Matrix3d& fallback);

/// The shaft of the entry's `part`; null: a part that turns nothing. @throws std::invalid_argument: there is none
MotorShaft* shaft_of(Outfit& outfit, const Json& entry);

/// Joints of an entry: `xyz`, `rpy`, and, of one that is driven, `axis` and `part`; a part that turns nothing stands.
std::vector<JointStep> way_of(Outfit& outfit, const Json& list);

/// An event's `roll` `pitch` `yaw` [deg], `rate` [deg/s, own axes], `acceleration` [m/s^2, world's axes].
void move_by_hand(StandingBody& body, Time now, const Json& event);

/// Where a sensor sits: on the `body` of its entry, over the joints of its `way`; without, in the hands of events.
class Seat {
 public:
  explicit Seat(const Json& part) : part_(part) {}
  void connect(Outfit& outfit);
  Motion motion(Time now) { return body().motion(now); }
  void move(Time now, const Json& event);

 private:
  Body& body();
  Json part_;
  StandingBody own_;
  std::unique_ptr<Mount> mount_;
};

}  // namespace finemote::emulator
