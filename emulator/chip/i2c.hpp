// An I2C peripheral as master: START, bytes and STOP take their bits' time, and the clock is held where the manual says
// it is. RM0090 27. As slave it is not modelled.
#pragma once

#include <functional>

#include "emulator/chip/bus_statistics.hpp"
#include "emulator/chip/dma.hpp"
#include "emulator/chip/i2c_line.hpp"
#include "emulator/chip/peripheral.hpp"

namespace finemote::emulator {

class I2c : public Peripheral {
 public:
  struct Wiring {
    int event_line, error_line;
    DmaRequest rx, tx;
    std::function<std::uint32_t()> clock_hz;
    std::function<bool(DmaRequest)> dma;
    std::function<std::uint32_t(DmaRequest)> dma_left;  ///< items that a stream has still to move
  };
  I2c(World& world, std::string name, Wiring wiring) : Peripheral(world, std::move(name)), wiring_(std::move(wiring)) {}

  std::uint32_t read(std::uint32_t offset) override;
  void write(std::uint32_t offset, std::uint32_t value) override;
  void reset() override;
  void poll_dma() override { ask_dma(); }

  I2cLine line;
  /// Told of every step on the wire, for those who look on: `address`, `write`, `read` with their byte, or `stop`.
  std::function<void(const char* what, std::uint8_t byte, bool acknowledged)> on_wire;
  /// A part is in the middle of sending a byte.
  [[nodiscard]] bool receiving() const { return state_ == State::receiving; }
  [[nodiscard]] const BusStatistics& statistics() const { return statistics_; }
  /// Bus clock that CCR gives [Hz].
  [[nodiscard]] std::uint32_t bus_hz() const;
  /// The next START is seen misplaced: BERR, as a disturbed wire causes it.
  unsigned disturbed_starts = 0;
  /// The next STARTs lose the bus to another master: ARLO.
  unsigned lost_starts = 0;

 private:
  enum class State {
    idle,
    starting,
    started,
    addressing,
    addressed,
    sending,
    send_wait,
    receiving,
    receive_wait,
    stopping
  };

  [[nodiscard]] Time bits(unsigned count) const { return count * period_of(bus_hz()); }
  /// `count` bits are on the wire, and then comes `what`.
  void clock(unsigned count, void (I2c::*what)(), Time longer = 0);
  void go(State state) { state_ = state; }
  void write_cr1(std::uint32_t value);
  void request_start();
  void start_done();
  void address_done();
  void leave_addressed();
  void begin_send();
  void byte_sent();
  void pause();
  void begin_receive();
  void byte_received();
  void read_data();
  void request_stop();
  void begin_stop();
  void stop_done();
  void fail(std::uint32_t error);
  void tell(const char* what, std::uint8_t byte, bool acknowledged) const {
    if (on_wire) on_wire(what, byte, acknowledged);
  }
  void ask_dma();
  void update();
  [[nodiscard]] bool on() const { return (cr1_ & 1) != 0; }

  Wiring wiring_;
  std::uint32_t cr1_ = 0, cr2_ = 0, oar1_ = 0, oar2_ = 0, sr1_ = 0, sr2_ = 0, ccr_ = 0, trise_ = 2, fltr_ = 0;
  State state_ = State::idle;
  std::uint64_t token_ = 0;
  WireByte data_, shift_;
  bool data_full_ = false;   ///< transmit: a byte waits in DR
  bool shift_full_ = false;  ///< receive: a byte waits in the shift register
  bool is_single_ = false;   ///< the byte that comes is the only one
  bool last_acknowledged_ = true, reading_ = false, addr_seen_ = false, sb_seen_ = false;
  bool asking_ = false;      ///< DMA moves a byte right now
  bool last_comes_ = false;  ///< by DMA: the next byte is not acknowledged
  unsigned byte_index_ = 0;
  unsigned address_ = 0, moved_ = 0;  ///< part and data bytes since the first START
  BusStatistics statistics_;
};

}  // namespace finemote::emulator
