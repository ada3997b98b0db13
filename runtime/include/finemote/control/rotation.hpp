// Vectors and rotations in three dimensions.
#pragma once

namespace finemote {

struct Vector {
  float x = 0, y = 0, z = 0;
};

constexpr Vector operator+(const Vector& a, const Vector& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
constexpr Vector operator-(const Vector& a, const Vector& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
constexpr Vector operator*(float k, const Vector& v) { return {k * v.x, k * v.y, k * v.z}; }
constexpr float dot(const Vector& a, const Vector& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }

/// An orthogonal matrix by its rows: what it multiplies is turned, or taken from one frame to another.
struct Rotation {
  Vector row[3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};

  /// About `axis`, of unit length, by a finite `angle` [rad] (Rodrigues).
  static Rotation about(const Vector& axis, float angle);
};

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
