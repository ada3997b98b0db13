#include "generator/wcet/cost_table.hpp"

#include <algorithm>
#include <iterator>

namespace finemote::gen::wcet {
namespace {

using AccessKind = CostTable::Kind;

bool has_double(const Instruction& i) {
  return !i.operands.empty() && i.operands[0].type == ARM_OP_REG && i.operands[0].reg >= ARM_REG_D0 &&
         i.operands[0].reg <= ARM_REG_D31;
}

constexpr Cycles kDrain = 14;  // a store of the slowest memory still in the write buffer
constexpr Cycles kRefill = 3;

/// What does not depend on operands.
constexpr CostTable::Row kRows[] = {
    {ARM_INS_ADC, 1},
    {ARM_INS_ADD, 1},
    {ARM_INS_ADDW, 1},
    {ARM_INS_ADR, 1},
    {ARM_INS_AND, 1},
    {ARM_INS_ASR, 1},
    {ARM_INS_BFC, 1},
    {ARM_INS_BFI, 1},
    {ARM_INS_BIC, 1},
    {ARM_INS_CLREX, 1},
    {ARM_INS_CLZ, 1},
    {ARM_INS_CMN, 1},
    {ARM_INS_CMP, 1},
    {ARM_INS_EOR, 1},
    {ARM_INS_IT, 1},
    {ARM_INS_LSL, 1},
    {ARM_INS_LSR, 1},
    {ARM_INS_MLA, 1},
    {ARM_INS_MLS, 1},
    {ARM_INS_MOV, 1},
    {ARM_INS_MOVT, 1},
    {ARM_INS_MOVW, 1},
    {ARM_INS_MUL, 1},
    {ARM_INS_MVN, 1},
    {ARM_INS_NOP, 1},
    {ARM_INS_ORN, 1},
    {ARM_INS_ORR, 1},
    {ARM_INS_RBIT, 1},
    {ARM_INS_REV, 1},
    {ARM_INS_REV16, 1},
    {ARM_INS_REVSH, 1},
    {ARM_INS_ROR, 1},
    {ARM_INS_RRX, 1},
    {ARM_INS_RSB, 1},
    {ARM_INS_SBC, 1},
    {ARM_INS_SBFX, 1},
    {ARM_INS_SMLAL, 1},
    {ARM_INS_SMULL, 1},
    {ARM_INS_QADD, 1},
    {ARM_INS_QSUB, 1},
    {ARM_INS_QDADD, 1},
    {ARM_INS_QDSUB, 1},
    {ARM_INS_SADD8, 1},
    {ARM_INS_SADD16, 1},
    {ARM_INS_SSUB8, 1},
    {ARM_INS_SSUB16, 1},
    {ARM_INS_SASX, 1},
    {ARM_INS_SSAX, 1},
    {ARM_INS_UADD8, 1},
    {ARM_INS_UADD16, 1},
    {ARM_INS_USUB8, 1},
    {ARM_INS_USUB16, 1},
    {ARM_INS_UASX, 1},
    {ARM_INS_USAX, 1},
    {ARM_INS_SHADD8, 1},
    {ARM_INS_SHADD16, 1},
    {ARM_INS_SHSUB8, 1},
    {ARM_INS_SHSUB16, 1},
    {ARM_INS_SHASX, 1},
    {ARM_INS_SHSAX, 1},
    {ARM_INS_UHADD8, 1},
    {ARM_INS_UHADD16, 1},
    {ARM_INS_UHSUB8, 1},
    {ARM_INS_UHSUB16, 1},
    {ARM_INS_UHASX, 1},
    {ARM_INS_UHSAX, 1},
    {ARM_INS_QADD8, 1},
    {ARM_INS_QADD16, 1},
    {ARM_INS_QSUB8, 1},
    {ARM_INS_QSUB16, 1},
    {ARM_INS_QASX, 1},
    {ARM_INS_QSAX, 1},
    {ARM_INS_UQADD8, 1},
    {ARM_INS_UQADD16, 1},
    {ARM_INS_UQSUB8, 1},
    {ARM_INS_UQSUB16, 1},
    {ARM_INS_UQASX, 1},
    {ARM_INS_UQSAX, 1},
    {ARM_INS_SEL, 1},
    {ARM_INS_SMMUL, 1},
    {ARM_INS_SMMULR, 1},
    {ARM_INS_SMUAD, 1},
    {ARM_INS_SMUADX, 1},
    {ARM_INS_SMUSD, 1},
    {ARM_INS_SMUSDX, 1},
    {ARM_INS_USAD8, 1},
    {ARM_INS_SMMLA, 1},
    {ARM_INS_SMMLAR, 1},
    {ARM_INS_SMMLS, 1},
    {ARM_INS_SMMLSR, 1},
    {ARM_INS_SMLAD, 1},
    {ARM_INS_SMLADX, 1},
    {ARM_INS_SMLSD, 1},
    {ARM_INS_SMLSDX, 1},
    {ARM_INS_SMLALD, 1},
    {ARM_INS_SMLALDX, 1},
    {ARM_INS_SMLSLD, 1},
    {ARM_INS_SMLSLDX, 1},
    {ARM_INS_USADA8, 1},
    {ARM_INS_PKHBT, 1},
    {ARM_INS_PKHTB, 1},
    {ARM_INS_SSAT16, 1},
    {ARM_INS_USAT16, 1},
    {ARM_INS_SXTB16, 1},
    {ARM_INS_UXTB16, 1},
    {ARM_INS_SXTAB16, 1},
    {ARM_INS_UXTAB16, 1},
    {ARM_INS_SMULBB, 1},
    {ARM_INS_SMULBT, 1},
    {ARM_INS_SMULTB, 1},
    {ARM_INS_SMULTT, 1},
    {ARM_INS_SMLABB, 1},
    {ARM_INS_SMLABT, 1},
    {ARM_INS_SMLATB, 1},
    {ARM_INS_SMLATT, 1},
    {ARM_INS_SMLALBB, 1},
    {ARM_INS_SMLALBT, 1},
    {ARM_INS_SMLALTB, 1},
    {ARM_INS_SMLALTT, 1},
    {ARM_INS_SMULWB, 1},
    {ARM_INS_SMULWT, 1},
    {ARM_INS_SMLAWB, 1},
    {ARM_INS_SMLAWT, 1},
    {ARM_INS_SSAT, 1},
    {ARM_INS_SUB, 1},
    {ARM_INS_SUBW, 1},
    {ARM_INS_SXTAB, 1},
    {ARM_INS_SXTAH, 1},
    {ARM_INS_SXTB, 1},
    {ARM_INS_SXTH, 1},
    {ARM_INS_TEQ, 1},
    {ARM_INS_TST, 1},
    {ARM_INS_UBFX, 1},
    {ARM_INS_UMAAL, 1},
    {ARM_INS_UMLAL, 1},
    {ARM_INS_UMULL, 1},
    {ARM_INS_USAT, 1},
    {ARM_INS_UXTAB, 1},
    {ARM_INS_UXTAH, 1},
    {ARM_INS_UXTB, 1},
    {ARM_INS_UXTH, 1},
    {ARM_INS_B, 1},
    {ARM_INS_BL, 1},
    {ARM_INS_BX, 1},
    {ARM_INS_BLX, 1},
    {ARM_INS_CBZ, 1},
    {ARM_INS_CBNZ, 1},
    {ARM_INS_CPS, 2},
    {ARM_INS_MRS, 2},
    {ARM_INS_MSR, 2},
    {ARM_INS_SDIV, 12},
    {ARM_INS_UDIV, 12},
    {ARM_INS_DSB, 1 + kDrain},
    {ARM_INS_DMB, 1 + kDrain},
    {ARM_INS_ISB, 1 + kRefill},
    {ARM_INS_TBB, 4},
    {ARM_INS_TBH, 4},
    {ARM_INS_VADD, 2},
    {ARM_INS_VSUB, 2},
    {ARM_INS_VMUL, 2},
    {ARM_INS_VNMUL, 2},
    {ARM_INS_VCVT, 2},
    {ARM_INS_VCVTR, 2},
    {ARM_INS_VABS, 2},
    {ARM_INS_VNEG, 2},
    {ARM_INS_VCMP, 2},
    {ARM_INS_VCMPE, 2},
    {ARM_INS_VMOV, 2},
    {ARM_INS_VMRS, 2},
    {ARM_INS_VMSR, 2},
    {ARM_INS_VMLA, 4},
    {ARM_INS_VMLS, 4},
    {ARM_INS_VNMLA, 4},
    {ARM_INS_VNMLS, 4},
    {ARM_INS_VFMA, 4},
    {ARM_INS_VFMS, 4},
    {ARM_INS_VFNMA, 4},
    {ARM_INS_VFNMS, 4},
    {ARM_INS_VDIV, 15},
    {ARM_INS_VSQRT, 15},
};

CostTable documented() {
  CostTable table;
  table.fixed.assign(std::begin(kRows), std::end(kRows));
  return table;
}

/// How an instruction touches memory; none: it does not.
std::optional<AccessKind> kind_of(const Instruction& i) {
  switch (i.id) {
    case ARM_INS_LDR:
    case ARM_INS_LDRB:
    case ARM_INS_LDRH:
    case ARM_INS_LDRSB:
    case ARM_INS_LDRSH:
    case ARM_INS_STR:
    case ARM_INS_STRB:
    case ARM_INS_STRH:
      return AccessKind::single;
    case ARM_INS_LDREX:
    case ARM_INS_LDREXB:
    case ARM_INS_LDREXH:
    case ARM_INS_STREX:
    case ARM_INS_STREXB:
    case ARM_INS_STREXH:
      return AccessKind::exclusive;
    case ARM_INS_LDRD:
    case ARM_INS_STRD:
      return AccessKind::two;
    case ARM_INS_PUSH:
    case ARM_INS_POP:
    case ARM_INS_VPUSH:
    case ARM_INS_VPOP:
      return AccessKind::stack;
    case ARM_INS_LDM:
    case ARM_INS_LDMDB:
    case ARM_INS_STM:
    case ARM_INS_STMDB:
    case ARM_INS_VLDMIA:
    case ARM_INS_VLDMDB:
    case ARM_INS_VSTMIA:
    case ARM_INS_VSTMDB:
      return AccessKind::several;
    case ARM_INS_VLDR:
    case ARM_INS_VSTR:
      return has_double(i) ? AccessKind::float_two : AccessKind::float_single;
    default:
      return std::nullopt;
  }
}

Cycles of_memory(const Instruction& i, AccessKind kind, const CostTable& table) {
  switch (kind) {
    case AccessKind::single:
      return table.single;
    case AccessKind::exclusive:
      return table.exclusive;
    case AccessKind::two:
      return table.two;
    case AccessKind::float_single:
      return table.float_single;
    case AccessKind::float_two:
      return table.float_two;
    case AccessKind::stack:
      return table.several + table.word * i.words_from(0);
    case AccessKind::several:
      break;
  }
  return table.several + table.word * i.words_from(1);
}

}  // namespace

const CostTable& documented_costs() {
  static const CostTable table = documented();
  return table;
}

std::optional<Cycles> longest_time(const Instruction& i, const CostTable& table) {
  const auto row =
      std::find_if(table.fixed.begin(), table.fixed.end(), [&](const CostTable::Row& r) { return r.id == i.id; });
  if (row != table.fixed.end()) return row->cycles;
  const auto kind = kind_of(i);
  return kind ? std::optional(of_memory(i, *kind, table)) : std::nullopt;
}

}  // namespace finemote::gen::wcet
