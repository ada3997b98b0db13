// Who answers on the buses of the board: the identities of its parts, by polling, without the drivers.
#include "groups.hpp"
#include "i2c_line.hpp"
#include "record.hpp"
#include "spi_line.hpp"
#include "stopwatch.hpp"

namespace finemote::bench_kit {
namespace {

constexpr std::uint8_t kRead = 0x80, kIdentity = 0x00;
constexpr unsigned kAccelerometer = 0, kGyroscope = 1, kReads = 1'000;

/// Register 0 of one of the two chips of the BMI088: data sheet 6.1. The accelerometer sends a byte without meaning
/// before it, the gyroscope none. @return false: the bus does not work
bool read_identity(unsigned select, std::uint8_t& identity) {
  std::uint8_t bytes[3] = {kIdentity | kRead, 0, 0};
  const unsigned size = select == kAccelerometer ? 3 : 2;
  const bool ok = exchange(kSensorSpi, select, bytes, size);
  identity = bytes[size - 1];
  return ok;
}

/// Reads an identity again and again. @return how often it was another one than the first
std::uint32_t misreads(unsigned select, std::uint8_t first) {
  std::uint32_t count = 0;
  for (unsigned i = 0; i < kReads; ++i) {
    std::uint8_t identity = 0;
    count += !read_identity(select, identity) || identity != first ? 1 : 0;
  }
  return count;
}

void ask(unsigned select, Test test, Test again) {
  std::uint8_t identity = 0;
  if (!read_identity(select, identity)) return miss(test, Missing::answer);
  put(test, identity);
  put(again, misreads(select, identity));
}

}  // namespace

void ask_inertial_sensor() {
  constexpr std::uint32_t kWakeUpUs = 50'000;  // of the gyroscope 30 ms: data sheet 1.2, table 4
  for (const Stopwatch watch; !watch.has_passed(cycles_in(kWakeUpUs));) {}
  start_spi(kSensorSpi);
  std::uint8_t ignored = 0;
  static_cast<void>(read_identity(kAccelerometer, ignored));  // its first select turns it from I2C to SPI
  ask(kAccelerometer, Test::bmi088_accelerometer_id, Test::bmi088_accelerometer_misreads);
  ask(kGyroscope, Test::bmi088_gyroscope_id, Test::bmi088_gyroscope_misreads);
}

void ask_magnetometer() {
  constexpr std::uint8_t kAddress = 0x0E, kWhoAmI = 0x00;
  start_i2c();
  const Reading found = read_register(kAddress, kWhoAmI, Interrupts::masked);
  if (!found.came) return miss(Test::ist8310_identity, Missing::answer);
  put(Test::ist8310_identity, found.byte);
}

}  // namespace finemote::bench_kit
