#include "generator/image/instruction.hpp"

#include <algorithm>
#include <memory>
#include <string_view>

namespace finemote::gen {
namespace {

/// A decoder that begins outside of an IT block: capstone carries the state of one over from call to call.
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

/// Version 5 of the decoder has names of their own for some forms of VMOV and VMRS.
unsigned id_of(const cs_insn& decoded) {
#if CS_API_MAJOR >= 5
  switch (decoded.id) {
    case ARM_INS_FCONSTS:
    case ARM_INS_FCONSTD:
      return ARM_INS_VMOV;
    case ARM_INS_FMSTAT:
      return ARM_INS_VMRS;
    default:
      break;
  }
#endif
  return decoded.id;
}

Instruction instruction_of(const cs_insn& decoded) {
  const cs_arm& arm = decoded.detail->arm;
  Instruction instruction;
  instruction.address = static_cast<std::uint32_t>(decoded.address);
  instruction.size = decoded.size;
  instruction.id = id_of(decoded);
  instruction.condition = arm.cc;
  instruction.sets_flags = arm.update_flags || instruction.id == ARM_INS_MSR;  // of which capstone does not say so
  instruction.writes_back = arm.writeback;
  instruction.operands.assign(arm.operands, arm.operands + arm.op_count);
  instruction.text = std::string(decoded.mnemonic) + " " + decoded.op_str;
  return instruction;
}

bool is_double(int reg) { return reg >= ARM_REG_D0 && reg <= ARM_REG_D31; }

/// `vmov s13, r3`: what is no register of the FPU is only read.
bool moves_to_fpu(const Instruction& instruction) {
  return instruction.id == ARM_INS_VMOV && !instruction.operands.empty() &&
         instruction.operands[0].type == ARM_OP_REG && is_of_fpu(instruction.operands[0].reg);
}

bool is_call(const Instruction& i) { return i.id == ARM_INS_BL || i.id == ARM_INS_BLX; }

/// Instructions whose operands are all read.
bool only_reads(unsigned id) {
  switch (id) {
    case ARM_INS_CMP:
    case ARM_INS_CMN:
    case ARM_INS_TST:
    case ARM_INS_TEQ:
    case ARM_INS_PUSH:
    case ARM_INS_STR:
    case ARM_INS_STRB:
    case ARM_INS_STRH:
    case ARM_INS_STRD:
    case ARM_INS_B:
    case ARM_INS_BX:
    case ARM_INS_CBZ:
    case ARM_INS_CBNZ:
    case ARM_INS_TBB:
    case ARM_INS_TBH:
      return true;
    default:
      return false;
  }
}

/// How many of its first operands it writes. All, unless the architecture says that the others are only read: then
/// `sdiv r5, r2, r0` leaves r0, which may count a loop.
std::size_t written_operands(const Instruction& i) {
  switch (i.id) {
    case ARM_INS_ADC:
    case ARM_INS_SBC:
    case ARM_INS_ORN:
    case ARM_INS_LSL:
    case ARM_INS_LSR:
    case ARM_INS_ASR:
    case ARM_INS_ROR:
    case ARM_INS_MUL:
    case ARM_INS_MLA:
    case ARM_INS_MLS:
    case ARM_INS_SDIV:
    case ARM_INS_UDIV:
    case ARM_INS_RBIT:
    case ARM_INS_REV:
    case ARM_INS_REV16:
    case ARM_INS_REVSH:
    case ARM_INS_SSAT:
    case ARM_INS_USAT:
    case ARM_INS_SXTAB:
    case ARM_INS_SXTAH:
    case ARM_INS_UXTAB:
    case ARM_INS_UXTAH:
    case ARM_INS_SMULBB:
    case ARM_INS_SMLABB:
    case ARM_INS_SMMUL:
      return 1;
    case ARM_INS_UMULL:
    case ARM_INS_SMULL:
    case ARM_INS_UMLAL:
    case ARM_INS_SMLAL:
      return 2;
    default:
      return i.operands.size();
  }
}

}  // namespace

bool is_of_fpu(int reg) { return is_double(reg) || (reg >= ARM_REG_S0 && reg <= ARM_REG_S31); }

const cs_arm_op* Instruction::memory() const {
  const auto found =
      std::find_if(operands.begin(), operands.end(), [](const cs_arm_op& o) { return o.type == ARM_OP_MEM; });
  return found == operands.end() ? nullptr : &*found;
}

std::uint32_t Instruction::words_from(std::size_t first) const {
  std::uint32_t words = 0;
  for (std::size_t i = first; i < operands.size(); ++i) {
    if (operands[i].type == ARM_OP_REG) words += is_double(operands[i].reg) ? 2 : 1;
  }
  return words;
}

bool may_write(const Instruction& instruction, int reg) {
  if (!instruction.is_known()) return true;
  if (is_call(instruction)) return (reg >= ARM_REG_R0 && reg <= ARM_REG_R3) || reg == ARM_REG_R12 || reg == ARM_REG_LR;
  const cs_arm_op* memory = instruction.memory();
  if (instruction.writes_back && memory != nullptr && memory->mem.base == reg) return true;
  if (only_reads(instruction.id)) return false;
  if (moves_to_fpu(instruction) && !is_of_fpu(reg)) return false;
  const auto read = instruction.operands.begin() +
                    static_cast<std::ptrdiff_t>(std::min(written_operands(instruction), instruction.operands.size()));
  return std::any_of(instruction.operands.begin(), read,
                     [&](const cs_arm_op& o) { return o.type == ARM_OP_REG && o.reg == reg; });
}

std::vector<Instruction> decode(std::uint32_t begin, std::string_view bytes) {
  const Capstone capstone;
  const auto* code = reinterpret_cast<const std::uint8_t*>(bytes.data());
  std::size_t left = bytes.size();
  std::uint64_t address = begin;
  const std::unique_ptr<cs_insn, void (*)(cs_insn*)> decoded(cs_malloc(capstone.handle()),
                                                             [](cs_insn* i) { cs_free(i, 1); });
  std::vector<Instruction> instructions;
  while (left >= 2) {
    const auto here = static_cast<std::uint32_t>(address);
    if (cs_disasm_iter(capstone.handle(), &code, &left, &address, decoded.get())) {
      instructions.push_back(instruction_of(*decoded));
      continue;
    }
    Instruction unknown;
    unknown.address = here;
    unknown.size = (code[1] & 0xF8U) >= 0xE8U ? 4 : 2;
    const std::size_t taken = std::min<std::size_t>(unknown.size, left);
    instructions.push_back(std::move(unknown));
    code += taken;
    left -= taken;
    address += taken;
  }
  return instructions;
}

}  // namespace finemote::gen
