// A small vehicle written by hand as the generator would: an H30 at 5 ms, a pressure sensor behind a mux, a speed
// controller on a PCA9685 and one on a PWM header at 10 ms, and an echo on the host port.
#include <finemote/constinit.hpp>
#include <finemote/devices/h30_imu.hpp>
#include <finemote/devices/ms5837.hpp>
#include <finemote/i2c.hpp>
#include <finemote/latch.hpp>
#include <finemote/pca9685.hpp>
#include <finemote/pwm.hpp>
#include <finemote/schedule.hpp>
#include <finemote/sections.hpp>
#include <finemote/stage.hpp>
#include <finemote/uart.hpp>

extern "C" void finemote_line_48();
extern "C" void finemote_line_49();

namespace mini {

using finemote::Stage;

namespace slots {
extern finemote::I2cSlot pressure, pwm;
}
namespace {
finemote::I2cSlot* const i2c_slots[] = {&slots::pressure, &slots::pwm};
}
FINEMOTE_DMA static std::uint8_t imu_ring[256], host_ring[256];
FINEMOTE_CONSTINIT finemote::Uart imu_uart{finemote::ports::usart1, 460800, imu_ring};
FINEMOTE_CONSTINIT finemote::Uart host_uart{finemote::ports::usart6, 115200, host_ring, finemote::UartFormat::k8E1};
FINEMOTE_CONSTINIT finemote::I2cBus i2c{finemote::ports::i2c2, 400000, i2c_slots};
namespace slots {
FINEMOTE_CONSTINIT finemote::I2cSlot pressure{i2c, 0x76, finemote::MuxRoute{0x70, 0x01}, 1};
FINEMOTE_CONSTINIT finemote::I2cSlot pwm{i2c, 0x40, finemote::MuxRoute{0x70, 0x10}, 2};
}  // namespace slots
FINEMOTE_CONSTINIT finemote::Pca9685 pwm{slots::pwm};
FINEMOTE_CONSTINIT finemote::PwmBus header{finemote::ports::pwm1};

FINEMOTE_CONSTINIT finemote::H30Imu imu{nullptr, imu_uart};
FINEMOTE_CONSTINIT finemote::Ms5837 pressure{{finemote::Ms5837::Variant::k30BA, 256}, slots::pressure};
finemote::LatchToSlow<finemote::ImuState> imu_latch;

std::uint32_t bytes_echoed = 0;
std::int32_t roll_micro = 0, pascal = 0;
bool imu_valid = false, pressure_valid = false;

void echo() {
  std::uint8_t bytes[32];
  const std::size_t size = host_uart.read(bytes, sizeof bytes);
  if (size != 0 && host_uart.write(bytes, size)) bytes_echoed += static_cast<std::uint32_t>(size);
}

void run_5ms() {
  i2c.supervise();
  {
    Stage<0> stage;
    imu.update();
  }
  imu_latch.publish(imu.state);
  {
    Stage<1> stage;
    echo();
  }
}

void run_10ms() {
  {
    Stage<2> stage;
    pressure.update();
  }
  const finemote::ImuState& seen = imu_latch.snapshot();
  {
    Stage<4> stage;
    imu_valid = seen.valid;
    roll_micro = static_cast<std::int32_t>(seen.roll * 1e6F);
    pressure_valid = pressure.state.valid;
    pascal = static_cast<std::int32_t>(pressure.state.pressure);
  }
  {
    Stage<5> stage;
    const std::uint32_t pulse = seen.valid ? 1'600'000U : 1'500'000U;
    pwm.set(3, pulse);
    header.set(0, pulse + 100'000U);
  }
  pwm.flush();
  header.flush();
}

void start_buses() {
  imu_uart.start();
  host_uart.start();
  i2c.start();
  header.start();
}
void safe_outputs() {
  pwm.set(3, 1'500'000);
  pwm.flush();
}

namespace {
constexpr finemote::Bucket buckets[] = {
    {finemote_line_48, 5'000'000, 48, 4, 3},
    {finemote_line_49, 10'000'000, 49, 5, 3},
};
}  // namespace

}  // namespace mini

// What the test looks at, under names that survive.
extern "C" {
std::uint32_t observed[8];
void finemote_line_48() {
  mini::run_5ms();
  finemote::complete(0);
}
void finemote_line_49() {
  mini::run_10ms();
  observed[0] = mini::imu_valid ? 1 : 0;
  observed[1] = static_cast<std::uint32_t>(mini::roll_micro);
  observed[2] = mini::pressure_valid ? 1 : 0;
  observed[3] = static_cast<std::uint32_t>(mini::pascal);
  observed[4] = mini::imu.frames();
  observed[5] = mini::imu.bad_frames();
  observed[6] = mini::i2c.counters().recoveries;
  observed[7] = mini::i2c.counters().errors;
  finemote::complete(1);
}
extern const finemote::Schedule finemote_schedule{
    "mini", 1'000'000, mini::buckets, finemote::Overrun::skip, mini::start_buses, mini::safe_outputs, nullptr};
}
