#include "tests/evidence/explanations.hpp"

#include <algorithm>
#include <cmath>

namespace finemote::evidence {
namespace {

bool near(double a, double b) { return std::abs(a - b) <= 1e-4 * std::max(std::abs(a), std::abs(b)); }

/// Every value of the source is `ratio` times ours.
bool scaled_by(const Difference& difference, double ratio) {
  if (difference.expected.empty() || difference.expected.size() != difference.found.size()) return false;
  return std::equal(difference.expected.begin(), difference.expected.end(), difference.found.begin(),
                    [&](double expected, double found) { return near(expected, ratio * found); });
}

bool is_one_of(const std::string& field, std::initializer_list<const char*> names) {
  return std::find(names.begin(), names.end(), field) != names.end();
}

// -----------------------------------------------------------------------------------------------------------------
// bmi088

/// Settings that are a matter of taste: rate and filter, range, interrupt pins.
bool is_choice(const Setting& setting, bool gyroscope) {
  if (gyroscope) return setting.address >= 0x0F && setting.address <= 0x18 && setting.address != 0x14;
  return setting.address >= 0x40 && setting.address <= 0x58;
}

/// Reset and power come with the same values and no shorter waits; only choices and the order differ.
bool differs_in_choices(const Difference& difference) {
  if (difference.field != "writes" || !difference.findings->writes) return false;
  const std::vector<Setting> wanted = settings_of(difference.vector->expected.at("writes"));
  const std::vector<Setting>& ours = *difference.findings->writes;
  const bool gyroscope = std::any_of(wanted.begin(), wanted.end(),
                                     [](const Setting& it) { return it.address == 0x14 || it.address == 0x0F; });
  return std::all_of(wanted.begin(), wanted.end(), [&](const Setting& it) {
    if (is_choice(it, gyroscope)) return true;
    return std::any_of(ours.begin(), ours.end(), [&](const Setting& own) {
      return own.address == it.address && own.value == it.value && own.wait >= it.wait;
    });
  });
}

// ----------------------------------------------------------------------------------------------------------------
// ist8310

bool has_other_y(const Difference& difference) {
  const auto& expected = difference.expected;
  const auto& found = difference.found;
  return expected.size() == 3 && found.size() == 3 && near(expected[0], found[0]) && near(expected[1], -found[1]) &&
         near(expected[2], found[2]);
}

// -------------------------------------------------------------------------------------------------------------------
// dr16

bool has_unset_switch(const Difference& difference) {
  if (difference.field != "accepted" || difference.vector->bursts.empty()) return false;
  const Bytes& last = difference.vector->bursts.back().bytes;
  constexpr std::size_t kFrame = 18, kSwitches = 5;
  if (last.size() != kFrame) return false;
  return last[kSwitches] >> 6 == 0 || (last[kSwitches] >> 4 & 3) == 0;
}

bool is_empty_wheel(const Difference& difference) {
  return (difference.field == "wheel" && difference.expected == std::vector<double>{-1024}) ||
         (difference.field == "wheel_unit" && difference.expected.size() == 1 &&
          near(difference.expected[0], -1024.0 / 660));
}

// --------------------------------------------------------------------------------------------------------------------
// h30

bool lacks_a_record(const Difference& difference) {
  if (difference.field != "accepted") return false;
  const Json& expected = difference.vector->expected;
  const auto has = [&](const char* begin) {
    return std::any_of(expected.items().begin(), expected.items().end(),
                       [&](const auto& item) { return item.key().rfind(begin, 0) == 0; });
  };
  return !has("accel") || !has("rate") || !has("euler");
}

}  // namespace

const std::vector<Explanation>& explanations() {
  static const std::vector<Explanation> kAll = {
      {"bmi088_settings", "bmi088",
       "The set-up writes other rates, filters, ranges and interrupt pins, and switches the accelerometer on "
       "(0x7D) before it leaves suspend (0x7C). Resets, power registers and all waits are the same or longer.",
       "RoboMaster/Development-Board-C-Examples: 13.spi_bmi088/component/devices/BMI088driver.c (59d12b1) has our "
       "order; "
       "BMI088 data sheet 5.3.10, 5.3.11, 5.5.7 list the values as choices",
       differs_in_choices},
      {"ist8310_left_handed", "ist8310",
       "The source takes the part's three axes as they are, which are left-handed (forward, right, up); ours turns y, "
       "so "
       "that the field is in right-handed axes.",
       "PX4/PX4-Autopilot: src/drivers/magnetometer/isentek/ist8310/IST8310.cpp (b544b5c) and ArduPilot/ardupilot: "
       "libraries/AP_Compass/AP_Compass_IST8310.cpp (05f9f3c) turn an axis too",
       has_other_y},
      {"ist8310_set_up", "ist8310",
       "The source pulls the reset pin and reads every setting back. Ours does neither: a part that lost its settings "
       "gives zeros, and is set up again.",
       "betaflight/betaflight: src/main/drivers/compass/compass_ist8310.c (e727d5d) and ArduPilot/ardupilot: "
       "libraries/AP_Compass/AP_Compass_IST8310.cpp (05f9f3c) do neither",
       [](const Difference& difference) {
         return is_one_of(difference.field, {"reset_low_ns", "reset_high_ns", "read_back"});
       }},
      {"dr16_unset_switch", "dr16",
       "A switch of the source's frame is in position 0, which its test leaves unset; ours refuses the frame, as there "
       "is "
       "no checksum and every field has to be in range.",
       "RoboMaster DT7 and DR16 user manual, receiver protocol: switches are 1, 2 or 3", has_unset_switch},
      {"dr16_no_wheel", "dr16",
       "Receivers without a wheel send 0 where it would be; the source makes -1024 of it, ours a wheel at rest.",
       "RoboMaster DT7 and DR16 user manual, receiver protocol: these bytes are reserved", is_empty_wheel},
      {"gm6020_voltage_mode", "gm6020",
       "The source commands a voltage; ours commands a current only, in frames of other identifiers.",
       "RoboMaster GM6020 user guide: the motor obeys the frames of the mode that is set in it",
       [](const Difference& difference) {
         const auto frame = difference.vector->can_id;
         return (frame == 0x1FFU || frame == 0x2FFU) && is_one_of(difference.field, {"mode", "command_v"});
       }},
      {"gm6020_full_current", "gm6020", "The source takes full scale for the rated 1.62 A, ours for 3 A.",
       "njupt-robomasters/rmpp: rmpp/lib/motor/GM6020.hpp (0dcd30a): 3 A at 16384",
       [](const Difference& difference) {
         return is_one_of(difference.field, {"command_a", "current_a"}) && scaled_by(difference, 1.62 / 3);
       }},
      {"dji_8191_steps", "m3508 c610 gm6020",
       "The source divides the rotor's angle by 8191, ours by 8192: after 8191 comes 0.",
       "HNUYueLuRM/basic_framework: modules/motor/DJImotor/dji_motor.c (c1394f3) divides by 8192",
       [](const Difference& difference) {
         return is_one_of(difference.field, {"angle_rad", "angle_deg"}) && scaled_by(difference, 8192.0 / 8191);
       }},
      {"h30_incomplete", "h30",
       "The source takes any record for itself; ours takes a frame only with acceleration, rates and angles, of which "
       "an "
       "attitude is made.",
       "FINS-Fines/FineMote: Devices/Sensors/H30_imu.h (84e6e10) takes only frames with all of its records",
       lacks_a_record},
      {"h30_left_out", "h30",
       "The source also has the frame's number, the magnetic field and the attitude as a quaternion; ours steps over "
       "their records by their lengths and takes the attitude from its angles.",
       "FINS-Fines/FineMote: Devices/Sensors/H30_imu.h (84e6e10) takes the angles alone",
       [](const Difference& difference) {
         return difference.found.empty() &&
                is_one_of(difference.field, {"tid", "magnetic_normalised", "magnetic_raw_milligauss", "quaternion"});
       }},
  };
  return kAll;
}

}  // namespace finemote::evidence
