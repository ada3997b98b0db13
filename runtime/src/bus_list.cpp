#include "finemote/bus_counters.hpp"

namespace finemote {
namespace {

BusCounters* first = nullptr;

}  // namespace

void list_bus(BusCounters& counters) {
  BusCounters** end = &first;
  while (*end != nullptr && *end != &counters) end = &(*end)->next;
  *end = &counters;
}

void forget_buses() { first = nullptr; }

const BusCounters* first_bus() { return first; }

}  // namespace finemote
