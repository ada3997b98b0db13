#include "generator/image/flow.hpp"

#include <capstone/capstone.h>

#include <algorithm>
#include <map>
#include <memory>
#include <set>

#include <fmt/format.h>

namespace finemote::gen {
namespace {

constexpr std::uint32_t kDepthLimit = 1U << 16;

/// What one instruction does, as far as stack and flow are concerned.
struct Step {
  std::uint32_t size = 2;
  std::int32_t stack = 0;  // bytes pushed (positive) or popped
  bool conditional = false;
  bool falls_through = true;
  std::optional<std::uint32_t> jump;
  std::optional<std::uint32_t> call;
  bool calls_register = false;
  std::vector<std::uint32_t> table;  // targets of a table branch
  std::string problem;
};

class Capstone {
 public:
  Capstone() {
    ok_ = cs_open(CS_ARCH_ARM, static_cast<cs_mode>(CS_MODE_THUMB | CS_MODE_MCLASS), &handle_) == CS_ERR_OK;
    if (ok_) cs_option(handle_, CS_OPT_DETAIL, CS_OPT_ON);
  }
  ~Capstone() {
    if (ok_) cs_close(&handle_);
  }
  Capstone(const Capstone&) = delete;
  Capstone& operator=(const Capstone&) = delete;
  [[nodiscard]] csh handle() const { return handle_; }

 private:
  csh handle_ = 0;
  bool ok_ = false;
};

bool writes(const cs_arm& arm, unsigned first_operand, unsigned reg) {
  for (unsigned i = first_operand; i < arm.op_count; ++i) {
    if (arm.operands[i].type == ARM_OP_REG && static_cast<unsigned>(arm.operands[i].reg) == reg) return true;
  }
  return false;
}

std::int32_t bytes_of_registers(const cs_arm& arm, unsigned first_operand) {
  std::int32_t bytes = 0;
  for (unsigned i = first_operand; i < arm.op_count; ++i) {
    const int reg = arm.operands[i].reg;
    bytes += reg >= ARM_REG_D0 && reg <= ARM_REG_D31 ? 8 : 4;
  }
  return bytes;
}

bool is_register(const cs_arm& arm, unsigned operand, int reg) {
  return operand < arm.op_count && arm.operands[operand].type == ARM_OP_REG && arm.operands[operand].reg == reg;
}

// Constant of `add sp, #n`, `add sp, sp, #n` and the like; none when it is not a constant or another base.
std::optional<std::int32_t> constant_change(const cs_arm& arm) {
  const cs_arm_op& last = arm.operands[arm.op_count - 1];
  if (last.type != ARM_OP_IMM) return std::nullopt;
  if (arm.op_count == 3 && !is_register(arm, 1, ARM_REG_SP)) return std::nullopt;
  return last.imm;
}

void variable_stack(Step& step, const cs_insn& instruction) {
  step.problem =
      fmt::format("'{} {}' changes the stack by an unknown amount", instruction.mnemonic, instruction.op_str);
}

// Loads and stores that move the stack pointer: `str r0, [sp, #-8]!`, `ldr pc, [sp], #4`.
std::int32_t write_back(const cs_arm& arm) {
  if (!arm.writeback) return 0;
  for (unsigned i = 0; i < arm.op_count; ++i) {
    const cs_arm_op& operand = arm.operands[i];
    if (operand.type != ARM_OP_MEM || operand.mem.base != ARM_REG_SP) continue;
    if (operand.mem.disp != 0) return -operand.mem.disp;
    if (i + 1 < arm.op_count && arm.operands[i + 1].type == ARM_OP_IMM) return -arm.operands[i + 1].imm;
  }
  return 0;
}

void stack_change(const cs_insn& instruction, Step& step) {
  const cs_arm& arm = instruction.detail->arm;
  switch (instruction.id) {
    case ARM_INS_PUSH:
    case ARM_INS_VPUSH:
      step.stack = bytes_of_registers(arm, 0);
      return;
    case ARM_INS_POP:
    case ARM_INS_VPOP:
      step.stack = -bytes_of_registers(arm, 0);
      return;
    case ARM_INS_STMDB:
    case ARM_INS_VSTMDB:
      if (is_register(arm, 0, ARM_REG_SP) && arm.writeback) step.stack = bytes_of_registers(arm, 1);
      return;
    case ARM_INS_LDM:
    case ARM_INS_VLDMIA:
      if (is_register(arm, 0, ARM_REG_SP) && arm.writeback) step.stack = -bytes_of_registers(arm, 1);
      return;
    case ARM_INS_SUB:
    case ARM_INS_SUBW:
    case ARM_INS_ADD:
    case ARM_INS_ADDW: {
      if (!is_register(arm, 0, ARM_REG_SP)) return;
      const auto change = constant_change(arm);
      if (!change) return variable_stack(step, instruction);
      step.stack = instruction.id == ARM_INS_SUB || instruction.id == ARM_INS_SUBW ? *change : -*change;
      return;
    }
    case ARM_INS_MOV:
    case ARM_INS_BIC:
    case ARM_INS_AND:
      if (is_register(arm, 0, ARM_REG_SP)) variable_stack(step, instruction);
      return;
    default:
      step.stack = write_back(arm);
  }
}

bool loads_pc(const cs_insn& instruction) {
  const cs_arm& arm = instruction.detail->arm;
  switch (instruction.id) {
    case ARM_INS_POP:
      return writes(arm, 0, ARM_REG_PC);
    case ARM_INS_LDM:
      return writes(arm, 1, ARM_REG_PC);
    default:
      return false;
  }
}

// `ldr.w pc, [r2, r3, lsl #2]`: a table of addresses that follows the instruction.
bool is_word_table(const cs_arm& arm) {
  return arm.op_count == 2 && is_register(arm, 0, ARM_REG_PC) && arm.operands[1].type == ARM_OP_MEM &&
         arm.operands[1].mem.index != ARM_REG_INVALID && arm.operands[1].shift.value == 2;
}

void flow_change(const cs_insn& instruction, Step& step) {
  const cs_arm& arm = instruction.detail->arm;
  const auto target = [&](unsigned operand) { return static_cast<std::uint32_t>(arm.operands[operand].imm) & ~1U; };
  switch (instruction.id) {
    case ARM_INS_B:
      step.jump = target(0);
      step.falls_through = step.conditional;
      return;
    case ARM_INS_CBZ:
    case ARM_INS_CBNZ:
      step.jump = target(1);
      return;
    case ARM_INS_BL:
      step.call = target(0);
      return;
    case ARM_INS_BLX:
      if (arm.operands[0].type == ARM_OP_IMM)
        step.call = target(0);
      else
        step.calls_register = true;
      return;
    case ARM_INS_BX:
      step.calls_register = !is_register(arm, 0, ARM_REG_LR);  // a tail call, else the return
      step.falls_through = step.conditional;
      return;
    case ARM_INS_UDF:
      step.falls_through = false;
      return;
    case ARM_INS_MOV:
    case ARM_INS_LDR:
    case ARM_INS_ADD:
      if (!is_register(arm, 0, ARM_REG_PC)) return;
      step.falls_through = step.conditional;
      if (is_word_table(arm)) return;
      if (instruction.id != ARM_INS_LDR || arm.operands[1].mem.base != ARM_REG_SP) {
        step.problem = fmt::format("'{} {}' jumps to an unknown place", instruction.mnemonic, instruction.op_str);
      }
      return;
    default:
      if (loads_pc(instruction)) step.falls_through = step.conditional;
  }
}

/// All instructions of a function by address, data in between left out.
class Body {
 public:
  Body(const Image& image, std::uint32_t begin, std::uint32_t end) : image_(image), begin_(begin), end_(end) {
    const auto first = std::lower_bound(image.symbols.begin(), image.symbols.end(), begin,
                                        [](const ImageSymbol& s, std::uint32_t a) { return s.address < a; });
    bool data = false;
    std::uint32_t from = begin;
    for (auto symbol = first; symbol != image.symbols.end() && symbol->address < end; ++symbol) {
      if (symbol->kind != ImageSymbol::Kind::mapping) continue;
      const bool now_data = symbol->name[1] == 'd';
      if (now_data == data) continue;
      if (!data) decode(from, symbol->address);
      from = symbol->address;
      data = now_data;
    }
    if (!data) decode(from, end);
  }

  [[nodiscard]] bool contains(std::uint32_t address) const { return address >= begin_ && address < end_; }
  [[nodiscard]] const Step* at(std::uint32_t address) const {
    const auto found = steps_.find(address);
    return found == steps_.end() ? nullptr : &found->second;
  }

 private:
  void decode(std::uint32_t from, std::uint32_t to) {
    const std::string_view bytes = image_.bytes(from, to - from);
    const auto* code = reinterpret_cast<const std::uint8_t*>(bytes.data());
    std::size_t left = bytes.size();
    std::uint64_t address = from;
    const std::unique_ptr<cs_insn, void (*)(cs_insn*)> instruction(cs_malloc(capstone_.handle()),
                                                                   [](cs_insn* i) { cs_free(i, 1); });
    while (left >= 2) {
      const auto here = static_cast<std::uint32_t>(address);
      if (cs_disasm_iter(capstone_.handle(), &code, &left, &address, instruction.get())) {
        steps_[here] = step_of(*instruction);
        compared_ = instruction->id == ARM_INS_CMP ? compared_value(*instruction) : compared_;
      } else {  // not an instruction capstone knows: it has no effect on stack or flow
        const std::uint32_t size = (code[1] & 0xF8U) >= 0xE8U ? 4 : 2;
        steps_[here].size = size;
        if (left < size) return;
        code += size;
        left -= size;
        address += size;
      }
    }
  }

  static std::uint32_t compared_value(const cs_insn& instruction) {
    const cs_arm& arm = instruction.detail->arm;
    return arm.op_count == 2 && arm.operands[1].type == ARM_OP_IMM ? static_cast<std::uint32_t>(arm.operands[1].imm)
                                                                   : 0;
  }

  Step step_of(const cs_insn& instruction) {
    Step step;
    step.size = instruction.size;
    step.conditional = instruction.detail->arm.cc != ARM_CC_AL && instruction.detail->arm.cc != ARM_CC_INVALID;
    stack_change(instruction, step);
    flow_change(instruction, step);
    if (instruction.id == ARM_INS_TBB || instruction.id == ARM_INS_TBH) table_branch(instruction, step);
    if (instruction.id == ARM_INS_LDR && is_word_table(instruction.detail->arm)) word_table(instruction, step);
    return step;
  }

  // The compiler compares the index with the last entry just before: `cmp r3, #5; bhi ...; tbb [pc, r3]`.
  void table_branch(const cs_insn& instruction, Step& step) {
    step.falls_through = false;
    if (instruction.detail->arm.operands[0].mem.base != ARM_REG_PC || compared_ > 1024) {
      step.problem = "a branch table of unknown size";
      return;
    }
    const std::uint32_t table = static_cast<std::uint32_t>(instruction.address) + 4;
    const std::uint32_t width = instruction.id == ARM_INS_TBH ? 2 : 1;
    for (std::uint32_t i = 0; i <= compared_; ++i) {
      const std::string_view entry = image_.bytes(table + i * width, width);
      if (entry.size() < width) return;
      const auto low = static_cast<std::uint8_t>(entry[0]);
      const std::uint32_t half =
          width == 2 ? low | static_cast<std::uint32_t>(static_cast<std::uint8_t>(entry[1])) << 8 : low;
      step.table.push_back(table + 2 * half);
    }
  }

  void word_table(const cs_insn& instruction, Step& step) {
    const std::uint32_t table = (static_cast<std::uint32_t>(instruction.address) + instruction.size + 3) & ~3U;
    for (std::uint32_t i = 0; i <= std::min(compared_, 1024U); ++i) {
      const auto target = image_.word(table + 4 * i);
      if (!target || !contains(*target & ~1U)) {
        step.problem = "a branch table of unknown size";
        return;
      }
      step.table.push_back(*target & ~1U);
    }
  }

  const Image& image_;
  std::uint32_t begin_, end_;
  std::map<std::uint32_t, Step> steps_;
  Capstone capstone_;
  std::uint32_t compared_ = 0;
};

/// Walks every path through a body, each address again only when it is reached with a deeper stack.
class Walk {
 public:
  Walk(const Body& body, FunctionFlow& flow) : body_(body), flow_(flow) {}

  void from(std::uint32_t entry) {
    reach(entry, 0);
    while (!open_.empty()) {
      const std::uint32_t address = *open_.begin();
      open_.erase(open_.begin());
      take(address, deepest_[address]);
    }
    for (const auto& [at, call] : calls_) flow_.calls.push_back(call);
  }

 private:
  void reach(std::uint32_t address, std::uint32_t depth) {
    const auto [found, is_new] = deepest_.try_emplace(address, depth);
    if (!is_new && found->second >= depth) return;
    found->second = depth;
    if (depth > kDepthLimit) {
      flow_.problem = "the stack grows in a loop";
      return;
    }
    open_.insert(address);
  }

  void call(std::uint32_t at, std::uint32_t depth, std::optional<std::uint32_t> target) {
    Call& known = calls_[at];
    known = {at, std::max(depth, known.depth), target};
  }

  void take(std::uint32_t address, std::uint32_t depth) {
    const Step* step = body_.at(address);
    if (step == nullptr) return;  // data behind a call that does not return
    if (!step->problem.empty()) flow_.problem = step->problem;
    if (step->call) call(address, depth, step->call);
    if (step->calls_register) call(address, depth, std::nullopt);
    const std::int64_t changed =
        static_cast<std::int64_t>(depth) + (step->conditional && step->stack < 0 ? 0 : step->stack);
    const auto after = static_cast<std::uint32_t>(std::max<std::int64_t>(changed, 0));
    flow_.depth = std::max(flow_.depth, after);
    if (step->jump) {
      if (body_.contains(*step->jump))
        reach(*step->jump, after);
      else
        call(address, after, step->jump);
    }
    for (const std::uint32_t target : step->table) reach(target, after);
    if (step->falls_through && body_.contains(address + step->size)) reach(address + step->size, after);
  }

  const Body& body_;
  FunctionFlow& flow_;
  std::map<std::uint32_t, std::uint32_t> deepest_;
  std::set<std::uint32_t> open_;
  std::map<std::uint32_t, Call> calls_;
};

std::uint32_t end_of(const Image& image, const ImageSymbol& function) {
  if (function.size != 0) return function.address + function.size;
  for (const ImageSymbol& symbol : image.symbols) {
    if (symbol.address > function.address && symbol.kind == ImageSymbol::Kind::function) return symbol.address;
  }
  return function.address + 4096;
}

}  // namespace

FunctionFlow follow(const Image& image, const ImageSymbol& function) {
  FunctionFlow flow;
  const Body body(image, function.address, end_of(image, function));
  Walk(body, flow).from(function.address);
  return flow;
}

}  // namespace finemote::gen
