// The two DMA controllers: moves one item per request of a peripheral, or memory to memory, into one buffer or two.
// RM0090 10. The FIFO is not seen: what goes through it arrives at once; nor are bursts.
#pragma once

#include <array>
#include <functional>

#include "emulator/chip/peripheral.hpp"

namespace finemote::emulator {

/// What a peripheral can ask for: RM0090 10.3.3, tables 42 and 43.
enum class DmaRequest {
  usart1_rx,
  usart1_tx,
  usart2_rx,
  usart2_tx,
  usart3_rx,
  usart3_tx,
  usart6_rx,
  usart6_tx,
  uart4_rx,
  uart4_tx,
  uart5_rx,
  uart5_tx,
  spi1_rx,
  spi1_tx,
  spi2_rx,
  spi2_tx,
  spi3_rx,
  spi3_tx,
  i2c1_rx,
  i2c1_tx,
  i2c2_rx,
  i2c2_tx,
  i2c3_rx,
  i2c3_tx,
  adc1,
  adc2,
  adc3
};

class Dma : public Peripheral {
 public:
  Dma(World& world, unsigned number, PeripheralBus& bus)
      : Peripheral(world, "dma" + std::to_string(number)), number_(number), bus_(bus) {}

  std::uint32_t read(std::uint32_t offset) override;
  void write(std::uint32_t offset, std::uint32_t value) override;
  void reset() override;

  /// One item for this request, if a stream that serves it is on. @return whether it was moved
  bool serve(DmaRequest request);
  /// Items the stream that serves this request has still to move; 0: there is none.
  [[nodiscard]] std::uint32_t left(DmaRequest request) const;
  /// A bus error of the stream that serves this request: it stops, with its error flag. @return whether there was one
  bool break_stream(DmaRequest request);
  /// Called when a stream is turned on.
  std::function<void()> on_enable;

 private:
  struct Stream {
    std::uint32_t control = 0, count = 0, peripheral = 0, memory0 = 0, memory1 = 0, fifo = 0x21;
    std::uint32_t left = 0;       ///< items still to move; `count` is what was programmed last
    std::uint32_t position = 0;   ///< items moved in this lap
    std::uint32_t turned_on = 0;  ///< how often: what was begun before is forgotten
  };
  void write_control(unsigned index, std::uint32_t value);
  void turn_on(unsigned index);
  void move_all(unsigned index);
  void move(unsigned index);
  void raise(unsigned index, std::uint32_t flags);
  void update_line(unsigned index);
  [[nodiscard]] int serving(DmaRequest request) const;
  void check_set_up(unsigned index, unsigned field);
  bool transfer(Stream& stream, std::uint32_t memory);
  bool read_peripheral(std::uint32_t address, unsigned bytes, std::uint32_t& value);
  bool write_peripheral(std::uint32_t address, unsigned bytes, std::uint32_t value);
  [[nodiscard]] bool has_bridge_to(std::uint32_t address) const;
  bool fail(std::uint32_t address);
  void store(std::uint32_t memory, unsigned bytes, std::uint32_t value);
  void raise_late(unsigned index, std::uint32_t flags);
  [[nodiscard]] Time late(Strictness way);
  std::uint8_t* reachable(std::uint32_t address, unsigned bytes, bool written);

  unsigned number_;
  PeripheralBus& bus_;
  std::array<Stream, 8> streams_{};
  std::array<std::uint32_t, 8> flags_{};  ///< in the order of LISR
  Time stored_at_ = 0;                    ///< how much later than now the item that is moved is in memory
};

}  // namespace finemote::emulator
