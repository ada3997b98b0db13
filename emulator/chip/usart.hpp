// A USART: bytes on the wire take their bits' time. RM0090 30.
#pragma once

#include <bit>
#include <functional>
#include <vector>

#include "emulator/chip/bus_statistics.hpp"
#include "emulator/chip/dma.hpp"
#include "emulator/chip/peripheral.hpp"

namespace finemote::emulator {

/// How one end talks on a serial line.
struct SerialFormat {
  std::uint32_t baud = 115200;
  bool even_parity = false;
  unsigned stop_bits = 1;
  bool odd_parity = false;
  unsigned data_bits = 8;  ///< 7 to 9, without the parity
  [[nodiscard]] bool has_parity() const { return even_parity || odd_parity; }
  [[nodiscard]] unsigned bits() const { return 1 + data_bits + (has_parity() ? 1 : 0) + stop_bits; }
  [[nodiscard]] Time byte_time() const { return bits() * period_of(baud); }
  /// The parity bit of a byte.
  [[nodiscard]] unsigned parity_of(unsigned byte) const {
    return static_cast<unsigned>(std::popcount(byte)) % 2 ^ (odd_parity ? 1 : 0);
  }
};

class Usart : public Peripheral {
 public:
  struct Wiring {
    int line;
    DmaRequest rx, tx;
    std::function<std::uint32_t()> clock_hz;
    std::function<bool(DmaRequest)> dma;
  };
  Usart(World& world, std::string name, Wiring wiring)
      : Peripheral(world, std::move(name)), wiring_(std::move(wiring)) {}

  std::uint32_t read(std::uint32_t offset) override;
  void write(std::uint32_t offset, std::uint32_t value) override;
  void reset() override;
  void poll_dma() override { ask_dma(); }

  /// Bytes arrive from outside, one after another from now on (after those already on their way). The last one carries
  /// `sample`, unless one of them is damaged or lost on its way: what is parsed has come whole.
  void send_in(const std::vector<std::uint8_t>& bytes, const SerialFormat& format, Tag sample = Tag::none);
  /// Bytes from outside are still on their way.
  [[nodiscard]] bool is_receiving() const { return in_free_at_ > world_.now(); }
  /// A byte has left the chip; the time is that of its last stop bit.
  std::function<void(WireByte)> on_sent;

  [[nodiscard]] SerialFormat format() const;
  [[nodiscard]] BusStatistics statistics() const;

  // Faults of the line: while set, arriving bytes are lost, or come with a framing error.
  bool silent = false;
  unsigned noisy_bytes = 0;

 private:
  /// What comes in, and whether it begins what its sender sends at once.
  struct Arrival {
    WireByte byte;
    bool is_first;
  };
  void arrive(const Arrival& arrival, const SerialFormat& sender);
  struct Sampled {
    unsigned ninth;        ///< where the receiver takes nine bits
    std::uint32_t errors;  ///< as in SR
  };
  [[nodiscard]] Sampled sample(unsigned byte, const SerialFormat& sender);
  void line_idle(std::uint64_t token, Time at);
  [[nodiscard]] std::uint8_t sent_bits(std::uint32_t value) const;
  void write_cr1(std::uint32_t value);
  void hear_noise();
  void start_shift();
  void idle_frame();
  void shifted(WireByte byte);
  void ask_dma();
  void update();
  [[nodiscard]] bool on() const { return (cr1_ >> 13 & 1) != 0; }
  [[nodiscard]] bool sends() const { return (cr1_ & 0x2008) == 0x2008; }  // UE, TE
  [[nodiscard]] std::uint32_t divider() const;

  Wiring wiring_;
  std::uint32_t sr_ = 0xC0, brr_ = 0, cr1_ = 0, cr2_ = 0, cr3_ = 0, gtpr_ = 0;
  WireByte received_, to_send_;
  unsigned ninth_ = 0;  ///< bit of what was received
  bool data_full_ = false, shifting_ = false, status_read_ = false;
  bool spoilt_ = false;  ///< what arrives is not whole
  Time in_free_at_ = 0;
  std::uint64_t driven_ = 0;  ///< times that the other side began to drive the line
  std::uint64_t idle_token_ = 0;
  std::uint64_t in_bytes_ = 0, out_bytes_ = 0, bursts_ = 0, errors_ = 0;
  Time in_busy_ = 0, out_busy_ = 0, out_last_ = 0;
};

}  // namespace finemote::emulator
