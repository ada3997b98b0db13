#include "generator/descriptor/mux_select.hpp"

#include <algorithm>
#include <array>

namespace finemote::gen {
namespace {

/// Bit n connects channel n: TI SCPS207, 8.6.2; NXP PCA9546A rev. 6, 6.2.1.
std::uint32_t one_hot(std::uint32_t channel) { return 1U << channel; }

constexpr std::array kFormats{MuxSelect{"one_hot", 8, 1, one_hot}};

}  // namespace

const MuxSelect* find_mux_select(std::string_view name) {
  const auto* found =
      std::find_if(kFormats.begin(), kFormats.end(), [&](const MuxSelect& format) { return name == format.name; });
  return found == kFormats.end() ? nullptr : found;
}

}  // namespace finemote::gen
