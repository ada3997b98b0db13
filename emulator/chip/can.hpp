// A bxCAN controller: mailboxes by identifier, filters, a FIFO of three, error counters and bus-off. RM0090 32.
// Standard data frames only; FIFO 1, test and time-triggered modes are not modelled.
#pragma once

#include <array>
#include <deque>
#include <functional>

#include "emulator/chip/can_line.hpp"
#include "emulator/chip/peripheral.hpp"

namespace finemote::emulator {

/// The 28 filter banks both controllers share: RM0090 32.7.4.
struct CanFilters {
  std::uint32_t fmr = 0x2A1C0E01, mode = 0, scale = 0, fifo = 0, active = 0;
  std::array<std::array<std::uint32_t, 2>, 28> bank{};
  /// Does a bank of the first (or, for CAN2, second) group let the identifier in?
  [[nodiscard]] bool accepts(std::uint32_t id, bool second) const;
};

class Can : public Peripheral {
 public:
  struct Lines {
    int transmit, receive, error;
  };
  Can(World& world, std::string name, Lines lines, CanFilters& filters, bool second,
      std::function<std::uint32_t()> clock_hz);

  std::uint32_t read(std::uint32_t offset) override;
  void write(std::uint32_t offset, std::uint32_t value) override;
  void reset() override;

  CanLine line;
  [[nodiscard]] bool bus_off() const { return (esr_ & 4) != 0; }

 private:
  struct Mailbox {
    std::array<std::uint32_t, 4> words{};
    std::array<WordTags, 4> tags{};
    bool waiting = false;
    [[nodiscard]] CanFrame frame() const;
  };
  [[nodiscard]] bool on_bus() const { return !initialising_ && !bus_off(); }
  [[nodiscard]] std::optional<CanFrame> next() const;
  void sent(const CanFrame& frame, CanOutcome outcome);
  void received(const CanFrame& frame);
  void count_error(CanOutcome outcome);
  void recover();
  void write_mcr(std::uint32_t value);
  void write_filter(std::uint32_t offset, std::uint32_t value);
  [[nodiscard]] std::uint32_t read_filter(std::uint32_t offset);
  [[nodiscard]] std::uint32_t read_received(unsigned word);
  [[nodiscard]] std::uint32_t bitrate() const;
  void update();

  Lines lines_;
  CanFilters& filters_;
  bool second_;
  std::function<std::uint32_t()> clock_hz_;
  std::uint32_t mcr_ = 0, ier_ = 0, esr_ = 0, btr_ = 0, completed_ = 0;
  unsigned transmit_errors_ = 0;
  bool initialising_ = true, error_flag_ = false, overrun_ = false;
  std::array<Mailbox, 3> mailboxes_{};
  std::deque<CanFrame> fifo_;
};

}  // namespace finemote::emulator
