#include "generator/image/successors.hpp"

#include <algorithm>

namespace finemote::gen {

bool Successors::add(std::uint32_t from, Successor successor) {
  std::vector<Successor>& known = successors_[from];
  const bool is_known = std::any_of(known.begin(), known.end(), [&](const Successor& s) {
    return s.to == successor.to && s.is_taken == successor.is_taken;
  });
  if (is_known) return false;
  known.push_back(successor);
  origins_[successor.to].push_back({from, successor.is_taken});
  return true;
}

const std::vector<Successor>& Successors::of(std::uint32_t address) const {
  static const std::vector<Successor> kNone;
  const auto found = successors_.find(address);
  return found == successors_.end() ? kNone : found->second;
}

const Successors::Origin* Successors::only_origin(std::uint32_t address) const {
  const auto found = origins_.find(address);
  return found == origins_.end() || found->second.size() != 1 ? nullptr : &found->second.front();
}

}  // namespace finemote::gen
