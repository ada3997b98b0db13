// Holds every device to its proven bounds while the robot runs (build option FINEMOTE_MONITOR).
//
// At the end of every handle() the monitor takes the time since the release of the job, and the age of the command the
// device acted on (now less its origin, where it is valid). It keeps the worst of both and counts what is above its
// bound. It stops nothing: a robot that wants to react reads the records, for example in finemote_overrun_hook().
#pragma once

#include <cstdint>

#include "finemote/bounds.hpp"
#include "finemote/contract.hpp"

namespace finemote {

/// What the monitor holds a device to. The bounds include the cost of the monitor and of the trace.
struct Monitored {
  std::uint8_t bucket;   ///< index in Schedule::buckets
  Duration response;     ///< bound, or kUnproven
  Duration age;          ///< bound, kUnproven or kNothingToBound
  const Stamp* command;  ///< what handle() acts on; null: it takes no command from another device
};

/// What the monitor has seen of a device: 24 bytes in RAM, all zero at start. Written at the end of handle() alone. A
/// probe that reads while the robot runs may find a half-written time: read twice.
struct MonitorRecord {
  Duration response_max;              ///< longest time from a release to the end of handle() [ns]
  Duration age_max;                   ///< oldest data behind a valid command [ns]; 0: there was none yet
  std::uint32_t response_violations;  ///< how often handle() ended later than its bound
  std::uint32_t age_violations;       ///< how often the data were older than their bound
};
static_assert(sizeof(MonitorRecord) == 24, "debug probes and `finemote run` know this layout");

struct Monitor {
  View<Monitored> devices;  ///< in schedule order
  MonitorRecord* records;   ///< one per device, the same order
};

/// The end of handle() of a device (stage number / 2). Called by Stage, in the device's bucket.
void monitor_handle(unsigned device);

/// The end of a job of a bucket. Called by complete(), in that bucket.
void monitor_job(unsigned bucket);

}  // namespace finemote

/// Defined by the generated schedule.cpp when it is built with FINEMOTE_MONITOR; its records are the array
/// `finemote_monitor_records`.
extern "C" const finemote::Monitor finemote_monitor;
