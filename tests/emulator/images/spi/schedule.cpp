// Three chips on two SPI buses, written by hand: every millisecond a read of four bytes from each.
#include <finemote/constinit.hpp>
#include <finemote/schedule.hpp>
#include <finemote/spi.hpp>

extern "C" {
void finemote_line_48();
/// Read by the test: exchanges done with each chip, and the last bytes each sent.
std::uint32_t done[3];
std::uint8_t bytes[3][4];
}

namespace spi_image {

namespace slots {
extern finemote::SpiSlot accelerometer, gyroscope, other;
}
namespace {
finemote::SpiSlot* const board_slots[] = {&slots::accelerometer, &slots::gyroscope};
finemote::SpiSlot* const user_slots[] = {&slots::other};
constexpr std::uint8_t kRequest[4] = {0x92, 0, 0, 0};
}  // namespace
FINEMOTE_CONSTINIT finemote::SpiBus board_bus{finemote::ports::spi1, 2500000, board_slots};
FINEMOTE_CONSTINIT finemote::SpiBus user_bus{finemote::ports::spi2, 200000, user_slots};
namespace slots {
FINEMOTE_CONSTINIT finemote::SpiSlot accelerometer{board_bus, 0, 1};
FINEMOTE_CONSTINIT finemote::SpiSlot gyroscope{board_bus, 1, 2};
FINEMOTE_CONSTINIT finemote::SpiSlot other{user_bus, 0, 1, 0};
}  // namespace slots

void exchange(finemote::SpiSlot& slot, unsigned index, const std::uint8_t* write) {
  if (slot.done()) ++done[index];
  if (!slot.busy()) slot.start(write, bytes[index], 4);
}

void run_1ms() {
  board_bus.supervise();
  user_bus.supervise();
  exchange(slots::accelerometer, 0, kRequest);
  exchange(slots::gyroscope, 1, kRequest);
  exchange(slots::other, 2, nullptr);
}

void start_buses() {
  board_bus.start();
  user_bus.start();
}
void safe_outputs() {}

namespace {
constexpr finemote::Bucket buckets[] = {{finemote_line_48, 1'000'000, 48, 4, 3}};
}

}  // namespace spi_image

extern "C" void finemote_line_48() {
  spi_image::run_1ms();
  finemote::complete(0);
}
extern "C" const finemote::Schedule finemote_schedule{
    "spi",  1'000'000, spi_image::buckets, finemote::Overrun::skip, spi_image::start_buses, spi_image::safe_outputs,
    nullptr};
