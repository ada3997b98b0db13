// Memory that never changes while the robot runs: its contents are those of the image.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "generator/image/image.hpp"
#include "generator/wcet/machine.hpp"

namespace finemote::gen::wcet {

/// A range of addresses: [begin, end).
using AddressRange = std::pair<std::uint32_t, std::uint32_t>;

/// Lies in what the start fills with zeros: there is nothing of it in the file.
bool is_zeroed(const Image& image, std::uint32_t address, std::uint32_t size);

class Constants {
 public:
  /// @param members  constant parts of variables that may change elsewhere: generator/image/constants.hpp
  /// @param words    others, that start-up sets for good
  Constants(const Image& image, std::vector<AddressRange> members, std::map<std::uint32_t, std::uint32_t> words = {});

  /// What a load reads: one value at a constant address, a range over a table; none: it may change, or is unknown.
  [[nodiscard]] std::optional<Interval> load(const Access& access) const;
  /// A store to this address, where it is known, writes to what was taken for constant.
  [[nodiscard]] bool is_broken_by(const Access& store) const;

 private:
  [[nodiscard]] bool is_constant(std::uint32_t address, std::uint32_t size) const;
  [[nodiscard]] std::optional<std::uint32_t> word(std::uint32_t address, std::uint32_t size) const;

  const Image& image_;
  std::vector<AddressRange> ranges_;  // by start
  std::map<std::uint32_t, std::uint32_t> words_;
};

}  // namespace finemote::gen::wcet
