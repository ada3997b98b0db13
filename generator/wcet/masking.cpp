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
bool may_mask(const std::string& text) {
  return text.find("cpsid") != std::string::npos || text.find("primask") != std::string::npos ||
         text.find("faultmask") != std::string::npos || text.find("basepri") != std::string::npos;
}

/// Or the register that tells which of them counts: ARMv7-M B1.4.4.
bool names_stack_pointer(const std::string& text) {
  return text.find("msp") != std::string::npos || text.find("psp") != std::string::npos ||
         text.find("control") != std::string::npos;
}

bool has_mark(std::uint32_t place, std::uint32_t mark, const Marks& marks) {
  const auto [first, last] = marks.brackets.equal_range(place);
  return std::any_of(first, last, [&](const auto& bracket) { return bracket.second == mark; });
}

}  // namespace

std::optional<std::uint32_t> masks_by_itself(const ProgramFunction& function, const BasicBlock& block,
                                             const Marks& marks) {
  const bool begins = has_mark(block.begin, kMaskedMark, marks), ends = has_mark(block.end, kMaskedMark + 1, marks);
  const Instruction* i = function.body.at(block.begin);
  for (; i != nullptr && i->address < block.end; i = function.body.at(i->end())) {
    if (i->id != ARM_INS_CPS && i->id != ARM_INS_MSR) continue;
    const std::string text = in_lower_case(i->text);
    const bool is_of_section = (begins && text == "cpsid i") || (ends && text.rfind("msr primask,", 0) == 0);
    if (may_mask(text) && !is_of_section) return i->address;
  }
  return std::nullopt;
}

std::optional<std::uint32_t> sets_stack_pointer(const ProgramFunction& function, const BasicBlock& block) {
  const Instruction* i = function.body.at(block.begin);
  for (; i != nullptr && i->address < block.end; i = function.body.at(i->end())) {
    if (i->id == ARM_INS_MSR && names_stack_pointer(in_lower_case(i->text))) return i->address;
  }
  return std::nullopt;
}

}  // namespace finemote::gen::wcet
