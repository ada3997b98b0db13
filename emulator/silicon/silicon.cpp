#include "emulator/silicon/silicon.hpp"

#include <stdexcept>

namespace finemote::emulator {

Silicon::Silicon(const std::vector<Strictness>& ways, std::uint64_t seed) {
  for (const Strictness way : ways) {
    is_[index(way)] = true;
    std::seed_seq sequence{seed, seed >> 32, static_cast<std::uint64_t>(way)};
    engines_[index(way)].seed(sequence);
  }
}

Silicon Silicon::named(const std::vector<std::string>& names, std::uint64_t seed) {
  std::vector<Strictness> ways;
  for (const std::string& name : names) {
    const StrictnessInfo* info = find_strictness(name);
    if (info == nullptr) throw std::invalid_argument("no silicon is '" + name + "'");
    ways.push_back(info->strictness);
  }
  return {ways, seed};
}

std::uint32_t Silicon::draw(Strictness way) {
  const StrictnessInfo& info = strictnesses()[index(way)];
  if (fixed_[index(way)]) return *fixed_[index(way)];
  const std::uint64_t drawn = engines_[index(way)]();
  if (drawn % 4 == 0) return info.least;
  if (drawn % 4 == 1) return info.most;
  return info.least + static_cast<std::uint32_t>((drawn >> 2) % (info.most - info.least + 1));
}

}  // namespace finemote::emulator
