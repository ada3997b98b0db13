// Vectors and rotations in three dimensions.
#pragma once

namespace finemote {

/// Three coordinates.
struct Vector {
  float x = 0;  ///< forward, in the frames of a robot
  float y = 0;  ///< left
  float z = 0;  ///< up
};

/// The sum.
constexpr Vector operator+(const Vector& a, const Vector& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
/// The difference.
constexpr Vector operator-(const Vector& a, const Vector& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
/// `k` times as long.
constexpr Vector operator*(float k, const Vector& v) { return {k * v.x, k * v.y, k * v.z}; }
/// The scalar product.
constexpr float dot(const Vector& a, const Vector& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }

/// An orthogonal matrix by its rows: what it multiplies is turned, or taken from one frame to another.
struct Rotation {
  /// What the turned x, y and z are the scalar products with.
  Vector row[3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};

  /// About `axis`, of unit length, by a finite `angle` [rad] (Rodrigues).
  static Rotation about(const Vector& axis, float angle);
  /// First `roll` about x, then `pitch` about y, then `yaw` about z, the axes staying where they are [rad, -pi..pi].
  static Rotation of_angles(float roll, float pitch, float yaw);

  /// The angles of of_angles(): roll and yaw -pi..pi, pitch -pi/2..pi/2. Where x points straight up or down only the
  /// difference of roll and yaw means anything, or their sum.
  [[nodiscard]] float roll() const;
  [[nodiscard]] float pitch() const;  ///< as roll()
  [[nodiscard]] float yaw() const;    ///< as roll()
};

/// What takes back: the transpose.
constexpr Rotation inverse(const Rotation& r) {
  return {{{r.row[0].x, r.row[1].x, r.row[2].x},
           {r.row[0].y, r.row[1].y, r.row[2].y},
           {r.row[0].z, r.row[1].z, r.row[2].z}}};
}

/// The vector, turned.
constexpr Vector operator*(const Rotation& r, const Vector& v) {
  return {dot(r.row[0], v), dot(r.row[1], v), dot(r.row[2], v)};
}
/// The same for a vector given as an array; a null pointer turns nothing.
constexpr void turn(const Rotation* r, float (&v)[3]) {
  if (r == nullptr) return;
  const Vector turned = *r * Vector{v[0], v[1], v[2]};
  v[0] = turned.x;
  v[1] = turned.y;
  v[2] = turned.z;
}
/// First `b`, then `a`.
Rotation operator*(const Rotation& a, const Rotation& b);

}  // namespace finemote
