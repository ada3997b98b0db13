// How devices of a robot hang on its buses, and which frames of theirs go where.
#pragma once

#include <vector>

#include "generator/model/robot.hpp"

namespace finemote::gen {

/// A device on a segment: on its own bus, or by a `<use>`.
struct Connection {
  SegmentId segment;
  const Use* use = nullptr;  ///< null: the device's own
};

/// The own one first, then those of uses in their order.
std::vector<Connection> connections_of(const Device& device);

/// The frames its descriptor declares for that connection; none where it declares none. The device has a type.
std::vector<Frame> frames_over(const Device& device, const Connection& connection);

/// The format of a serial line, as the descriptor states it for that connection: `8N1`.
const std::string& format_over(const Device& device, const Connection& connection);

}  // namespace finemote::gen
