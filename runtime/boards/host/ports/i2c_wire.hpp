// The two wires of an I2C port on the host: parts hang on them, bytes take time, and faults can be scripted.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "board/wires.hpp"
#include "finemote/ports.hpp"

namespace finemote::host {

/// A part on an I2C wire. Each call is one phase of an exchange the part acknowledged.
class I2cPart {
 public:
  virtual ~I2cPart() = default;
  /// Bytes written to it. False: it does not acknowledge them.
  virtual bool write(const std::vector<std::uint8_t>& bytes) = 0;
  /// Bytes it puts on the wire; false: it does not acknowledge its address.
  virtual bool read(std::size_t size, std::vector<std::uint8_t>& bytes) = 0;
  /// Its power fails for an instant.
  virtual void reset() {}
  /// Parts behind this one that answer to `address` now (a mux); none for ordinary parts.
  virtual I2cPart* behind(std::uint8_t) { return nullptr; }
};

/// One exchange as a logic analyser shows it.
struct I2cExchange {
  Time begin;                         ///< START
  Time end;                           ///< STOP
  std::uint8_t address;               ///< 7 bit
  std::vector<std::uint8_t> written;  ///< by the robot
  std::vector<std::uint8_t> read;     ///< from the part
  I2cEvent event;                     ///< kNone: it was aborted
};

}  // namespace finemote::host

namespace finemote {

/// The host's wire, and the hardware behind I2cPort.
struct I2cHardware {
  // ---- for tests
  /// Hangs a part on the wire; it outlives its connection.
  void connect(std::uint8_t address, host::I2cPart& part) { parts[address] = &part; }
  void disconnect(std::uint8_t address) { parts.erase(address); }  ///< nothing answers there any more
  /// SDA is held low from now on, until `clocks` clocks of a recovery have gone by; negative: for ever.
  void hold_sda(int clocks);
  void release_sda() { held = 0; }  ///< ends hold_sda()
  /// The next `count` exchanges are not acknowledged.
  void refuse(int count) { refusals = count; }
  /// The next `count` exchanges end in a bus error.
  void disturb(int count) { disturbances = count; }
  /// Called whenever the driver pends its interrupt: in the middle of whatever asked for it.
  std::function<void()> when_pended;
  /// No parts, no faults, nothing recorded.
  void reset();

  std::vector<host::I2cExchange> exchanges;  ///< in order, units with a mux as several
  unsigned recovery_clocks = 0;              ///< clocks sent by recoveries so far

  // ---- for the port
  I2cEvent perform(const I2cMessage& message, host::I2cExchange& record);
  host::I2cPart* find(std::uint8_t address);

  std::map<std::uint8_t, host::I2cPart*> parts;
  int held = 0;  ///< clocks until SDA is released; negative: never
  int refusals = 0, disturbances = 0;
  std::int64_t clock_hz = 0;
  I2cBus* bus = nullptr;
  std::uint64_t exchange = 0;  ///< number of the exchange under way; changes when it ends or is aborted
  bool under_way = false;
  I2cMessage message{};
};

}  // namespace finemote
