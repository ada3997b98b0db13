#include "finemote/control/rotation.hpp"

#include "finemote/control/arctangent.hpp"
#include "finemote/control/sine.hpp"

namespace finemote {

Rotation Rotation::about(const Vector& axis, float angle) {
  const float s = sine(angle), c = cosine(angle);
  const Vector k = (1 - c) * axis, w = s * axis;
  return {{{c + k.x * axis.x, k.x * axis.y - w.z, k.x * axis.z + w.y},
           {k.y * axis.x + w.z, c + k.y * axis.y, k.y * axis.z - w.x},
           {k.z * axis.x - w.y, k.z * axis.y + w.x, c + k.z * axis.z}}};
}

Rotation Rotation::of_angles(float roll, float pitch, float yaw) {
  const float cr = cosine(roll), sr = sine(roll), cp = cosine(pitch), sp = sine(pitch);
  const float cy = cosine(yaw), sy = sine(yaw);
  return {{{cy * cp, cy * sp * sr - sy * cr, cy * sp * cr + sy * sr},
           {sy * cp, sy * sp * sr + cy * cr, sy * sp * cr - cy * sr},
           {-sp, cp * sr, cp * cr}}};
}

float Rotation::roll() const { return arctangent(row[2].y, row[2].z); }
float Rotation::pitch() const { return arcsine(-row[2].x); }
float Rotation::yaw() const { return arctangent(row[1].x, row[0].x); }

Rotation operator*(const Rotation& a, const Rotation& b) {
  Rotation product;
  for (unsigned i = 0; i < 3; ++i) {
    const Vector& row = a.row[i];
    product.row[i] = row.x * b.row[0] + row.y * b.row[1] + row.z * b.row[2];
  }
  return product;
}

}  // namespace finemote
