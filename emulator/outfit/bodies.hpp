// Bodies that sensors sit on and thrusters push.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "emulator/outfit/outfit.hpp"
#include "emulator/plants/submerged_body.hpp"

namespace finemote::emulator {

class ThrustTarget {
 public:
  virtual ~ThrustTarget() = default;
  virtual SubmergedBody& hull() = 0;
};

/// An element that shows where a body is and how it lies.
class BodyElement : public Element, public BodySource {
 public:
  using Element::Element;
  Motion motion_now() { return body().motion(now()); }
  /// `roll` `pitch` `yaw` [deg], `x` `y` `depth` [m].
  static std::vector<scenario::Quantity> values();
};

/// `mass` and `inertia`, with what is usual for them: kg, and kg m^2 as xx xy xz yy yz zz.
std::vector<scenario::Member> weight(double mass, const Eigen::Matrix3d& inertia);
/// Its six numbers as a matrix.
Eigen::Matrix3d inertia_of(const std::vector<double>& numbers);
/// Those of an entry that may have mistakes; none: they are not six numbers.
std::optional<std::vector<double>> given_inertia(const gen::json::Value& entry);
/// Reports FM6009: nothing turns with this `inertia`.
void refuse_inertia(const gen::json::Value& word, gen::Diagnostics& diagnostics);
/// Members of an event that pushes a body: `force` [N, world's axes], `moment` [N m, body's axes].
std::vector<scenario::Member> push();

/// Steps a plant now, and again after every step of its own.
template <class Plant>
void keep_stepping(World& world, Plant& plant) {
  plant.step(world.now());
  world.after(Plant::kStep, [&world, &plant] { keep_stepping(world, plant); });
}

}  // namespace finemote::emulator
