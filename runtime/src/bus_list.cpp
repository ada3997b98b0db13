#include "finemote/bus_counters.hpp"

#include "finemote/loop_bound.hpp"

namespace finemote {
namespace {

BusCounters* first = nullptr;

/// More than any chip has ports.
constexpr unsigned kMostBuses = 32;

}  // namespace

void list_bus(BusCounters& counters) {
  const LoopBound<kMostBuses> buses;
  BusCounters** end = &first;
  while (*end != nullptr && *end != &counters) {
    buses.pass();
    end = &(*end)->next;
  }
  *end = &counters;
}

void forget_buses() { first = nullptr; }

const BusCounters* first_bus() { return first; }

}  // namespace finemote
