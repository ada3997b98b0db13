#include "generator/image/branch_table.hpp"

#include <set>

namespace finemote::gen {
namespace {

constexpr std::uint32_t kMostEntries = 1024;

/// The instructions before a place that every way to it passes, the nearest first.
class OnlyWay {
 public:
  OnlyWay(const FunctionBody& body, const Successors& known, std::uint32_t entry, std::uint32_t to)
      : body_(body), known_(known), entry_(entry), at_(to) {}

  struct Step {
    const Instruction* instruction = nullptr;
    bool is_taken = false;  ///< the way leads through its branch
  };
  std::optional<Step> next() {
    if (at_ == entry_ || !seen_.insert(at_).second) return std::nullopt;
    const Successors::Origin* origin = known_.only_origin(at_);
    const Instruction* before = origin == nullptr ? nullptr : body_.at(origin->from);
    if (before == nullptr) return std::nullopt;
    at_ = origin->from;
    return Step{before, origin->is_taken};
  }

 private:
  const FunctionBody& body_;
  const Successors& known_;
  std::uint32_t entry_, at_;
  std::set<std::uint32_t> seen_;
};

bool is_comparison(const Instruction& i) {
  return i.id == ARM_INS_CMP || i.id == ARM_INS_CMN || i.id == ARM_INS_TST || i.id == ARM_INS_TEQ;
}

/// How many values an unsigned index can have after the branch, of the number it was compared with.
std::optional<std::uint64_t> values_behind(const OnlyWay::Step& branch, std::uint32_t compared) {
  if (branch.instruction->id != ARM_INS_B) return std::nullopt;
  const arm_cc condition = branch.instruction->condition;
  const std::uint64_t number = compared;
  if (condition == (branch.is_taken ? ARM_CC_LS : ARM_CC_HI)) return number + 1;
  if (condition == (branch.is_taken ? ARM_CC_LO : ARM_CC_HS)) return number;
  return std::nullopt;
}

bool may_decide(const OnlyWay::Step& step) {
  return values_behind(step, 0).has_value() || values_behind(step, 1).has_value();
}

std::optional<std::uint64_t> number_of_entries(OnlyWay way, int index) {
  std::optional<OnlyWay::Step> branch;
  while (const auto step = way.next()) {
    const Instruction& i = *step->instruction;
    if (branch && i.id == ARM_INS_CMP && !i.is_conditional() && i.has_register(0, index) && i.has_immediate(1))
      return values_behind(*branch, i.immediate(1));
    if (may_write(i, index)) return std::nullopt;
    if (is_comparison(i) || i.sets_flags) branch.reset();
    if (may_decide(*step)) branch = step;
  }
  return std::nullopt;
}

/// What `adr` gives, which the decoder also calls `addw` or `subw` of the program counter: ARMv7-M A7.7.7, that is 4
/// ahead and aligned.
std::optional<std::uint32_t> formed_address(const Instruction& i) {
  const std::uint32_t pc = (i.address + 4) & ~3U;
  if (i.id == ARM_INS_ADR && i.has_immediate(1)) return pc + i.immediate(1);
  if (!i.has_register(1, ARM_REG_PC) || !i.has_immediate(2)) return std::nullopt;
  if (i.id == ARM_INS_ADD || i.id == ARM_INS_ADDW) return pc + i.immediate(2);
  if (i.id == ARM_INS_SUB || i.id == ARM_INS_SUBW) return pc - i.immediate(2);
  return std::nullopt;
}

/// Where the table was put.
std::optional<std::uint32_t> constant_base(OnlyWay way, int base) {
  while (const auto step = way.next()) {
    const Instruction& i = *step->instruction;
    const auto formed = formed_address(i);
    if (formed && i.has_register(0, base) && !i.is_conditional()) return formed;
    if (may_write(i, base)) return std::nullopt;
  }
  return std::nullopt;
}

std::uint32_t number_in(std::string_view bytes) {
  std::uint32_t value = 0;
  for (std::size_t i = bytes.size(); i-- > 0;) value = value << 8 | static_cast<std::uint8_t>(bytes[i]);
  return value;
}

/// Width of an entry, and what it means as an address.
struct Layout {
  std::uint32_t base = 0, width = 0;
  bool is_relative = false;  ///< in halfwords from the base

  [[nodiscard]] std::uint32_t target(std::uint32_t entry) const { return is_relative ? base + 2 * entry : entry & ~1U; }
};

std::optional<Layout> layout_of(const Instruction& table, const OnlyWay& way) {
  const int base = table.memory()->mem.base;
  if (table.id != ARM_INS_LDR) {
    if (base != ARM_REG_PC) return std::nullopt;
    return Layout{table.address + 4, table.id == ARM_INS_TBH ? 2U : 1U, true};
  }
  const auto place = constant_base(way, base);
  return place ? std::optional<Layout>({*place, 4, false}) : std::nullopt;
}

}  // namespace

std::optional<std::vector<std::uint32_t>> table_targets(const Image& image, const FunctionBody& body,
                                                        const Instruction& table, const Successors& known,
                                                        std::uint32_t entry) {
  if (table.memory() == nullptr) return std::nullopt;
  const OnlyWay way(body, known, entry, table.address);
  const auto layout = layout_of(table, way);
  const auto count = number_of_entries(way, table.memory()->mem.index);
  if (!layout || !count || *count > kMostEntries) return std::nullopt;
  std::vector<std::uint32_t> targets;
  for (std::uint32_t i = 0; i < *count; ++i) {
    const std::string_view entry = image.bytes(layout->base + i * layout->width, layout->width);
    if (entry.size() < layout->width) return std::nullopt;
    const std::uint32_t target = layout->target(number_in(entry));
    if (!body.contains(target)) return std::nullopt;
    targets.push_back(target);
  }
  return targets;
}

}  // namespace finemote::gen
