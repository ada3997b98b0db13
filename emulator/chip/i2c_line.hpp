// Two wires and the parts on them: what a master can do to an I2C bus, and what can go wrong there.
#pragma once

#include <cstdint>
#include <vector>

#include "emulator/core/tag.hpp"

namespace finemote::emulator {

/// A part with an address. Calls come in bus order; times are those of the last bit.
class I2cPart {
 public:
  virtual ~I2cPart() = default;
  /// A START with this 7-bit address. @return acknowledge
  virtual bool select(std::uint8_t address, bool read) = 0;
  /// A byte to the part, after it was selected for writing. @return acknowledge
  virtual bool write(WireByte byte) = 0;
  /// A byte from the part, after it was selected for reading.
  virtual WireByte read() = 0;
  virtual void stop() = 0;
};

class I2cLine {
 public:
  void attach(I2cPart& part) { parts_.push_back(&part); }

  bool select(std::uint8_t address, bool read) {
    for (Fault& fault : faults_) {
      if (fault.address == address && fault.nacks > 0) {
        --fault.nacks;
        selected_.clear();
        return false;
      }
    }
    selected_.clear();
    for (I2cPart* part : parts_) {
      if (part->select(address, read)) selected_.push_back(part);
    }
    return !selected_.empty();
  }
  bool write(WireByte byte) {
    bool acknowledged = false;
    for (I2cPart* part : selected_) acknowledged = part->write(byte) || acknowledged;
    return acknowledged;
  }
  /// Several parts answering at once pull the bits together; an empty bus reads ones.
  WireByte read() {
    WireByte byte = 0xFF;
    for (I2cPart* part : selected_) byte &= part->read();
    return byte;
  }
  void stop() {
    for (I2cPart* part : parts_) part->stop();
    selected_.clear();
  }

  // Faults. A part that lost count of a read holds SDA until it has seen `clocks` more clock pulses.
  void hold_sda(unsigned clocks) { held_clocks_ = clocks; }
  void nack(std::uint8_t address, unsigned times) { faults_.push_back(Fault{address, times}); }
  [[nodiscard]] bool sda_held() const { return held_clocks_ != 0; }

  // The wires by hand: what the master's pins pull low when they are not the peripheral's.
  void set_scl(bool high) {
    if (high && !scl_ && held_clocks_ != 0 && held_clocks_ != kForever) --held_clocks_;
    if (high && !scl_) ++clocks_by_hand_;
    scl_ = high;
  }
  void set_sda(bool high) { sda_ = high; }
  [[nodiscard]] bool scl() const { return scl_; }
  [[nodiscard]] bool sda() const { return sda_ && held_clocks_ == 0; }
  [[nodiscard]] unsigned clocks_by_hand() const { return clocks_by_hand_; }
  static constexpr unsigned kForever = ~0U;

 private:
  struct Fault {
    std::uint8_t address;
    unsigned nacks;
  };
  std::vector<I2cPart*> parts_, selected_;
  std::vector<Fault> faults_;
  unsigned held_clocks_ = 0, clocks_by_hand_ = 0;
  bool scl_ = true, sda_ = true;
};

}  // namespace finemote::emulator
