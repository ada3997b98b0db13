// One file because the loop over instructions is fast only with all it does at every instruction inside of it; what is
// rarer stands in files of its own.
#include "emulator/core/interpreter.hpp"

#include "emulator/core/interlock.hpp"

#include <array>
#include <bit>

namespace finemote::emulator {
namespace {

/// AddWithCarry of the manual, D6.3.2; the overflow is bit 31 of `v`.
inline std::uint32_t add(std::uint32_t x, std::uint32_t y, std::uint32_t carry_in, std::uint32_t& c, std::uint32_t& v) {
  const std::uint64_t wide = std::uint64_t{x} + y + carry_in;
  const auto result = static_cast<std::uint32_t>(wide);
  c = static_cast<std::uint32_t>(wide >> 32);
  v = (x ^ result) & (y ^ result);
  return result;
}

inline std::uint32_t extended(std::uint32_t value, unsigned mode) {
  if ((mode & Extend::kPair) != 0) {
    if ((mode & Extend::kUnsigned) != 0) return value & 0x00FF00FF;
    const auto low = static_cast<std::uint32_t>(static_cast<std::int8_t>(value)),
               high = static_cast<std::uint32_t>(static_cast<std::int8_t>(value >> 16));
    return (low & 0xFFFF) | high << 16;
  }
  switch (mode) {
    case 0:
      return static_cast<std::uint32_t>(static_cast<std::int16_t>(value));
    case Extend::kUnsigned:
      return value & 0xFFFF;
    case Extend::kByte:
      return static_cast<std::uint32_t>(static_cast<std::int8_t>(value));
    default:
      return value & 0xFF;
  }
}

// What data processing makes of its operands.
constexpr auto kAnd = [](std::uint32_t x, std::uint32_t y) { return x & y; };
constexpr auto kClear = [](std::uint32_t x, std::uint32_t y) { return x & ~y; };
constexpr auto kOr = [](std::uint32_t x, std::uint32_t y) { return x | y; };
constexpr auto kOrNot = [](std::uint32_t x, std::uint32_t y) { return x | ~y; };
constexpr auto kExclusiveOr = [](std::uint32_t x, std::uint32_t y) { return x ^ y; };
constexpr auto kMove = [](std::uint32_t, std::uint32_t y) { return y; };
constexpr auto kMoveNot = [](std::uint32_t, std::uint32_t y) { return ~y; };

/// Differences are sums: x - y = x + ~y + 1.
struct Sum {
  std::uint32_t x, y, carry;
};
constexpr auto kAdd = [](std::uint32_t x, std::uint32_t y, std::uint32_t) { return Sum{x, y, 0}; };
constexpr auto kAddCarry = [](std::uint32_t x, std::uint32_t y, std::uint32_t carry) { return Sum{x, y, carry}; };
constexpr auto kSubtract = [](std::uint32_t x, std::uint32_t y, std::uint32_t) { return Sum{x, ~y, 1}; };
constexpr auto kSubtractCarry = [](std::uint32_t x, std::uint32_t y, std::uint32_t carry) { return Sum{x, ~y, carry}; };
constexpr auto kSubtractFrom = [](std::uint32_t x, std::uint32_t y, std::uint32_t) { return Sum{y, ~x, 1}; };

/// The IT state after one instruction: D6.7.37, ITAdvance.
constexpr std::uint32_t advanced(std::uint32_t it) { return (it & 7) == 0 ? 0 : (it & 0xE0) | (it << 1 & 0x1F); }

/// The conditions of A7.3.1: for each, a bit for every value of N, Z, C and V (8, 4, 2, 1).
constexpr std::array<std::uint16_t, 16> kHolds = [] {
  std::array<std::uint16_t, 16> holds{};
  for (unsigned nzcv = 0; nzcv < 16; ++nzcv) {
    const bool n = (nzcv & 8) != 0, z = (nzcv & 4) != 0, c = (nzcv & 2) != 0, v = (nzcv & 1) != 0;
    const bool even[] = {z, c, n, v, c && !z, n == v, !z && n == v, true};
    for (unsigned code = 0; code < 16; ++code) {
      if (code >= 14 || even[code / 2] != (code % 2 != 0)) holds[code] |= static_cast<std::uint16_t>(1U << nzcv);
    }
  }
  return holds;
}();

inline std::uint32_t reverse_bits(std::uint32_t x) {
  x = (x >> 1 & 0x55555555U) | (x & 0x55555555U) << 1;
  x = (x >> 2 & 0x33333333U) | (x & 0x33333333U) << 2;
  x = (x >> 4 & 0x0F0F0F0FU) | (x & 0x0F0F0F0FU) << 4;
  return __builtin_bswap32(x);
}

}  // namespace

/// @return null where no instruction can be
inline const Operation* Interpreter::operation_at(std::uint32_t address, Operation& outside_image) {
  if (const std::uint32_t n = (address - Memories::kFlashBase) / 2; n < flash_count_) return known_ + n;
  if (const std::uint32_t n = address / 2; n < low_count_)
    return low_[n].kind == Opcode::unknown ? take_apart_ram(n) : low_ + n;
  if (!outside_.may_execute(address) || take_apart_at(address, outside_image) == nullptr) return nullptr;
  outside_image.info.flags |= InstructionInfo::kAlone;
  return &outside_image;
}

/// Charges what lies between the last instruction and the one at `address` that does not follow it.
template <CostModel Cost>
inline void Interpreter::arrive(std::uint32_t address, std::uint32_t expected) {
  if (address == expected) return;
  if (address > expected && address <= pace.it_end && expected > pace.it_begin) {
    pass_skipped(expected, address);
  } else if constexpr (Cost != CostModel::qemu) {
    pace.time += kRefillCycles * pace.cycle;
  }
}

/// A jump to itself waits for an interrupt: all its iterations until `Pace::stop_at` are charged at once.
template <CostModel Cost>
void Interpreter::wait_in_place(unsigned cycles) {
  if (pace.time >= pace.stop_at) return;
  const Time turn = Cost == CostModel::qemu ? Pace::kQemuInstruction : (cycles + kRefillCycles) * pace.cycle;
  const Time turns = (pace.stop_at - pace.time + turn - 1) / turn;
  pace.time += turns * turn;
  pace.instructions += turns;
  pace.waits += turns;
  pace.waited += turns * turn;
}

/// Makes the floating-point context active. @return false: the FPU is off
inline bool Interpreter::begin_float() {
  if (!fpu_on) return false;
  if (!fp_active) registers.fpscr = 0;  // a new context takes FPDSCR, of which nothing else is modelled: B1.5.7
  fp_active = true;
  if (lazy_frame) {
    const Time begun = pace.time;
    pace.charge(kLazyCycles);
    outside_.saved_float(pace.time, pace.time - begun);
  }
  lazy_frame = false;
  return true;
}

/// Conditional instructions whose condition failed take a cycle each, charged with the one after them.
void Interpreter::pass_skipped(std::uint32_t from, std::uint32_t address) {
  Operation scratch;
  for (std::uint32_t at = from; at < address;) {
    const Operation* skipped = operation_at(at, scratch);
    if (skipped == nullptr) return;
    pace.time += pace.cost == CostModel::qemu ? Pace::kQemuInstruction : pace.cycle;
    ++pace.instructions;
    at += skipped->info.bytes;
  }
}

/// A7.3.1.
inline bool Interpreter::condition(unsigned code) const {
  const Registers& g = registers;
  const unsigned nzcv = g.n >> 31 << 3 | static_cast<unsigned>(g.z == 0) << 2 | g.c << 1 | g.v >> 31;
  return (kHolds[code] >> nzcv & 1) != 0;
}

void Interpreter::begin_it(std::uint32_t address, std::uint32_t state) {
  registers.it = state;
  pace.it_begin = address;
  pace.it_end = address + 2;
  Operation scratch;
  for (int left = 4 - std::countr_zero(state & 0xF); left > 0; --left) {
    const Operation* one = operation_at(pace.it_end, scratch);
    if (one == nullptr) return;
    pace.it_end += one->info.bytes;
  }
}

bool Interpreter::refuse_unaligned(std::uint32_t address) {
  bad_address_ = address;
  is_unaligned_ = true;
  return false;
}

bool Interpreter::load_elsewhere(std::uint32_t address, unsigned bytes, std::uint32_t& value) {
  if (traps_unaligned && address % bytes != 0) return refuse_unaligned(address);
  bad_address_ = address;
  if (address >= Memories::kRamBase) return outside_.read(address, bytes, value);
  const std::uint8_t* from = nullptr;
  if (const std::uint32_t at = address - Memories::kSystemBase; at <= Memories::kSystemBytes - bytes)
    from = memories_.system + at;
  if (from == nullptr) return false;
  value = 0;
  std::memcpy(&value, from, bytes);
  return true;
}

bool Interpreter::store_elsewhere(std::uint32_t address, unsigned bytes, std::uint32_t value) {
  if (traps_unaligned && address % bytes != 0) return refuse_unaligned(address);
  bad_address_ = address;
  return outside_.write(address, bytes, bytes == 4 ? value : value & ((1U << (8 * bytes)) - 1));
}

/// A7.4.2, Shift_C, by a constant; `carry` is that of the flags before, and of the shifter after.
std::uint32_t Interpreter::shifted(const Operation& o, std::uint32_t& carry) const {
  const std::uint32_t value = registers.r[o.m];
  if (o.shift == Shift::rrx) {
    const std::uint32_t result = carry << 31 | value >> 1;
    carry = value & 1;
    return result;
  }
  return shift_by(o.shift, value, o.amount, carry);
}

inline std::uint32_t Interpreter::shift_by(Shift how, std::uint32_t value, std::uint32_t amount,
                                           std::uint32_t& carry) const {
  if (amount == 0) return value;
  switch (how) {
    case Shift::lsl:
      carry = amount <= 32 ? (amount == 32 ? value & 1 : value >> (32 - amount) & 1) : 0;
      return amount < 32 ? value << amount : 0;
    case Shift::lsr:
      carry = amount <= 32 ? value >> (amount - 1) & 1 : 0;
      return amount < 32 ? value >> amount : 0;
    case Shift::asr: {
      const unsigned by = amount < 32 ? amount : 31;
      carry = amount < 32 ? value >> (amount - 1) & 1 : value >> 31;
      return static_cast<std::uint32_t>(static_cast<std::int32_t>(value) >> by);
    }
    default: {
      const std::uint32_t result = std::rotr(value, static_cast<int>(amount & 31));
      carry = result >> 31;
      return result;
    }
  }
}

/// The last operand of data processing, by its form, and the carry that comes with it.
template <Interpreter::Form Last>
[[gnu::always_inline]] inline Interpreter::Operand Interpreter::last_operand(const Operation& o) const {
  if constexpr (Last == Form::imm) return {o.imm, o.mode != 0 ? o.imm >> 31 : registers.c};
  if constexpr (Last == Form::reg) return {registers.r[o.m], registers.c};
  std::uint32_t carry = registers.c;
  const std::uint32_t y = shifted(o, carry);
  return {y, carry};
}

template <Interpreter::Form Last, auto Do>
[[gnu::always_inline]] inline void Interpreter::logic(const Operation& o) {
  registers.r[o.d] = Do(registers.r[o.n], last_operand<Last>(o).value);
}

template <Interpreter::Form Last, auto Do>
[[gnu::always_inline]] inline void Interpreter::test(const Operation& o) {
  const Operand y = last_operand<Last>(o);
  registers.set_nz(Do(registers.r[o.n], y.value));
  registers.c = y.carry;
}

template <Interpreter::Form Last, auto Do>
[[gnu::always_inline]] inline void Interpreter::logic_flags(const Operation& o) {
  const Operand y = last_operand<Last>(o);
  const std::uint32_t result = Do(registers.r[o.n], y.value);
  registers.r[o.d] = result;
  registers.set_nz(result);
  registers.c = y.carry;
}

template <Interpreter::Form Last, auto Terms>
[[gnu::always_inline]] inline void Interpreter::sum(const Operation& o) {
  const Sum s = Terms(registers.r[o.n], last_operand<Last>(o).value, registers.c);
  registers.r[o.d] = s.x + s.y + s.carry;
}

template <Interpreter::Form Last, auto Terms>
[[gnu::always_inline]] inline void Interpreter::compare(const Operation& o) {
  const Sum s = Terms(registers.r[o.n], last_operand<Last>(o).value, registers.c);
  registers.set_nz(add(s.x, s.y, s.carry, registers.c, registers.v));
}

template <Interpreter::Form Last, auto Terms>
[[gnu::always_inline]] inline void Interpreter::sum_flags(const Operation& o) {
  const Sum s = Terms(registers.r[o.n], last_operand<Last>(o).value, registers.c);
  const std::uint32_t result = add(s.x, s.y, s.carry, registers.c, registers.v);
  registers.r[o.d] = result;
  registers.set_nz(result);
}

Halt Interpreter::run() {
  const bool plain = pace.cost == CostModel::cortex_m4 && pace.flash == FlashModel::hit;
  return plain                          ? run_at_cost<CostModel::cortex_m4, FlashModel::hit>()
         : pace.cost == CostModel::qemu ? run_at_cost<CostModel::qemu, FlashModel::hit>()
                                        : run_at_cost<CostModel::cortex_m4, FlashModel::miss_always>();
}

/// The loop, made for each choice of costs that matters, and with or without tags.
template <CostModel Cost, FlashModel Flash, bool Tagged>
Halt Interpreter::run_with() {
  Registers& g = registers;
  std::uint32_t* const r = g.r.data();
  std::uint32_t next = g.next;
  std::uint32_t expected = pace.expected;  // where `next` would be without a jump
  const auto stop_at = [&](Halt why, std::uint32_t at, std::uint32_t follows) __attribute__((always_inline)) {
    g.next = at;
    pace.expected = follows;
    return why;
  };
  for (;;) {  // at the target of a jump, and where it begins
    const Operation* here = operation_at(next, elsewhere_);
    if (here == nullptr) return stop_at(Halt::no_instruction, next, expected);
    const std::uint32_t it = g.it;
    if (it != 0) {
      g.it = advanced(it);
      if (!condition(it >> 4)) {
        next += here->info.bytes;
        continue;
      }
      conditional_ = inside_it(*here);
      here = &conditional_;
    }
    std::uint32_t address = next;
    r[15] = address + 4;
    if (pace.time >= pace.stop_at && outside_.stops(address)) {
      g.it = it;
      return stop_at(Halt::asked, address, expected);
    }
    arrive<Cost>(address, expected);
    const bool is_conditional = it != 0;
    for (;;) {  // straight on
      const Operation& o = *here;
      pace.account<Cost, Flash>(address, o.info.cycles);
      if constexpr (Tagged) tags_.follow(o, g, is_conditional, pace.time);
      expected = address + o.info.bytes;
      const auto stop = [&](Halt why, std::uint32_t at) __attribute__((always_inline)) {
        return stop_at(why, at, expected);
      };
      // The instruction has not happened.
      const auto stop_again = [&](Halt why) __attribute__((always_inline)) {
        g.it = is_conditional ? it : 0;
        return stop(why, address);
      };
      const auto bad_access = [&]() __attribute__((always_inline)) { return stop_again(Halt::bad_access); };

      // A jump to a value that tells the state: BX, and loads of the PC.
      const auto interwork = [&](std::uint32_t target) __attribute__((always_inline)) {
        next = target & ~1U;
        if (target >= 0xFFFFFF00U) return stop(Halt::exception_return, target);
        return (target & 1) == 0 ? stop(Halt::bad_state, target) : Halt::asked;
      };

      switch (o.kind) {
        // clang-format off
        case Opcode::and_imm: logic<Form::imm, kAnd>(o); break;
        case Opcode::and_reg: logic<Form::reg, kAnd>(o); break;
        case Opcode::and_shifted: logic<Form::shifted, kAnd>(o); break;
        case Opcode::ands_imm: logic_flags<Form::imm, kAnd>(o); break;
        case Opcode::ands_reg: logic_flags<Form::reg, kAnd>(o); break;
        case Opcode::ands_shifted: logic_flags<Form::shifted, kAnd>(o); break;
        case Opcode::bic_imm: logic<Form::imm, kClear>(o); break;
        case Opcode::bic_reg: logic<Form::reg, kClear>(o); break;
        case Opcode::bic_shifted: logic<Form::shifted, kClear>(o); break;
        case Opcode::bics_imm: logic_flags<Form::imm, kClear>(o); break;
        case Opcode::bics_reg: logic_flags<Form::reg, kClear>(o); break;
        case Opcode::bics_shifted: logic_flags<Form::shifted, kClear>(o); break;
        case Opcode::orr_imm: logic<Form::imm, kOr>(o); break;
        case Opcode::orr_reg: logic<Form::reg, kOr>(o); break;
        case Opcode::orr_shifted: logic<Form::shifted, kOr>(o); break;
        case Opcode::orrs_imm: logic_flags<Form::imm, kOr>(o); break;
        case Opcode::orrs_reg: logic_flags<Form::reg, kOr>(o); break;
        case Opcode::orrs_shifted: logic_flags<Form::shifted, kOr>(o); break;
        case Opcode::orn_imm: logic<Form::imm, kOrNot>(o); break;
        case Opcode::orn_reg: logic<Form::reg, kOrNot>(o); break;
        case Opcode::orn_shifted: logic<Form::shifted, kOrNot>(o); break;
        case Opcode::orns_imm: logic_flags<Form::imm, kOrNot>(o); break;
        case Opcode::orns_reg: logic_flags<Form::reg, kOrNot>(o); break;
        case Opcode::orns_shifted: logic_flags<Form::shifted, kOrNot>(o); break;
        case Opcode::eor_imm: logic<Form::imm, kExclusiveOr>(o); break;
        case Opcode::eor_reg: logic<Form::reg, kExclusiveOr>(o); break;
        case Opcode::eor_shifted: logic<Form::shifted, kExclusiveOr>(o); break;
        case Opcode::eors_imm: logic_flags<Form::imm, kExclusiveOr>(o); break;
        case Opcode::eors_reg: logic_flags<Form::reg, kExclusiveOr>(o); break;
        case Opcode::eors_shifted: logic_flags<Form::shifted, kExclusiveOr>(o); break;
        case Opcode::mov_imm: logic<Form::imm, kMove>(o); break;
        case Opcode::mov_reg: logic<Form::reg, kMove>(o); break;
        case Opcode::mov_shifted: logic<Form::shifted, kMove>(o); break;
        case Opcode::movs_imm: logic_flags<Form::imm, kMove>(o); break;
        case Opcode::movs_reg: logic_flags<Form::reg, kMove>(o); break;
        case Opcode::movs_shifted: logic_flags<Form::shifted, kMove>(o); break;
        case Opcode::mvn_imm: logic<Form::imm, kMoveNot>(o); break;
        case Opcode::mvn_reg: logic<Form::reg, kMoveNot>(o); break;
        case Opcode::mvn_shifted: logic<Form::shifted, kMoveNot>(o); break;
        case Opcode::mvns_imm: logic_flags<Form::imm, kMoveNot>(o); break;
        case Opcode::mvns_reg: logic_flags<Form::reg, kMoveNot>(o); break;
        case Opcode::mvns_shifted: logic_flags<Form::shifted, kMoveNot>(o); break;
        case Opcode::tst_imm: test<Form::imm, kAnd>(o); break;
        case Opcode::tst_reg: test<Form::reg, kAnd>(o); break;
        case Opcode::tst_shifted: test<Form::shifted, kAnd>(o); break;
        case Opcode::teq_imm: test<Form::imm, kExclusiveOr>(o); break;
        case Opcode::teq_reg: test<Form::reg, kExclusiveOr>(o); break;
        case Opcode::teq_shifted: test<Form::shifted, kExclusiveOr>(o); break;
        case Opcode::cmp_imm: compare<Form::imm, kSubtract>(o); break;
        case Opcode::cmp_reg: compare<Form::reg, kSubtract>(o); break;
        case Opcode::cmp_shifted: compare<Form::shifted, kSubtract>(o); break;
        case Opcode::cmn_imm: compare<Form::imm, kAdd>(o); break;
        case Opcode::cmn_reg: compare<Form::reg, kAdd>(o); break;
        case Opcode::cmn_shifted: compare<Form::shifted, kAdd>(o); break;
        case Opcode::add_imm: sum<Form::imm, kAdd>(o); break;
        case Opcode::add_reg: sum<Form::reg, kAdd>(o); break;
        case Opcode::add_shifted: sum<Form::shifted, kAdd>(o); break;
        case Opcode::adds_imm: sum_flags<Form::imm, kAdd>(o); break;
        case Opcode::adds_reg: sum_flags<Form::reg, kAdd>(o); break;
        case Opcode::adds_shifted: sum_flags<Form::shifted, kAdd>(o); break;
        case Opcode::adc_imm: sum<Form::imm, kAddCarry>(o); break;
        case Opcode::adc_reg: sum<Form::reg, kAddCarry>(o); break;
        case Opcode::adc_shifted: sum<Form::shifted, kAddCarry>(o); break;
        case Opcode::adcs_imm: sum_flags<Form::imm, kAddCarry>(o); break;
        case Opcode::adcs_reg: sum_flags<Form::reg, kAddCarry>(o); break;
        case Opcode::adcs_shifted: sum_flags<Form::shifted, kAddCarry>(o); break;
        case Opcode::sub_imm: sum<Form::imm, kSubtract>(o); break;
        case Opcode::sub_reg: sum<Form::reg, kSubtract>(o); break;
        case Opcode::sub_shifted: sum<Form::shifted, kSubtract>(o); break;
        case Opcode::subs_imm: sum_flags<Form::imm, kSubtract>(o); break;
        case Opcode::subs_reg: sum_flags<Form::reg, kSubtract>(o); break;
        case Opcode::subs_shifted: sum_flags<Form::shifted, kSubtract>(o); break;
        case Opcode::sbc_imm: sum<Form::imm, kSubtractCarry>(o); break;
        case Opcode::sbc_reg: sum<Form::reg, kSubtractCarry>(o); break;
        case Opcode::sbc_shifted: sum<Form::shifted, kSubtractCarry>(o); break;
        case Opcode::sbcs_imm: sum_flags<Form::imm, kSubtractCarry>(o); break;
        case Opcode::sbcs_reg: sum_flags<Form::reg, kSubtractCarry>(o); break;
        case Opcode::sbcs_shifted: sum_flags<Form::shifted, kSubtractCarry>(o); break;
        case Opcode::rsb_imm: sum<Form::imm, kSubtractFrom>(o); break;
        case Opcode::rsb_reg: sum<Form::reg, kSubtractFrom>(o); break;
        case Opcode::rsb_shifted: sum<Form::shifted, kSubtractFrom>(o); break;
        case Opcode::rsbs_imm: sum_flags<Form::imm, kSubtractFrom>(o); break;
        case Opcode::rsbs_reg: sum_flags<Form::reg, kSubtractFrom>(o); break;
        case Opcode::rsbs_shifted: sum_flags<Form::shifted, kSubtractFrom>(o); break;
        case Opcode::ldr_imm: if (!transfer<Access::ldr>(at_offset(o), o.d)) return bad_access(); break;
        case Opcode::ldr_reg: if (!transfer<Access::ldr>(at_index(o), o.d)) return bad_access(); break;
        case Opcode::ldr_lit: if (!transfer<Access::ldr>(at_literal(o), o.d)) return bad_access(); break;
        case Opcode::ldrb_imm: if (!transfer<Access::ldrb>(at_offset(o), o.d)) return bad_access(); break;
        case Opcode::ldrb_reg: if (!transfer<Access::ldrb>(at_index(o), o.d)) return bad_access(); break;
        case Opcode::ldrb_lit: if (!transfer<Access::ldrb>(at_literal(o), o.d)) return bad_access(); break;
        case Opcode::ldrh_imm: if (!transfer<Access::ldrh>(at_offset(o), o.d)) return bad_access(); break;
        case Opcode::ldrh_reg: if (!transfer<Access::ldrh>(at_index(o), o.d)) return bad_access(); break;
        case Opcode::ldrh_lit: if (!transfer<Access::ldrh>(at_literal(o), o.d)) return bad_access(); break;
        case Opcode::ldrsb_imm: if (!transfer<Access::ldrsb>(at_offset(o), o.d)) return bad_access(); break;
        case Opcode::ldrsb_reg: if (!transfer<Access::ldrsb>(at_index(o), o.d)) return bad_access(); break;
        case Opcode::ldrsb_lit: if (!transfer<Access::ldrsb>(at_literal(o), o.d)) return bad_access(); break;
        case Opcode::ldrsh_imm: if (!transfer<Access::ldrsh>(at_offset(o), o.d)) return bad_access(); break;
        case Opcode::ldrsh_reg: if (!transfer<Access::ldrsh>(at_index(o), o.d)) return bad_access(); break;
        case Opcode::ldrsh_lit: if (!transfer<Access::ldrsh>(at_literal(o), o.d)) return bad_access(); break;
        case Opcode::str_imm: if (!transfer<Access::str>(at_offset(o), o.d)) return bad_access(); break;
        case Opcode::str_reg: if (!transfer<Access::str>(at_index(o), o.d)) return bad_access(); break;
        case Opcode::strb_imm: if (!transfer<Access::strb>(at_offset(o), o.d)) return bad_access(); break;
        case Opcode::strb_reg: if (!transfer<Access::strb>(at_index(o), o.d)) return bad_access(); break;
        case Opcode::strh_imm: if (!transfer<Access::strh>(at_offset(o), o.d)) return bad_access(); break;
        case Opcode::strh_reg: if (!transfer<Access::strh>(at_index(o), o.d)) return bad_access(); break;
        // clang-format on
        case Opcode::shift_by: {
          std::uint32_t carry = g.c;
          r[o.d] = shift_by(o.shift, r[o.n], r[o.m] & 0xFF, carry);
          break;
        }
        case Opcode::shifts_by: {
          std::uint32_t carry = g.c;
          r[o.d] = shift_by(o.shift, r[o.n], r[o.m] & 0xFF, carry);
          g.set_nz(r[o.d]);
          g.c = carry;
          break;
        }
        case Opcode::mov_plain:
          r[o.d] = r[o.m];
          break;
        case Opcode::add_plain:
          r[o.d] = r[o.n] + r[o.m];
          break;
        case Opcode::mov_pc:
          next = r[o.m] & ~1U;
          if (next >= 0xFFFFFF00U) return stop(Halt::exception_return, next);
          break;
        case Opcode::add_pc:
          next = (r[15] + r[o.m]) & ~1U;
          break;
        case Opcode::movt:
          r[o.d] = (r[o.d] & 0xFFFF) | o.imm << 16;
          break;
        case Opcode::adr:
          r[o.d] = (r[15] & ~3U) + o.imm;
          break;
        case Opcode::b:
          next = r[15] + o.imm;
          if (next == address) wait_in_place<Cost>(o.info.cycles);
          break;
        case Opcode::b_cond:
          next = condition(o.mode) ? r[15] + o.imm : expected;
          break;
        case Opcode::bl:
          r[14] = expected | 1;
          next = r[15] + o.imm;
          break;
        case Opcode::bx:
          if (const Halt why = interwork(r[o.m]); why != Halt::asked) return why;
          break;
        case Opcode::blx: {
          const std::uint32_t target = r[o.m];
          r[14] = expected | 1;
          if (const Halt why = interwork(target); why != Halt::asked) return why;
          break;
        }
        case Opcode::cbz:
          next = r[o.n] == 0 ? r[15] + o.imm : expected;
          break;
        case Opcode::cbnz:
          next = r[o.n] != 0 ? r[15] + o.imm : expected;
          break;
        case Opcode::tbb:
        case Opcode::tbh: {
          std::uint32_t halves = 0;
          const bool bytes = o.kind == Opcode::tbb;
          if (bytes ? !load<std::uint8_t>(r[o.n] + r[o.m], halves) : !load<std::uint16_t>(r[o.n] + 2 * r[o.m], halves))
            return bad_access();
          next = r[15] + 2 * halves;
          break;
        }
        case Opcode::indexed:
          if (!indexed(o)) return bad_access();
          break;
        case Opcode::ldm: {
          std::uint32_t target = 0;
          if (!load_multiple(o, target)) return bad_access();
          if ((o.imm & 0x8000) == 0) break;
          if (const Halt why = interwork(target); why != Halt::asked) return why;
          break;
        }
        case Opcode::stm:
          if (!store_multiple(o)) return bad_access();
          break;
        case Opcode::ldrd:
        case Opcode::strd:
          if (!dual(o, o.kind == Opcode::ldrd)) return bad_access();
          break;
        case Opcode::ldrex:
        case Opcode::strex:
          if (!exclusive(o)) return bad_access();
          break;
        case Opcode::clrex:
          g.exclusive = false;
          break;
        case Opcode::ubfx:
        case Opcode::sbfx:
        case Opcode::bfi:
          bit_field(o);
          break;
        case Opcode::clz:
          r[o.d] = static_cast<std::uint32_t>(std::countl_zero(r[o.m]));
          break;
        case Opcode::rbit:
          r[o.d] = reverse_bits(r[o.m]);
          break;
        case Opcode::rev:
          r[o.d] = __builtin_bswap32(r[o.m]);
          break;
        case Opcode::rev16:
          r[o.d] = (r[o.m] & 0x00FF00FFU) << 8 | (r[o.m] >> 8 & 0x00FF00FFU);
          break;
        case Opcode::revsh:
          r[o.d] = static_cast<std::uint32_t>(
              static_cast<std::int16_t>(__builtin_bswap16(static_cast<std::uint16_t>(r[o.m]))));
          break;
        case Opcode::extend: {
          const std::uint32_t value = extended(std::rotr(r[o.m], o.amount), o.mode);
          if (o.n == 15) {
            r[o.d] = value;
          } else if ((o.mode & Extend::kPair) != 0) {
            r[o.d] = ((r[o.n] + value) & 0xFFFF) | ((r[o.n] & 0xFFFF0000U) + (value & 0xFFFF0000U));
          } else {
            r[o.d] = r[o.n] + value;
          }
          break;
        }
        case Opcode::ssat:
        case Opcode::usat:
          saturate(o);
          break;
        case Opcode::mul:
          r[o.d] = r[o.n] * r[o.m];
          break;
        case Opcode::muls:
          r[o.d] = r[o.n] * r[o.m];
          g.set_nz(r[o.d]);
          break;
        case Opcode::mla:
          r[o.d] = r[o.a] + r[o.n] * r[o.m];
          break;
        case Opcode::mls:
          r[o.d] = r[o.a] - r[o.n] * r[o.m];
          break;
        case Opcode::smull:
        case Opcode::umull:
        case Opcode::smlal:
        case Opcode::umlal:
        case Opcode::umaal:
          multiply_long(o);
          break;
        case Opcode::sdiv: {
          const auto n = static_cast<std::int32_t>(r[o.n]), m = static_cast<std::int32_t>(r[o.m]);
          r[o.d] = m == 0 ? 0 : m == -1 ? 0U - r[o.n] : static_cast<std::uint32_t>(n / m);
          break;
        }
        case Opcode::udiv:
          r[o.d] = r[o.m] == 0 ? 0 : r[o.n] / r[o.m];
          break;
        case Opcode::media:
          media(o);
          break;
        case Opcode::nop:
          break;
        case Opcode::dsb:
          drained_at = pace.time;
          break;
        case Opcode::it:
          begin_it(address, o.imm);
          break;
        case Opcode::wfi:
          return stop(Halt::sleep, expected);
        case Opcode::cps:
          if ((o.imm & 2) != 0) g.primask = o.mode;
          if ((o.imm & 1) != 0) g.faultmask = o.mode;
          outside_.masks_changed();
          break;
        case Opcode::mrs:
          read_special(o);
          break;
        case Opcode::msr:
          write_special(o);
          break;
        case Opcode::svc:
          return stop(Halt::supervisor_call, expected);
        case Opcode::bkpt:
          return stop_again(Halt::breakpoint);
        case Opcode::vldr:
        case Opcode::vstr:
        case Opcode::vldm:
        case Opcode::vstm:
          if (!begin_float()) return stop_again(Halt::no_fpu);
          if (!float_memory(o)) return bad_access();
          break;
        case Opcode::vldr_word:
          if (!begin_float()) return stop_again(Halt::no_fpu);
          if (!load<std::uint32_t>(r[o.n] + o.imm, g.s[o.d])) return bad_access();
          break;
        case Opcode::vstr_word:
          if (!begin_float()) return stop_again(Halt::no_fpu);
          if (!store<std::uint32_t>(r[o.n] + o.imm, g.s[o.d])) return bad_access();
          break;
        case Opcode::marked: {  // begins once more as what it stands for
          pace.undo(o.info.cycles);
          outside_.passed(address, pace.time);
          const Operation& original = marked_.at(physical(address));
          elsewhere_ = here == &conditional_ ? inside_it(original) : original;
          here = &elsewhere_;
          continue;
        }
        case Opcode::unknown:  // reached from the instruction before
          pace.undo(o.info.cycles);
          here = take_apart_ram(address / 2);
          continue;
        case Opcode::undefined:
          return stop_again((o.info.flags & InstructionInfo::kFloatingPoint) != 0 && !fpu_on ? Halt::no_fpu
                                                                                             : Halt::undefined);
        // clang-format off
        case Opcode::vmov_to_core: case Opcode::vmov_from_core: case Opcode::vmov_pair: case Opcode::vmrs:
        case Opcode::vmsr: case Opcode::vmov_imm: case Opcode::vmov: case Opcode::vabs: case Opcode::vneg:
        case Opcode::vadd: case Opcode::vsub: case Opcode::vmul: case Opcode::vnmul: case Opcode::vdiv:
        case Opcode::vsqrt: case Opcode::vmla: case Opcode::vmls: case Opcode::vnmla: case Opcode::vnmls:
        case Opcode::vfma: case Opcode::vfms: case Opcode::vfnma: case Opcode::vfnms: case Opcode::vcmp:
        case Opcode::vcmp_zero: case Opcode::vcvt_to_int: case Opcode::vcvt_from_int: case Opcode::vcvt_fixed:
        case Opcode::vcvt_half:
          // clang-format on
          if (!begin_float()) return stop_again(Halt::no_fpu);
          floating(o);
          break;
        default:
          __builtin_unreachable();
      }
      constexpr unsigned kElsewhere = InstructionInfo::kLoadsPc | InstructionInfo::kJumps,
                         kLook = kElsewhere | InstructionInfo::kMovesStack | InstructionInfo::kAlone;
      if ((o.info.flags & kLook) != 0) {
        if ((o.info.flags & kElsewhere) == 0) next = expected;
        if ((o.info.flags & InstructionInfo::kLoadsPc) != 0) {
          const std::uint32_t target = r[15];
          r[15] = address + 4;
          if (const Halt why = interwork(target); why != Halt::asked) return why;
        }
        if (r[13] < stack_alarm) outside_.stack_moved();
        if (next != expected || (o.info.flags & InstructionInfo::kAlone) != 0) break;
      }
      here += o.info.bytes / 2U;
      address = expected;
      r[15] = address + 4;
      if (pace.time >= pace.stop_at && outside_.stops(address)) return stop(Halt::asked, address);
    }
  }
}

}  // namespace finemote::emulator
