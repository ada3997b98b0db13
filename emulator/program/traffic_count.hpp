// What buses carry in a part of a run, and how often exceptions come in it.
#pragma once

#include <cstdint>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "emulator/board.hpp"

namespace finemote::emulator {

/// Counts from its construction on.
class TrafficCount {
 public:
  /// @param board  outlives this
  /// @param ports  the buses to account for
  TrafficCount(Board& board, std::vector<std::string> ports);
  TrafficCount(const TrafficCount&) = delete;
  TrafficCount& operator=(const TrafficCount&) = delete;

  /// Until now: `ns`, how long that is; of each port `[sent, received, lengths]`, how long its lines were in use in ns,
  /// which is `[in use, 0]` where it has one, and on I2C `[address, data bytes]` of every kind of transfer;
  /// `exceptions`: `[number, runs that ended]`.
  [[nodiscard]] nlohmann::ordered_json document() const;

 private:
  [[nodiscard]] std::vector<BusStatistics> of_ports() const;

  Board& board_;
  const std::vector<std::string> ports_;
  const std::uint64_t begin_ns_;
  const std::vector<BusStatistics> before_;
  const std::map<unsigned, OwnTime> exceptions_before_;
};

}  // namespace finemote::emulator
