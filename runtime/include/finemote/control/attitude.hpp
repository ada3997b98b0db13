// Turns rates and acceleration into attitude: a complementary filter on the unit quaternion.
#pragma once

#include "finemote/interfaces/imu.hpp"

namespace finemote {

/// Integrates the rates and lets the direction of gravity correct roll and pitch, the Mahony filter with proportional
/// and integral feedback (R. Mahony et al., IEEE Trans. Automatic Control 53(5), 2008, explicit complementary filter).
/// Yaw is integrated alone: it drifts with the gyroscope's offset about the vertical.
///
/// The first acceleration sets roll and pitch at once. Acceleration counts only while its size is near gravity's.
class AttitudeFilter {
 public:
  /// How strongly gravity corrects.
  struct Gains {
    float kp = 0.5F;   ///< 1/s, how fast gravity pulls the attitude
    float ki = 0.01F;  ///< 1/s^2, how fast it learns the gyroscope's offset
  };

  /// One step of the filter. Context: bucket.
  /// @param gains         both >= 0
  /// @param rate          rad/s about x, y, z
  /// @param acceleration  m/s^2 along x, y, z; at rest and level z is +9.81
  /// @param dt            s since the last step, 0..0.1; a longer one is cut
  void step(const Gains& gains, const float (&rate)[3], const float (&acceleration)[3], float dt);

  /// Level, nothing learned: the next acceleration sets roll and pitch.
  void reset() { *this = AttitudeFilter{}; }

  /// Gravity has been seen once: before, roll and pitch are not the part's.
  [[nodiscard]] bool aligned() const { return aligned_; }
  [[nodiscard]] float roll() const;                                   ///< rad, [-pi, pi]
  [[nodiscard]] float pitch() const;                                  ///< rad, [-pi/2, pi/2]
  [[nodiscard]] float yaw() const;                                    ///< rad, [-pi, pi]
  [[nodiscard]] const float (&offset() const)[3] { return offset_; }  ///< rad/s, to be added to the rates

 private:
  void align(const float (&acceleration)[3]);
  void correct(const Gains& gains, const float (&acceleration)[3], float dt, float (&rate)[3]);
  void integrate(const float (&rate)[3], float dt);

  bool aligned_ = false;
  float q_[4] = {1, 0, 0, 0};  ///< w x y z, body to world
  float offset_[3] = {};
};

}  // namespace finemote
