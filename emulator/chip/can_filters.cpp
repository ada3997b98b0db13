#include "emulator/chip/can_filters.hpp"

namespace finemote::emulator {

bool CanFilters::Rank::goes_before(const Rank& other) const {
  if (wide != other.wide) return wide;
  if (list != other.list) return list;
  return number < other.number;
}

std::optional<unsigned> CanFilters::match_in(unsigned bank, std::uint32_t id) const {
  const bool list = (mode_ >> bank & 1) != 0, wide = (scale_ >> bank & 1) != 0;
  const std::uint32_t *first = &banks_[2 * bank], *second = first + 1;
  if (wide) {
    const std::uint32_t value = id << 21;
    if (!list) return ((value ^ *first) & *second) == 0 ? std::optional(0U) : std::nullopt;
    return value == *first ? std::optional(0U) : value == *second ? std::optional(1U) : std::nullopt;
  }
  const std::uint32_t value = id << 5;
  for (unsigned half = 0; half < 2; ++half) {
    const std::uint32_t low = banks_[2 * bank + half] & 0xFFFF, high = banks_[2 * bank + half] >> 16;
    if (!list && ((value ^ low) & high) == 0) return half;
    if (list && value == low) return 2 * half;
    if (list && value == high) return 2 * half + 1;
  }
  return std::nullopt;
}

std::optional<CanFilters::Match> CanFilters::match(std::uint32_t id, bool second) const {
  const unsigned split = fmr_ >> 8 & 0x3F, end = second ? kCount : split;
  std::array<unsigned, 2> counted{};
  std::optional<Match> best;
  Rank best_rank{};
  for (unsigned bank = second ? split : 0; bank < end && bank < kCount; ++bank) {
    const unsigned fifo = fifo_ >> bank & 1;
    const auto found = (active_ >> bank & 1) != 0 ? match_in(bank, id) : std::nullopt;
    if (found) {
      const Rank rank{(scale_ >> bank & 1) != 0, (mode_ >> bank & 1) != 0, counted[fifo] + *found};
      if (!best || rank.goes_before(best_rank)) {
        best = Match{fifo, rank.number};
        best_rank = rank;
      }
    }
    counted[fifo] += filters_in(bank);
  }
  return best;
}

std::uint32_t* CanFilters::place(std::uint32_t offset) {
  switch (offset) {
    case kMaster:
      return &fmr_;
    case kMode:
      return &mode_;
    case kScale:
      return &scale_;
    case kFifo:
      return &fifo_;
    case kActive:
      return &active_;
    default:
      break;
  }
  if (offset < kBanks || (offset - kBanks) / 4 >= banks_.size()) return nullptr;
  return &banks_[(offset - kBanks) / 4];
}

bool CanFilters::write(std::uint32_t offset, std::uint32_t value) {
  std::uint32_t* to = place(offset);
  if (to != nullptr) *to = value;
  return to != nullptr;
}

std::optional<std::uint32_t> CanFilters::read(std::uint32_t offset) {
  const std::uint32_t* from = place(offset);
  return from == nullptr ? std::nullopt : std::optional(*from);
}

}  // namespace finemote::emulator
