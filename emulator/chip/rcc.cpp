#include "emulator/chip/rcc.hpp"

namespace finemote::emulator {
namespace {
constexpr std::uint32_t kSleepClocks = 0x50;  ///< AHB1LPENR, then the others: what runs in sleep, which is not modelled
constexpr std::uint32_t kLsiOn = 1, kLsiReady = 2;
constexpr std::uint32_t kAudioPllOn = 1U << 26, kAudioPllReady = 1U << 27;
constexpr std::uint32_t kHsiOn = 1, kHsiReady = 2, kHseOn = 1U << 16, kHseReady = 1U << 17, kPllOn = 1U << 24,
                        kPllReady = 1U << 25;
// Typical start-up times: DS8626 5.3.8 (crystal), 5.3.10 (PLL), 5.3.9 (LSI).
constexpr Time kCrystalStart = from_ns(2'000'000), kPllLock = from_ns(200'000), kLsiStart = from_ns(15'000);
}  // namespace

void Rcc::reset() {  // RM0090 7.3, reset values
  cr_ = 0x83;
  pllcfgr_ = 0x24003010;
  cfgr_ = 0;
  csr_ &= kResetFlags;
  ahb1_ = 0x00100000;
  ahb2_ = ahb3_ = apb1_ = apb2_ = ahb3_reset_ = spread_ = 0;
  audio_pll_ = 0x20003000;
  sleep_clocks_ = {0x7E6791FF, 0xF1, 1, 0, 0x36FEC9FF, 0x00075F33};
  ahb1_reset_ = ahb2_reset_ = apb1_reset_ = apb2_reset_ = 0;
  world_.system().change_clock(world_.now(), period_of(core_hz()));
}

std::uint32_t Rcc::pll_hz() const {
  const std::uint32_t m = pllcfgr_ & 0x3F, n = pllcfgr_ >> 6 & 0x1FF, p = ((pllcfgr_ >> 16 & 3) + 1) * 2;
  const std::uint32_t source = (pllcfgr_ >> 22 & 1) != 0 ? crystal_hz : 16'000'000;
  return m == 0 ? 0 : static_cast<std::uint32_t>(std::uint64_t{source} * n / m / p);
}

/// Limits of the PLL: RM0090 7.3.2, a little wider by DS8626 5.3.10.
void Rcc::check_pll() {
  const std::uint32_t m = pllcfgr_ & 0x3F, n = pllcfgr_ >> 6 & 0x1FF;
  const std::uint32_t source = (pllcfgr_ >> 22 & 1) != 0 ? crystal_hz : 16'000'000;
  const std::uint32_t in = m < 2 ? source : source / m;
  const std::uint64_t out = std::uint64_t{in} * n;
  if (m < 2 || in < 950'000 || in > 2'100'000) world_.report(Misuse::clock, "the PLL's input is not 1 to 2 MHz");
  if (out < 100'000'000 || out > 432'000'000) world_.report(Misuse::clock, "the PLL's VCO is not at 100 to 432 MHz");
}

std::uint32_t Rcc::core_hz() const {
  if (fixed_hz != 0) return fixed_hz;
  const std::uint32_t status = cfgr_ >> 2 & 3;
  const std::uint32_t source = status == 0 ? 16'000'000 : status == 1 ? crystal_hz : pll_hz();
  const std::uint32_t field = cfgr_ >> 4 & 0xF;
  constexpr std::uint32_t kDividers[] = {2, 4, 8, 16, 64, 128, 256, 512};
  return field < 8 ? source : source / kDividers[field - 8];
}

std::uint32_t Rcc::timer_hz(ClockBus bus) const {
  const std::uint32_t hz = bus == ClockBus::apb1 ? apb1_hz() : apb2_hz();
  return hz == core_hz() ? hz : 2 * hz;
}

bool Rcc::clocked(ClockBus bus, std::uint32_t bits) const {
  switch (bus) {
    case ClockBus::always:
      return true;
    case ClockBus::ahb1:
      return (ahb1_ & bits) != 0;
    case ClockBus::ahb2:
      return (ahb2_ & bits) != 0;
    case ClockBus::apb1:
      return (apb1_ & bits) != 0;
    case ClockBus::apb2:
      return (apb2_ & bits) != 0;
  }
  return false;
}

/// How long a start takes on this chip, of what is typical.
Time Rcc::as_slow(Time typical) {
  Silicon& silicon = world_.silicon();
  return silicon.is(Strictness::clock_ready) ? typical * silicon.draw(Strictness::clock_ready) / 100 : typical;
}

void Rcc::start(std::uint32_t ready_bit, Time delay) {
  world_.after(as_slow(delay), [this, ready_bit] {
    if ((cr_ & ready_bit >> 1) == 0) return;
    cr_ |= ready_bit;
    switch_core();  // it may have been waited for: RM0090 7.2.6
  });
}

void Rcc::write_cr(std::uint32_t value) {
  const std::uint32_t rising = value & ~cr_;
  cr_ = (cr_ & (kHsiReady | kHseReady | kPllReady | kAudioPllReady | 0xFF00)) |
        (value & (kHsiOn | 0xF8 | kHseOn | 0x000C0000 | kPllOn | kAudioPllOn));
  only(value, 0xFFFB | kHseOn | kHseReady | 0x000C0000 | kPllOn | kPllReady | kAudioPllOn | kAudioPllReady, "CR");
  if ((rising & kAudioPllOn) != 0) start(kAudioPllReady, kPllLock);
  if ((rising & kHseOn) != 0 && !dead_crystal) start(kHseReady, kCrystalStart);
  if ((rising & kPllOn) != 0) {
    const bool from_crystal = (pllcfgr_ >> 22 & 1) != 0;
    if (from_crystal && (cr_ & kHseReady) == 0)
      world_.report(Misuse::clock, "the PLL is turned on before its source is ready");
    check_pll();
    start(kPllReady, kPllLock);
  }
  if ((cr_ & kHseOn) == 0) cr_ &= ~kHseReady;
  if ((cr_ & kPllOn) == 0) cr_ &= ~kPllReady;
  if ((cr_ & kAudioPllOn) == 0) cr_ &= ~kAudioPllReady;
  cr_ = (cr_ & kHsiOn) != 0 ? cr_ | kHsiReady : cr_ & ~kHsiReady;
}

void Rcc::write_cfgr(std::uint32_t value) {
  cfgr_ = (cfgr_ & 0xC) | (value & ~0xCU);
  only(value, 0x1FFCFF, "CFGR");  // the clock outputs are not modelled; SWS is read-only and comes back with the rest
  switch_core();
  apply();
}

/// The core changes over to the clock that was asked for, as soon as that is ready.
void Rcc::switch_core() {
  const std::uint32_t wanted = cfgr_ & 3;
  const bool ready = wanted == 0 || (wanted == 1 && (cr_ & kHseReady) != 0) || (wanted == 2 && (cr_ & kPllReady) != 0);
  if (!ready || wanted == (cfgr_ >> 2 & 3)) return;
  cfgr_ = (cfgr_ & ~0xCU) | wanted << 2;
  apply();
}

/// Checks limits (RM0090 7.2, table 10; DS8626 5.3.1) and changes the core clock.
void Rcc::apply() {
  const std::uint32_t hz = core_hz();
  if (hz == 0) return world_.report(Misuse::clock, "the core clock would stop");
  if (hz > 168'000'000) world_.report(Misuse::clock, "the core runs above 168 MHz");
  if (apb1_hz() > 42'000'000) world_.report(Misuse::clock, "APB1 runs above 42 MHz");
  if (apb2_hz() > 84'000'000) world_.report(Misuse::clock, "APB2 runs above 84 MHz");
  const unsigned needed = (hz - 1) / 30'000'000;
  if (wait_states && wait_states() < needed)
    world_.report(Misuse::clock, "too few flash wait states for " + std::to_string(hz) + " Hz");
  world_.system().change_clock(world_.now(), period_of(hz));
}

void Rcc::write_reset(ClockBus bus, std::uint32_t& field, std::uint32_t value) {
  const std::uint32_t rising = value & ~field;
  field = value;
  for (unsigned bit = 0; bit < 32; ++bit) {
    if ((rising >> bit & 1) != 0 && reset_peripheral) reset_peripheral(bus, bit);
  }
}

/// A register that is only kept, or one that is more; null: none of them.
std::uint32_t* Rcc::kept(std::uint32_t offset) {
  switch (offset) {
    case 0x18:
      return &ahb3_reset_;
    case 0x30:
      return &ahb1_;
    case 0x34:
      return &ahb2_;
    case 0x38:
      return &ahb3_;
    case 0x40:
      return &apb1_;
    case 0x44:
      return &apb2_;
    case 0x80:
      return &spread_;
    case 0x84:
      return &audio_pll_;
    default:
      break;
  }
  const bool in_sleep = offset >= kSleepClocks && offset < kSleepClocks + 4 * sleep_clocks_.size();
  return in_sleep ? &sleep_clocks_[(offset - kSleepClocks) / 4] : nullptr;
}

std::uint32_t Rcc::read(std::uint32_t offset) {
  if (const std::uint32_t* value = kept(offset)) return *value;
  switch (offset) {
    case 0x00:
      return cr_;
    case 0x04:
      return pllcfgr_;
    case 0x08:
      return cfgr_;
    case 0x0C:
      return 0;
    case 0x10:
      return ahb1_reset_;
    case 0x14:
      return ahb2_reset_;
    case 0x20:
      return apb1_reset_;
    case 0x24:
      return apb2_reset_;
    case 0x70:
      return backup.read();
    case 0x74:
      return csr_;
    default:
      return unmodelled_read(offset);
  }
}

/// Bytes and halfwords are allowed: RM0090 7.3.
void Rcc::write_part(std::uint32_t offset, std::uint32_t mask, std::uint32_t value) {
  write(offset, (read(offset) & ~mask) | value);
}

void Rcc::write(std::uint32_t offset, std::uint32_t value) {
  if (std::uint32_t* place = kept(offset)) {
    if (offset == 0x84) only(value, 0x70007FC0, "PLLI2SCFGR");
    *place = value;
    return;
  }
  switch (offset) {
    case 0x00:
      return write_cr(value);
    case 0x04:
      if ((cr_ & kPllOn) != 0) world_.report(Misuse::clock, "PLLCFGR is written while the PLL is on");
      pllcfgr_ = value;
      return;
    case 0x08:
      return write_cfgr(value);
    case 0x0C:
      return;  // interrupts of the clock controller are not modelled as such; clearing them does no harm
    case 0x10:
      return write_reset(ClockBus::ahb1, ahb1_reset_, value);
    case 0x14:
      return write_reset(ClockBus::ahb2, ahb2_reset_, value);
    case 0x20:
      return write_reset(ClockBus::apb1, apb1_reset_, value);
    case 0x24:
      return write_reset(ClockBus::apb2, apb2_reset_, value);
    case 0x70:
      return backup.write(value);
    case 0x74:
      return write_csr(value);
    default:
      return unmodelled_write(offset);
  }
}

void Rcc::write_csr(std::uint32_t value) {
  const bool on = (value & kLsiOn) != 0, was = (csr_ & kLsiOn) != 0;
  if (on && !was) {
    world_.after(as_slow(kLsiStart), [this] {
      if ((csr_ & kLsiOn) != 0) csr_ |= kLsiReady;
    });
  }
  csr_ = (csr_ & ~kLsiOn) | (value & kLsiOn);
  if (!on) csr_ &= ~kLsiReady;
  if ((value >> 24 & 1) != 0) csr_ &= kLsiOn | kLsiReady;  // RMVF
}

std::uint32_t Rcc::usb_hz() const {
  const std::uint32_t q = pllcfgr_ >> 24 & 0xF, p = ((pllcfgr_ >> 16 & 3) + 1) * 2;
  return (cr_ & kPllReady) == 0 || q < 2 ? 0 : static_cast<std::uint32_t>(std::uint64_t{pll_hz()} * p / q);
}

std::uint32_t Rcc::divided_crystal_hz() const {
  const std::uint32_t divider = cfgr_ >> 16 & 0x1F;
  return (cr_ & kHseReady) != 0 && divider >= 2 ? crystal_hz / divider : 0;
}

std::uint32_t Rcc::rtc_hz() const {
  switch (backup.rtc_source()) {
    case BackupDomain::RtcSource::low_internal:
      return running_lsi_hz();
    case BackupDomain::RtcSource::crystal:
      return divided_crystal_hz();
    default:
      return 0;  // off, or the crystal of 32.768 kHz, which no board here has
  }
}

}  // namespace finemote::emulator
