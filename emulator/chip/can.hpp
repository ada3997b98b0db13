// A bxCAN controller: mailboxes by identifier or by request, filters, two FIFOs of three, error counters and bus-off.
// RM0090 32. Standard data frames only; test and time-triggered modes are not modelled.
#pragma once

#include <array>
#include <deque>
#include <functional>

#include "emulator/chip/can_filters.hpp"
#include "emulator/chip/can_line.hpp"
#include "emulator/chip/peripheral.hpp"

namespace finemote::emulator {

class Can : public Peripheral {
 public:
  struct Lines {
    int transmit;
    std::array<int, 2> receive;  ///< by FIFO
    int error;
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
    bool aborting = false;      ///< goes empty at the end of the transmission under way, whatever becomes of that
    std::uint64_t request = 0;  ///< counts requests to transmit
    [[nodiscard]] CanFrame frame() const;
  };
  struct Received {
    CanFrame frame;
    unsigned match;  ///< number of the filter that let it in
  };
  struct Fifo {
    std::deque<Received> frames;
    bool full = false, overrun = false;
  };
  [[nodiscard]] bool on_bus() const { return !initialising_ && !bus_off(); }
  [[nodiscard]] const Mailbox* most_urgent() const;
  [[nodiscard]] bool goes_before(const Mailbox& a, const Mailbox& b) const;
  std::optional<CanFrame> next();
  [[nodiscard]] bool is_on_wire(unsigned mailbox);
  [[nodiscard]] std::uint32_t transmit_status() const;
  void write_transmit_status(std::uint32_t value);
  void write_mailbox(unsigned index, unsigned word, std::uint32_t value);
  [[nodiscard]] std::uint32_t fifo_status(const Fifo& fifo) const;
  void write_fifo(Fifo& fifo, std::uint32_t value);
  void sent(const CanFrame& frame, CanOutcome outcome);
  void complete(unsigned index, bool ok);
  void abort(unsigned index);
  void received(const CanFrame& frame);
  void count_error(CanOutcome outcome);
  void recover();
  void count_recessive(unsigned recovery, std::uint64_t left, std::uint64_t frames);
  void write_mcr(std::uint32_t value);
  void enter_initialisation();
  void write_filter(std::uint32_t offset, std::uint32_t value);
  [[nodiscard]] std::uint32_t read_received(const Fifo& fifo, unsigned word);
  [[nodiscard]] std::uint32_t error_status() const;
  [[nodiscard]] std::uint32_t master_status();
  void note_error();
  [[nodiscard]] std::uint32_t bitrate() const;
  [[nodiscard]] bool tests_itself() const;
  CanLine& wire() { return tests_itself() ? own_ : line; }
  void update();

  CanLine own_;  ///< from its output to its input, inside
  Lines lines_;
  CanFilters& filters_;
  bool second_;
  std::function<std::uint32_t()> clock_hz_;
  std::uint32_t mcr_ = 0, ier_ = 0, esr_ = 0, btr_ = 0, completed_ = 0;
  unsigned transmit_errors_ = 0;
  unsigned recovery_ = 0;      ///< the last that was begun
  bool acknowledged_ = false;  ///< INAK
  bool initialising_ = true, error_flag_ = false;
  std::array<Mailbox, 3> mailboxes_{};
  std::optional<unsigned> offered_;  ///< the mailbox that took part in the last arbitration
  std::uint64_t requests_ = 0;
  std::array<Fifo, 2> fifos_{};
};

}  // namespace finemote::emulator
