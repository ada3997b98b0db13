#include "can_line.hpp"

#include "stopwatch.hpp"

namespace finemote::bench_kit {
namespace {

namespace can = stm32f4::can;
namespace rcc = stm32f4::rcc;
using stm32f4::bit;

constexpr std::uint32_t kStartLimit = cycles_in(50'000), kFrameLimit = cycles_in(1'000);
/// BTR, RM0090 32.9.2.
constexpr std::uint32_t kInward = bit(30) | bit(31);
/// A bit is 14 quanta: one to synchronise, 10, 3.
constexpr std::uint32_t kRateHz = 1'000'000, kFirst = 10, kSecond = 3;
constexpr std::uint32_t kTiming =
    (kSecond - 1) << 20 | (kFirst - 1) << 16 | (stm32f4::kApb1Hz / (1 + kFirst + kSecond) / kRateHz - 1);
/// Alternating bits, none of which is stuffed.
constexpr std::uint32_t kIdentifier = 0x2AA, kSize = 8, kData = 0x55555555, kMailboxes = 3;

const stm32f4::CanPeripheral& kCan = stm32f4::kCan1;

void restart() {
  rcc::enable(rcc::apb1enr, kCan.clock_bits);
  rcc::restart(rcc::apb1enr, kCan.clock_bits);
}

/// Out of sleep, too. @return whether it came
bool initialise(const stm32f4::CanPeripheral& it) {
  it.can.mcr().modify(can::kSleepRequest, can::kInitRequest);
  return wait_until(it.can.msr(), can::kInitAcknowledge, can::kInitAcknowledge, kStartLimit);
}

/// The first bank lets everything into FIFO 0: RM0090 32.9.4.
void accept_all() {
  can::fmr.set(can::kFilterInit);
  can::fs1r.set(1);
  can::fm1r.clear(1);
  can::filter(0, 0).write(0);
  can::filter(0, 1).write(0);
  can::ffa1r.clear(1);
  can::fa1r.set(1);
  can::fmr.clear(can::kFilterInit);
}

void put_into(const stm32f4::CanPeripheral& it, std::uint32_t mailbox, std::uint32_t identifier, std::uint32_t data) {
  it.can.mailbox(mailbox, 1).write(kSize);
  it.can.mailbox(mailbox, 2).write(data);
  it.can.mailbox(mailbox, 3).write(data);
  it.can.mailbox(mailbox, 0).write(identifier << can::kIdentifierShift | can::kSend);
}

/// The frames leave in the order of their mailboxes, without a pause. @return of the distances of their ends the mean
bool time_frames(std::uint32_t& cycles) {
  for (std::uint32_t i = 0; i < kMailboxes; ++i) put_into(kCan, i, kIdentifier, kData);
  const Stopwatch watch;
  std::uint32_t ends[kMailboxes];
  for (std::uint32_t i = 0; i < kMailboxes; ++i) {
    const std::uint32_t sent = can::kCompleted << (8 * i);
    if (!wait_until(kCan.can.tsr(), sent, sent, kFrameLimit)) return false;
    ends[i] = watch.cycles();
  }
  cycles = (ends[kMailboxes - 1] - ends[0]) / (kMailboxes - 1);
  return true;
}

std::uint32_t count_wrong() {
  std::uint32_t right = 0;
  for (std::uint32_t i = 0; i < kMailboxes && kCan.can.rf0r().any(can::kPendingMask); ++i) {
    const bool is_it = kCan.can.received(0).read() == kIdentifier << can::kIdentifierShift &&
                       (kCan.can.received(1).read() & 0xF) == kSize && kCan.can.received(2).read() == kData &&
                       kCan.can.received(3).read() == kData;
    right += is_it ? 1 : 0;
    kCan.can.rf0r().write(can::kRelease);
    static_cast<void>(wait_until(kCan.can.rf0r(), can::kRelease, 0, kFrameLimit));
  }
  return kMailboxes - right;
}

}  // namespace

CanStart enter_initialisation() {
  restart();
  const Stopwatch watch;
  CanStart start;
  start.came = initialise(kCan);
  start.cycles = watch.cycles();
  restart();
  return start;
}

CanLoop send_to_itself() {
  CanLoop loop;
  restart();
  if (!initialise(kCan)) return loop;
  kCan.can.btr().write(kInward | kTiming);
  accept_all();
  kCan.can.mcr().clear(can::kInitRequest);
  loop.came = time_frames(loop.cycles);
  loop.wrong = count_wrong();
  restart();
  return loop;
}

bool turn_inward(const stm32f4::CanPeripheral& it) {
  const bool came = initialise(it);
  if (came) it.can.btr().set(kInward);
  it.can.mcr().clear(can::kInitRequest);
  return came;
}

void send_frame(const stm32f4::CanPeripheral& it, std::uint32_t identifier) {
  for (std::uint32_t i = 0; i < kMailboxes; ++i) {
    if (it.can.tsr().any(bit(can::kEmptyShift + i))) return put_into(it, i, identifier, 0);
  }
}

}  // namespace finemote::bench_kit
