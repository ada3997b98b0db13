#include "generator/wcet/masking.hpp"

#include <algorithm>
#include <cctype>
#include <string>

namespace finemote::gen::wcet {
namespace {

std::string in_lower_case(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](char c) { return static_cast<char>(std::tolower(static_cast<unsigned char>(c))); });
  return text;
}

/// `cpsid i`, `msr primask, r0`, `msr basepri, r0` and the like; `cpsie` lets interrupts in.
bool may_mask(const Instruction& i) {
  if (i.id != ARM_INS_CPS && i.id != ARM_INS_MSR) return false;
  const std::string text = in_lower_case(i.text);
  return text.find("cpsid") != std::string::npos || text.find("primask") != std::string::npos ||
         text.find("faultmask") != std::string::npos || text.find("basepri") != std::string::npos;
}

bool has_mark(std::uint32_t place, std::uint32_t mark, const Marks& marks) {
  const auto [first, last] = marks.brackets.equal_range(place);
  return std::any_of(first, last, [&](const auto& bracket) { return bracket.second == mark; });
}

}  // namespace

std::optional<std::uint32_t> masks_by_itself(const ProgramFunction& function, const BasicBlock& block,
                                             const Marks& marks) {
  if (has_mark(block.begin, kMaskedMark, marks) || has_mark(block.end, kMaskedMark + 1, marks)) return std::nullopt;
  const Instruction* i = function.body.at(block.begin);
  for (; i != nullptr && i->address < block.end; i = function.body.at(i->end())) {
    if (may_mask(*i)) return i->address;
  }
  return std::nullopt;
}

}  // namespace finemote::gen::wcet
