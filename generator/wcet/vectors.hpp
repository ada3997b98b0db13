// What an image says of its entries: exceptions with a routine, and the start of the buses.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "generator/image/image.hpp"

namespace finemote::gen::wcet {

struct Vector {
  unsigned exception = 0;
  std::uint32_t entry = 0;
};

/// The release and every interrupt line with a routine of its own.
std::vector<Vector> interrupt_vectors(const Image& image);

/// What the schedule starts the buses by; none: the image has no schedule.
std::optional<std::uint32_t> start_of_buses(const Image& image);

}  // namespace finemote::gen::wcet
