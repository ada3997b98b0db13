#include "finemote/control/attitude.hpp"

#include <cmath>

#include "finemote/control/arctangent.hpp"
#include "finemote/control/numbers.hpp"
#include "finemote/control/sine.hpp"

namespace finemote {

namespace {

constexpr float kGravity = 9.80665F;
constexpr float kLongestStep = 0.1F;
constexpr float kMaxOffset = 0.2F;  ///< rad/s; a gyroscope's offset is far below

float length(const float (&v)[3]) { return std::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]); }

}  // namespace

void AttitudeFilter::step(const Gains& gains, const float (&rate)[3], const float (&acceleration)[3], float dt) {
  const float size = length(acceleration);
  const bool gravity_alone = size > 0.5F * kGravity && size < 1.5F * kGravity;
  float corrected[3] = {rate[0], rate[1], rate[2]};
  if (!aligned_) {
    if (gravity_alone) align(acceleration);
    return;
  }
  const float bounded = clamp(dt, 0, kLongestStep);
  if (gravity_alone) correct(gains, acceleration, bounded, corrected);
  for (int i = 0; i < 3; ++i) corrected[i] += offset_[i];
  integrate(corrected, bounded);
}

void AttitudeFilter::align(const float (&a)[3]) {
  const float half_roll = 0.5F * arctangent(a[1], a[2]);
  const float half_pitch = 0.5F * arctangent(-a[0], std::sqrt(a[1] * a[1] + a[2] * a[2]));
  const float cr = cosine(half_roll), sr = sine(half_roll), cp = cosine(half_pitch), sp = sine(half_pitch);
  q_[0] = cr * cp;
  q_[1] = sr * cp;
  q_[2] = cr * sp;
  q_[3] = -sr * sp;
  aligned_ = true;
}

/// The cross product of measured and expected "up" is the axis and size of the error.
void AttitudeFilter::correct(const Gains& gains, const float (&acceleration)[3], float dt, float (&rate)[3]) {
  const float size = length(acceleration);
  const float up[3] = {2 * (q_[1] * q_[3] - q_[0] * q_[2]), 2 * (q_[0] * q_[1] + q_[2] * q_[3]),
                       1 - 2 * (q_[1] * q_[1] + q_[2] * q_[2])};
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    const float error = (acceleration[j] * up[k] - acceleration[k] * up[j]) / size;
    offset_[i] = clamp(offset_[i] + gains.ki * error * dt, -kMaxOffset, kMaxOffset);
    rate[i] += gains.kp * error;
  }
}

void AttitudeFilter::integrate(const float (&rate)[3], float dt) {
  const float x = 0.5F * rate[0] * dt, y = 0.5F * rate[1] * dt, z = 0.5F * rate[2] * dt;
  const float w0 = q_[0], x0 = q_[1], y0 = q_[2], z0 = q_[3];
  q_[0] = w0 - x0 * x - y0 * y - z0 * z;
  q_[1] = x0 + w0 * x + y0 * z - z0 * y;
  q_[2] = y0 + w0 * y - x0 * z + z0 * x;
  q_[3] = z0 + w0 * z + x0 * y - y0 * x;
  const float size = std::sqrt(q_[0] * q_[0] + q_[1] * q_[1] + q_[2] * q_[2] + q_[3] * q_[3]);
  for (float& part : q_) part /= size;
}

float AttitudeFilter::roll() const {
  return arctangent(2 * (q_[0] * q_[1] + q_[2] * q_[3]), 1 - 2 * (q_[1] * q_[1] + q_[2] * q_[2]));
}
float AttitudeFilter::pitch() const { return arcsine(2 * (q_[0] * q_[2] - q_[3] * q_[1])); }
float AttitudeFilter::yaw() const {
  return arctangent(2 * (q_[0] * q_[3] + q_[1] * q_[2]), 1 - 2 * (q_[2] * q_[2] + q_[3] * q_[3]));
}

}  // namespace finemote
