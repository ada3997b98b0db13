// A line that sends counting bytes without a pause, looked at without a pause: what the ring says it has, it has.
#include <finemote/constinit.hpp>
#include <finemote/ports.hpp>
#include <finemote/schedule.hpp>
#include <finemote/sections.hpp>

extern "C" {
void finemote_line_48();
/// Read by the test: bytes taken, those that were not the ones that follow, and counts that stepped back.
std::uint32_t taken, wrong, back;
}

namespace ring_image {

constexpr std::uint32_t kRing = 256, kCounted = 251;  // what lay in the ring before is another number
constexpr finemote::Duration kLook = 850 * finemote::kMicrosecond;

FINEMOTE_DMA std::uint8_t ring[kRing];

finemote::UartPort& port() { return finemote::ports::usart1; }

/// The newest byte follows the one before it. Looked at as soon as it is counted.
void look(std::uint32_t& last) {
  const std::uint32_t count = port().received();
  const std::uint8_t newest = ring[(count - 1) % kRing], before = ring[(count - 2) % kRing];
  if (static_cast<std::int32_t>(count - last) < 0) ++back;
  if (count != last && newest != (before + 1U) % kCounted) ++wrong;
  taken += count - last;
  last = count;
}

/// Some tens of cycles, other ones each time: looks that keep step with the bytes would see some instants never.
void pause() {
  static std::uint32_t random = 1;
  random = random * 1'664'525 + 1'013'904'223;
  for (std::uint32_t turns = random >> 28U; turns != 0; --turns) asm volatile("");
}

void run_1ms() {
  static std::uint32_t last = 0;
  const finemote::Time end = finemote::now() + kLook;
  while (finemote::now() < end) {
    look(last);
    pause();
  }
}

void start_buses() { port().start(921'600, finemote::UartFormat::k8N1, ring); }
void safe_outputs() {}

namespace {
constexpr finemote::Bucket buckets[] = {{finemote_line_48, 1'000'000, 48, 4, 3}};
}

}  // namespace ring_image

extern "C" void finemote_line_48() {
  ring_image::run_1ms();
  finemote::complete(0);
}
extern "C" const finemote::Schedule finemote_schedule{
    "ring", 1'000'000, ring_image::buckets, finemote::Overrun::skip, ring_image::start_buses, ring_image::safe_outputs,
    nullptr};
