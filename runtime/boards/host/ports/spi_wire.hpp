// The wires of an SPI port on the host: one part per chip select.
#pragma once

#include <cstdint>
#include <map>
#include <vector>

#include "board/wires.hpp"
#include "finemote/ports.hpp"

namespace finemote::host {

/// A part behind a chip select.
class SpiPart {
 public:
  virtual ~SpiPart() = default;
  /// What it sends back for what it gets, byte by byte.
  virtual std::vector<std::uint8_t> exchange(const std::vector<std::uint8_t>& bytes) = 0;
};

}  // namespace finemote::host

namespace finemote {

/// The host's wires, and the hardware behind SpiPort.
struct SpiHardware {
  // ---- for tests
  /// Hangs a part behind a chip select, in the order of the board file; it outlives its connection.
  void connect(std::uint8_t select, host::SpiPart& part) { parts[select] = &part; }
  /// The clock stops: exchanges do not end any more.
  void block(bool stop) { blocked = stop; }

  // ---- for the port
  std::map<std::uint8_t, host::SpiPart*> parts;
  bool blocked = false;
  std::int64_t clock_hz = 0;
  SpiBus* bus = nullptr;
  std::uint64_t exchange = 0;
};

}  // namespace finemote
