// The `mini` image on an emulated board with its parts attached: what most of the emulator's tests start from.
#pragma once

#include <string>

#include "emulator/board.hpp"
#include "emulator/parts/h30.hpp"
#include "emulator/parts/ms5837.hpp"
#include "emulator/parts/pca9685.hpp"
#include "emulator/parts/serial_terminal.hpp"
#include "emulator/parts/tca9548a.hpp"
#include "tests/emulator/tested_chip.hpp"
#include "tests/emulator/type_c.hpp"

namespace finemote::emulator {

inline Image test_image(const std::string& name) {
  return load_image(std::string(FINEMOTE_IMAGES) + "/" + name + ".elf");
}

struct MiniBoard {
  explicit MiniBoard(const BoardOptions& options = finemote::test::tested_chip(), const std::string& image = "mini")
      : board{finemote::test::type_c(), options} {
    I2cLine& line = board.chip().i2c("i2c2")->line;
    line.attach(mux);
    mux.channel(0).attach(sensor);
    mux.channel(4).attach(pwm);
    board.load(test_image(image));
  }

  Board board;
  Tca9548a mux{0x70};
  Pca9685 pwm{0x40};
  Ms5837 sensor{Ms5837::Variant::k30BA, [this] { return board.world().now(); }, [this](Time) { return pascal; }};
  H30 imu{board.world(),      *board.chip().usart("usart1"),    SerialFormat{460800, false, 1}, from_ns(5'000'000),
          from_ns(1'000'000), [this](Time) { return attitude; }};
  SerialTerminal host{board.world(), *board.chip().usart("usart6"), SerialFormat{115200, true, 1}};
  double pascal = 250'000;
  Attitude attitude{{0, 0, 9.81}, {}, 1.5, -12.25, 90.0};

  std::uint32_t observed(unsigned index) { return board.word("observed", 4 * index); }
};

}  // namespace finemote::emulator
