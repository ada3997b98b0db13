// The wires of buses, on which one frame ends after the other.
#pragma once

#include <algorithm>
#include <vector>

#include "generator/timing/task_set.hpp"

namespace finemote::gen {

class Wires {
 public:
  /// @param sources  of all buses
  Wires(const std::vector<timing::Stream>& sources, std::size_t buses)
      : shortest_(buses, Duration::max()), free_from_(buses) {
    for (const timing::Stream& source : sources) {
      if (source.ends_frame) shortest_[*source.place] = std::min(shortest_[*source.place], source.separation);
    }
  }

  /// Whether what raises this source can end then. A frame that would end too soon after another one on its wire was
  /// never sent; any other is noted.
  bool carries(const timing::Stream& source, Duration at) {
    if (!source.ends_frame) return true;
    if (at < free_from_[*source.place]) return false;
    free_from_[*source.place] = at + shortest_[*source.place];
    return true;
  }

 private:
  Table<timing::BusPlace, Duration> shortest_;   ///< frame that ends on the wire
  Table<timing::BusPlace, Duration> free_from_;  ///< for the end of the next one
};

}  // namespace finemote::gen
