// What the runtime takes around the stages of a robot: bounds that were computed from its image.
#pragma once

#include <map>
#include <vector>

#include "generator/descriptor/drivers.hpp"
#include "generator/index/ids.hpp"
#include "generator/units/duration.hpp"

namespace finemote::gen {

/// Of the timing file, where it fits and has all of them. Without faults; entry and exit of exceptions are not in them.
struct ComputedCosts {
  /// What runs before a stage in its job: from the job's begin, or the end of the stage before.
  struct Before {
    Duration update, handle;
  };
  /// What an interrupt costs besides, because it makes the code that it comes into read once more what it changed.
  struct Retries {
    Duration release, received, event;
  };

  /// At the end of jobs of this period; of one that the image does not have, as where other periods are tried, the
  /// longest of all.
  [[nodiscard]] Duration behind_jobs(Duration period) const;

  Duration release;  ///< one run of its routine
  Duration masked;   ///< longest section with interrupts masked
  Table<DeviceId, Before> before;
  std::map<Duration, Duration> behind;  ///< by period: from the last stage to the end of the job, flushes included
  std::map<std::pair<BusId, DriverSource::Counts>, Duration> routines;  ///< a run that such an event raises
  std::map<BusId, std::vector<Duration>> requests;  ///< a request that hands over one frame, two, ...
  Duration pins;                                    ///< a run of the routine of any line that belongs to no bus
  Retries retries;
  bool is_guess = false;  ///< of an image that may be another one now
};

}  // namespace finemote::gen
