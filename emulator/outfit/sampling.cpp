#include "emulator/outfit/sampling.hpp"

namespace finemote::emulator {

using namespace scenario;

Member clock_error() {
  return usually(0, number("clock_ppm", "ppm", "how much faster its clock runs than the board's", -2e5, 2e5));
}

std::vector<Member> sampling() {
  return {usually(0, integer("phase_ns", "ns", "of one of its samples", 0, kLongest)), clock_error()};
}

OwnClock own_clock(PartClock board, const Json& entry) {
  return {std::move(board), phase_of(entry), need<double>(entry, "clock_ppm")};
}

}  // namespace finemote::emulator
