// What a bus has done and suffered, as numbers anybody may read.
#pragma once

#include <cstdint>

namespace finemote {

/// Counts since start; each wraps. Written by the bus alone, read anywhere (each is one word).
struct BusCounters {
  std::uint32_t transfers = 0;   ///< ended, well or not
  std::uint32_t errors = 0;      ///< of these: not acknowledged, failed or overdue; for a uart: line errors seen
  std::uint32_t overdue = 0;     ///< of these: ended by their deadline
  std::uint32_t recoveries = 0;  ///< bus recoveries begun
  std::uint32_t lost = 0;        ///< received bytes or frames nobody read in time; requests refused
  BusCounters* next = nullptr;   ///< of the bus started after this one
};

/// Puts a bus at the end of the list of started ones, once; every bus that counts does so in start().
void list_bus(BusCounters& counters);

/// Empties the list, for tests whose buses come and go: a bus on it must live as long as the list.
void forget_buses();

/// The counters of the first bus started (document order); null when none counts.
const BusCounters* first_bus();

}  // namespace finemote
