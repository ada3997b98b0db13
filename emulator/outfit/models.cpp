#include "emulator/outfit/models.hpp"

namespace finemote::scenario {

const std::vector<Model>& models() {
  static const std::vector<Model> kModels{
      emulator::h30_imu(),       emulator::dbus_receiver(),  emulator::sbus_receiver(), emulator::host_terminal(),
      emulator::host_computer(), emulator::tca9548a(),       emulator::pca9685(),       emulator::ms5837(),
      emulator::ist8310(),       emulator::register_bank(),  emulator::bmi088(),        emulator::dji_motor(),
      emulator::can_listener(),  emulator::pwm_output(),     emulator::thruster(),      emulator::load(),
      emulator::button(),        emulator::battery(),        emulator::serial_jumper(), emulator::spi_jumper(),
      emulator::standing_body(), emulator::submerged_body(), emulator::mecanum_base(),  emulator::weights(),
  };
  return kModels;
}

}  // namespace finemote::scenario
