// Where a sensor sits: on a body, over joints, or in the hands of events.
#pragma once

#include <memory>
#include <vector>

#include "emulator/outfit/element.hpp"
#include "emulator/plants/mount.hpp"
#include "emulator/plants/standing_body.hpp"
#include "emulator/scenario/grammar.hpp"

namespace finemote::emulator {

/// Figures of its entry: `body`, and the `way` from it.
std::vector<scenario::Member> seat();
/// Members of an event that places a body: `roll` `pitch` `yaw` [deg], `rate` [deg/s, own axes], `acceleration` [m/s^2,
/// world's axes].
std::vector<scenario::Member> pose();
/// Makes that event happen.
void move_by_hand(StandingBody& body, Time now, const Json& event);

/// Degrees of an attitude about one axis.
double degrees_of(const Motion& motion, double Angles::*axis);

/// The shaft of the entry's `part`; null: a part that turns nothing. @throws std::invalid_argument: there is none
MotorShaft* shaft_of(Outfit& outfit, const Json& entry);
/// Joints of an entry: `xyz`, `rpy`, and, of one that is driven, `axis` and `part`; a part that turns nothing stands.
std::vector<JointStep> way_of(Outfit& outfit, const Json& list);
/// The body of the entry's `body`. @throws std::invalid_argument: there is none
Body& body_of(Outfit& outfit, const Json& entry);

/// A sensor that feels the motion of where it sits.
class SeatedElement : public Element {
 public:
  SeatedElement(Outfit& outfit, const Json& part, const std::string& name) : Element(outfit, name), part_(part) {}
  void connect() override;
  Motion motion(Time at) { return body().motion(at); }
  /// Moved by an event, it follows its body no more.
  void move(const Json& event);
  /// `move` of sensors that have nothing but a pose.
  static scenario::Verb move_verb();

 private:
  Body& body();
  Json part_;
  StandingBody own_;
  std::unique_ptr<Mount> mount_;
};

}  // namespace finemote::emulator
