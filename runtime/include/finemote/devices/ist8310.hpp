// Turns the registers of an IST8310 compass into a magnetic field.
#pragma once

#include <cstdint>

#include "finemote/contract.hpp"
#include "finemote/geometry.hpp"
#include "finemote/i2c.hpp"
#include "finemote/interfaces/magnetometer.hpp"

namespace finemote {

/// iSentek IST8310, 0.3 uT per step. Every update() takes the read of the one before and starts the next; the origin is
/// when that read began, less the longest age of what it brings. Identity and settings are written first, with
/// `valid = false`. Three failed transfers in a row, or three readings beyond the part's range or of nothing but zeros,
/// lead to a new bring-up. The first reading after zeros is left out: half of it may be zeros still.
/// The part's own axes are x and z as its data sheet draws them, and y to the left, against the drawing, so that they
/// are right-handed. The field is in the axes of the robot, wherever the URDF says the part's own link points.
class Ist8310 {
 public:
  /// @param mount  takes the part's axes to those wanted; null: they are the same
  constexpr Ist8310(const Rotation* mount, I2cSlot& slot) : mount_(mount), slot_(&slot) {}

  void update();
  void handle() {}

  MagnetometerState state;

 private:
  enum class Step : std::uint8_t { kIdentity, kSettings, kRun };

  void take_result();
  void take_field();
  void begin_step();
  void bad_value();

  const Rotation* mount_;
  I2cSlot* const slot_;
  Step step_ = Step::kIdentity;
  bool started_ = false;
  bool measured_ = false;  ///< a whole read has brought a measurement since the part was set up or brought zeros
  Time asked_ = 0;         ///< when the read under way was begun
  std::uint8_t entry_ = 0, bad_values_ = 0;
  std::uint8_t write_[2]{};
  std::uint8_t read_[6]{};
};

}  // namespace finemote
