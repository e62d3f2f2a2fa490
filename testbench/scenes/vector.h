// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "testbench/scenes/dual.h"

namespace feline {

// A point or a direction of a scene; right-handed, y upwards, the camera looks along +z.
struct Vector {
  Dual x;
  Dual y;
  Dual z;
};

constexpr Vector operator+(const Vector& a, const Vector& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }

constexpr Vector operator-(const Vector& a, const Vector& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }

constexpr Vector operator*(const Dual& scale, const Vector& a) { return {scale * a.x, scale * a.y, scale * a.z}; }

constexpr Dual dot(const Vector& a, const Vector& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }

inline Vector normalize(const Vector& a) { return (1.0 / sqrt(dot(a, a))) * a; }

// direction mirrored at a surface with this unit normal.
constexpr Vector reflect(const Vector& direction, const Vector& normal) {
  return direction - 2.0 * dot(direction, normal) * normal;
}

}  // namespace feline
