// Registers of a CAN controller (bxCAN) and of the filters the two controllers share.
#pragma once

#include "runtime/chips/stm32f4/registers/register.hpp"

namespace finemote::stm32f4 {

/// bxCAN, RM0090 32.9.
struct CanRegisters {
  std::uint32_t base;

  [[nodiscard]] constexpr Register mcr() const { return Register{base + 0x00}; }   // 32.9.2
  [[nodiscard]] constexpr Register msr() const { return Register{base + 0x04}; }   // 32.9.2
  [[nodiscard]] constexpr Register tsr() const { return Register{base + 0x08}; }   // 32.9.2
  [[nodiscard]] constexpr Register rf0r() const { return Register{base + 0x0C}; }  // 32.9.2
  [[nodiscard]] constexpr Register ier() const { return Register{base + 0x14}; }   // 32.9.2
  [[nodiscard]] constexpr Register esr() const { return Register{base + 0x18}; }   // 32.9.2
  [[nodiscard]] constexpr Register btr() const { return Register{base + 0x1C}; }   // 32.9.2

  /// Identifier, length and data of transmit mailbox 0..2, 32.9.3: word 0 TIR, 1 TDTR, 2 TDLR, 3 TDHR.
  [[nodiscard]] constexpr Register mailbox(std::uint32_t number, std::uint32_t word) const {
    return Register{base + 0x180 + 0x10 * number + 4 * word};
  }
  /// The oldest frame of FIFO 0, 32.9.3: word 0 RIR, 1 RDTR, 2 RDLR, 3 RDHR.
  [[nodiscard]] constexpr Register received(std::uint32_t word) const { return Register{base + 0x1B0 + 4 * word}; }
};

namespace can {
/// MCR and MSR.
inline constexpr std::uint32_t kInitRequest = bit(0), kSleepRequest = bit(1), kInitAcknowledge = bit(0),
                               kErrorFlag = bit(2), kReceiving = bit(9);
/// TSR: request completed and abort of mailbox 0; eight bits further for the next ones. Empty: bits 26 to 28.
inline constexpr std::uint32_t kCompleted = bit(0), kAbort = bit(7), kEmptyShift = 26;
/// RF0R.
inline constexpr std::uint32_t kPendingMask = 3, kOverrun = bit(4), kRelease = bit(5);
/// IER.
inline constexpr std::uint32_t kTransmitInterrupt = bit(0), kReceiveInterrupt = bit(1), kBusOffInterrupt = bit(10),
                               kErrorInterrupt = bit(15);
/// ESR.
inline constexpr std::uint32_t kBusOff = bit(2);
/// TIR: send it; a standard identifier lies in bits 21 to 31.
inline constexpr std::uint32_t kSend = bit(0), kIdentifierShift = 21;
/// RIR: extended identifier or remote request.
inline constexpr std::uint32_t kExtendedOrRemote = bit(2) | bit(1);

/// The filters, 32.9.4, in CAN1's registers for both controllers.
inline constexpr Register fmr{0x40006600}, fm1r{0x40006604}, fs1r{0x4000660C}, ffa1r{0x40006614}, fa1r{0x4000661C};
constexpr Register filter(std::uint32_t bank, std::uint32_t half) { return Register{0x40006640 + 8 * bank + 4 * half}; }
inline constexpr std::uint32_t kFilterInit = bit(0), kSplitShift = 8, kSplitMask = 0x3FU << kSplitShift;
}  // namespace can

}  // namespace finemote::stm32f4
