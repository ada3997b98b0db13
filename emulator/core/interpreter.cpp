#include "emulator/core/interpreter.hpp"

#include <array>
#include <bit>

namespace finemote::emulator {
namespace {

#define FINEMOTE_INLINE __attribute__((always_inline))

constexpr std::uint32_t kSign = 0x80000000U;

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

const Operation* Interpreter::take_apart_at(std::uint32_t address, Operation& into) const {
  const auto half = [this](std::uint32_t at, std::uint16_t& value) {
    const std::uint8_t* from = nullptr;
    if (at <= Memories::kFlashBytes - 2) from = memories_.flash + at;
    if (at - Memories::kFlashBase <= Memories::kFlashBytes - 2) from = memories_.flash + (at - Memories::kFlashBase);
    if (at - Memories::kRamBase <= Memories::kRamBytes - 2) from = memories_.ram + (at - Memories::kRamBase);
    if (from != nullptr) std::memcpy(&value, from, 2);
    return from != nullptr;
  };
  std::uint16_t halves[2] = {0, 0};
  if (!half(address, halves[0])) return nullptr;
  if (halves[0] >= 0xE800 && !half(address + 2, halves[1])) return nullptr;
  into = take_apart(halves[0], halves[1]);
  return &into;
}

void Interpreter::take_apart_flash(std::uint32_t bytes) {
  known_count_ = (bytes + 1) / 2;
  // The last two are what runs off the end: erased flash, or none.
  operations_.assign(known_count_ + 2, {});
  for (std::uint32_t n = 0; n < known_count_; ++n) take_apart_at(Memories::kFlashBase + 2 * n, operations_[n]);
  for (std::uint32_t n = known_count_; n < known_count_ + 2; ++n) operations_[n] = take_apart(0xFFFF, 0xFFFF);
  known_ = operations_.data();
}

/// @return null where no instruction can be
inline const Operation* Interpreter::operation_at(std::uint32_t address, Operation& outside_image) const {
  if (const std::uint32_t n = (address - Memories::kFlashBase) / 2; n < known_count_) return known_ + n;
  if (address / 2 < known_count_) return known_ + address / 2;
  if (take_apart_at(address, outside_image) == nullptr) return nullptr;
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

/// Makes the floating-point context active. @return false: the FPU is off
inline bool Interpreter::begin_float() {
  if (!fpu_on) return false;
  if (!fp_active) registers.fpscr = 0;  // a new context takes FPDSCR, of which nothing else is modelled: B1.5.7
  fp_active = true;
  if (lazy_frame) pace.charge(kLazyCycles);
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

bool Interpreter::load_elsewhere(std::uint32_t address, unsigned bytes, std::uint32_t& value) {
  bad_address_ = address;
  if (address >= Memories::kRamBase) return outside_.read(address, bytes, value);
  const std::uint8_t* from = nullptr;
  if (address <= Memories::kFlashBytes - bytes) from = memories_.flash + address;
  if (const std::uint32_t at = address - Memories::kSystemBase; at <= Memories::kSystemBytes - bytes)
    from = memories_.system + at;
  if (from == nullptr) return false;
  value = 0;
  std::memcpy(&value, from, bytes);
  return true;
}

bool Interpreter::store_elsewhere(std::uint32_t address, unsigned bytes, std::uint32_t value) {
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

template <bool Load>
inline bool Interpreter::transfer(unsigned which, std::uint32_t address, unsigned t) {
  std::uint32_t& value = registers.r[t];
  if constexpr (!Load) {
    return which == 5   ? store<std::uint32_t>(address, value)
           : which == 6 ? store<std::uint8_t>(address, value)
                        : store<std::uint16_t>(address, value);
  } else {
    std::uint32_t loaded = 0;
    const bool ok = which == 0                 ? load<std::uint32_t>(address, loaded)
                    : which == 1 || which == 3 ? load<std::uint8_t>(address, loaded)
                                               : load<std::uint16_t>(address, loaded);
    if (!ok) return false;
    if (which == 3) loaded = static_cast<std::uint32_t>(static_cast<std::int8_t>(loaded));
    if (which == 4) loaded = static_cast<std::uint32_t>(static_cast<std::int16_t>(loaded));
    value = loaded;
    return true;
  }
}

bool Interpreter::indexed(const Operation& o) {
  const std::uint32_t moved = registers.r[o.n] + o.imm, address = o.mode == 1 ? moved : registers.r[o.n];
  if (o.a >= 5 ? !transfer<false>(o.a, address, o.d) : !transfer<true>(o.a, address, o.d)) return false;
  registers.r[o.n] = moved;
  return true;
}

/// @param target  set when the list holds the PC
bool Interpreter::load_multiple(const Operation& o, std::uint32_t& target) {
  const std::uint32_t base = registers.r[o.n], moved = (o.mode & 2) != 0 ? base - o.amount : base + o.amount;
  std::uint32_t address = (o.mode & 2) != 0 ? moved : base;
  std::uint8_t values[64];
  const std::uint8_t* from = in_ram(address, o.amount);
  if (from == nullptr) {
    for (unsigned i = 0; i < o.amount; i += 4, address += 4) {
      std::uint32_t value = 0;
      if (!load<std::uint32_t>(address, value)) return false;
      std::memcpy(values + i, &value, 4);
    }
    from = values;
  }
  if ((o.mode & 1) != 0) registers.r[o.n] = moved;
  for (std::uint32_t list = o.imm & 0x7FFF; list != 0; list &= list - 1, from += 4)
    std::memcpy(&registers.r[static_cast<unsigned>(std::countr_zero(list))], from, 4);
  if ((o.imm & 0x8000) != 0) std::memcpy(&target, from, 4);
  return true;
}

bool Interpreter::store_multiple(const Operation& o) {
  const std::uint32_t base = registers.r[o.n], moved = (o.mode & 2) != 0 ? base - o.amount : base + o.amount;
  std::uint32_t address = (o.mode & 2) != 0 ? moved : base;
  if (std::uint8_t* to = in_ram(address, o.amount)) {
    for (std::uint32_t list = o.imm; list != 0; list &= list - 1, to += 4)
      std::memcpy(to, &registers.r[static_cast<unsigned>(std::countr_zero(list))], 4);
  } else {
    for (std::uint32_t list = o.imm; list != 0; list &= list - 1, address += 4) {
      if (!store<std::uint32_t>(address, registers.r[static_cast<unsigned>(std::countr_zero(list))])) return false;
    }
  }
  if ((o.mode & 1) != 0) registers.r[o.n] = moved;
  return true;
}

bool Interpreter::dual(const Operation& o, bool loads) {
  const std::uint32_t base = o.n == 15 ? registers.r[15] & ~3U : registers.r[o.n], moved = base + o.imm,
                      address = (o.mode & 2) != 0 ? moved : base;
  if (loads) {
    std::uint32_t low = 0, high = 0;
    if (!load<std::uint32_t>(address, low) || !load<std::uint32_t>(address + 4, high)) return false;
    registers.r[o.d] = low;
    registers.r[o.a] = high;
  } else if (!store<std::uint32_t>(address, registers.r[o.d]) || !store<std::uint32_t>(address + 4, registers.r[o.a])) {
    return false;
  }
  if ((o.mode & 1) != 0) registers.r[o.n] = moved;
  return true;
}

/// A3.4 with one processor: the monitor is open until the next store, or until an exception comes or goes.
bool Interpreter::exclusive(const Operation& o) {
  const std::uint32_t address = registers.r[o.n] + o.imm;
  if (o.kind == Opcode::ldrex) {
    registers.exclusive = true;
    constexpr unsigned which[] = {1, 2, 0};
    return transfer<true>(which[o.amount], address, o.d);
  }
  if (registers.exclusive) {
    constexpr unsigned which[] = {6, 7, 5};
    if (!transfer<false>(which[o.amount], address, o.m)) return false;
  }
  registers.r[o.d] = registers.exclusive ? 0 : 1;
  registers.exclusive = false;
  return true;
}

bool Interpreter::float_memory(const Operation& o) {
  const bool several = o.kind == Opcode::vldm || o.kind == Opcode::vstm,
             loads = o.kind == Opcode::vldr || o.kind == Opcode::vldm;
  const std::uint32_t base = o.n == 15 ? registers.r[15] & ~3U : registers.r[o.n];
  const bool down = several && (o.mode & 2) != 0;
  std::uint32_t address = several ? (down ? base - o.imm : base) : base + o.imm;
  for (unsigned i = 0; i < o.amount; ++i, address += 4) {
    std::uint32_t& s = registers.s[o.d + i];
    if (loads ? !load<std::uint32_t>(address, s) : !store<std::uint32_t>(address, s)) return false;
  }
  if (several && (o.mode & 1) != 0) registers.r[o.n] = down ? base - o.imm : base + o.imm;
  return true;
}

void Interpreter::bit_field(const Operation& o) {
  std::uint32_t& d = registers.r[o.d];
  const std::uint32_t n = registers.r[o.n];
  if (o.kind == Opcode::bfi) {
    if (o.imm < o.amount) return;
    const std::uint32_t mask = ((2U << (o.imm - o.amount)) - 1) << o.amount, source = o.n == 15 ? 0 : n;
    d = (d & ~mask) | (source << o.amount & mask);
    return;
  }
  const unsigned left = o.amount + o.imm > 32 ? 0 : 32 - o.amount - o.imm, right = 32 - o.imm;
  d = o.kind == Opcode::ubfx ? n << left >> right
                             : static_cast<std::uint32_t>(static_cast<std::int32_t>(n << left) >> right);
}

void Interpreter::saturate(const Operation& o) {
  std::uint32_t carry = 0;
  const auto value = static_cast<std::int32_t>(shifted(o, carry));
  const std::int64_t high =
                         o.kind == Opcode::ssat ? (std::int64_t{1} << (o.imm - 1)) - 1 : (std::int64_t{1} << o.imm) - 1,
                     low = o.kind == Opcode::ssat ? -high - 1 : 0;
  const std::int64_t kept = value < low ? low : value > high ? high : value;
  if (kept != value) registers.q = 1;
  registers.r[o.d] = static_cast<std::uint32_t>(kept);
}

void Interpreter::multiply_long(const Operation& o) {
  const std::uint32_t n = registers.r[o.n], m = registers.r[o.m];
  std::uint32_t &low = registers.r[o.d], &high = registers.r[o.a];
  const bool is_signed = o.kind == Opcode::smull || o.kind == Opcode::smlal;
  std::uint64_t result =
      is_signed ? static_cast<std::uint64_t>(std::int64_t{static_cast<std::int32_t>(n)} * static_cast<std::int32_t>(m))
                : std::uint64_t{n} * m;
  if (o.kind == Opcode::smlal || o.kind == Opcode::umlal) result += std::uint64_t{high} << 32 | low;
  if (o.kind == Opcode::umaal) result += std::uint64_t{high} + low;
  low = static_cast<std::uint32_t>(result);
  high = static_cast<std::uint32_t>(result >> 32);
}

/// MRS: B5.2.2.
void Interpreter::read_special(const Operation& o) {
  Registers& g = registers;
  std::uint32_t value = 0;
  switch (o.imm) {
    case 8:
      value = g.main_stack();
      break;
    case 9:
      value = g.process_stack();
      break;
    case 16:
      value = g.primask;
      break;
    case 17:
    case 18:
      value = g.basepri;
      break;
    case 19:
      value = g.faultmask;
      break;
    case 20:
      value = g.control | (fp_active ? 4U : 0U);
      break;
    default:  // APSR and IPSR in their combinations; EPSR reads as zero
      if (o.imm > 7) return;
      value = ((o.imm & 4) == 0 ? g.flags() | g.ge << 16 : 0) | ((o.imm & 1) != 0 ? g.exception : 0);
      break;
  }
  g.r[o.d] = value;
}

/// MSR: B5.2.3.
void Interpreter::write_special(const Operation& o) {
  Registers& g = registers;
  const std::uint32_t value = g.r[o.n];
  switch (o.imm) {
    case 8:
      g.main_stack() = value & ~3U;
      break;
    case 9:
      g.process_stack() = value & ~3U;
      break;
    case 16:
      g.primask = value & 1;
      break;
    case 17:
      g.basepri = value & 0xF0;
      break;
    case 18:
      if ((value & 0xF0) != 0 && (g.basepri == 0 || (value & 0xF0) < g.basepri)) g.basepri = value & 0xF0;
      break;
    case 19:
      g.faultmask = value & 1;
      break;
    case 20:
      g.enter_mode(g.exception, value & 3);
      break;
    default:
      if (o.imm > 7 || (o.imm & 4) != 0) break;
      if ((o.mode & 2) != 0) g.set_flags(value);
      if ((o.mode & 1) != 0) g.ge = value >> 16 & 0xF;
      break;
  }
  outside_.masks_changed();
}

Halt Interpreter::run() {
  const bool plain = pace.cost == CostModel::cortex_m4 && pace.flash == FlashModel::hit;
  return plain                          ? run_with<CostModel::cortex_m4, FlashModel::hit>()
         : pace.cost == CostModel::qemu ? run_with<CostModel::qemu, FlashModel::hit>()
                                        : run_with<CostModel::cortex_m4, FlashModel::miss_always>();
}

/// The loop, made for each choice of costs that matters.
template <CostModel Cost, FlashModel Flash>
Halt Interpreter::run_with() {
  Registers& g = registers;
  std::uint32_t* const r = g.r.data();
  std::uint32_t next = g.next;
  std::uint32_t expected = pace.expected;  // where `next` would be without a jump
  const auto stop_at = [&](Halt why, std::uint32_t at, std::uint32_t follows) FINEMOTE_INLINE {
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
    for (;;) {  // straight on
      const Operation& o = *here;
      pace.account<Cost, Flash>(address, o.info.cycles);
      expected = address + o.info.bytes;
      const auto stop = [&](Halt why, std::uint32_t at) FINEMOTE_INLINE { return stop_at(why, at, expected); };
      // The instruction has not happened.
      const auto stop_again = [&](Halt why) FINEMOTE_INLINE {
        g.it = here == &conditional_ ? it : 0;
        return stop(why, address);
      };

      const auto set_nz = [&](std::uint32_t result) FINEMOTE_INLINE { g.n = g.z = result; };
      const auto imm_carry = [&]() FINEMOTE_INLINE { return o.mode != 0 ? o.imm >> 31 : g.c; };
      // A jump to a value that tells the state: BX, and loads of the PC.
      const auto interwork = [&](std::uint32_t target) FINEMOTE_INLINE {
        next = target & ~1U;
        if (target >= 0xFFFFFF00U) return stop(Halt::exception_return, target);
        return (target & 1) == 0 ? stop(Halt::bad_state, target) : Halt::asked;
      };

// One case per last operand: `y` is an immediate, a register, a register shifted.
#define FINEMOTE_FORMS(NAME, DO, EXPRESSION)                        \
  case Opcode::NAME##_imm: {                                        \
    const std::uint32_t x = r[o.n], y = o.imm, carry = imm_carry(); \
    DO(EXPRESSION)                                                  \
    break;                                                          \
  }                                                                 \
  case Opcode::NAME##_reg: {                                        \
    const std::uint32_t x = r[o.n], y = r[o.m], carry = g.c;        \
    DO(EXPRESSION)                                                  \
    break;                                                          \
  }                                                                 \
  case Opcode::NAME##_shifted: {                                    \
    std::uint32_t carry = g.c;                                      \
    const std::uint32_t x = r[o.n], y = shifted(o, carry);          \
    DO(EXPRESSION)                                                  \
    break;                                                          \
  }
#define FINEMOTE_PLAIN(EXPRESSION)                \
  static_cast<void>(x), static_cast<void>(carry); \
  r[o.d] = EXPRESSION;
#define FINEMOTE_TEST(EXPRESSION) \
  static_cast<void>(x);           \
  set_nz(EXPRESSION);             \
  g.c = carry;
#define FINEMOTE_COMPARE(SUM) \
  static_cast<void>(carry);   \
  set_nz(SUM);
#define FINEMOTE_SET_LOGIC(EXPRESSION)     \
  static_cast<void>(x);                    \
  const std::uint32_t result = EXPRESSION; \
  r[o.d] = result;                         \
  set_nz(result);                          \
  g.c = carry;
#define FINEMOTE_SET_SUM(SUM)       \
  static_cast<void>(carry);         \
  const std::uint32_t result = SUM; \
  r[o.d] = result;                  \
  set_nz(result);
#define FINEMOTE_LOGIC(NAME, EXPRESSION)           \
  FINEMOTE_FORMS(NAME, FINEMOTE_PLAIN, EXPRESSION) \
  FINEMOTE_FORMS(NAME##s, FINEMOTE_SET_LOGIC, EXPRESSION)
#define FINEMOTE_SUM(NAME, X, Y, CARRY)                     \
  FINEMOTE_FORMS(NAME, FINEMOTE_PLAIN, (X) + (Y) + (CARRY)) \
  FINEMOTE_FORMS(NAME##s, FINEMOTE_SET_SUM, add(X, Y, CARRY, g.c, g.v))
#define FINEMOTE_LOAD(NAME, WHICH)                                                                       \
  case Opcode::NAME##_imm:                                                                               \
    if (!transfer<true>(WHICH, r[o.n] + o.imm, o.d)) return stop_again(Halt::bad_access);                \
    break;                                                                                               \
  case Opcode::NAME##_reg:                                                                               \
    if (!transfer<true>(WHICH, r[o.n] + (r[o.m] << o.amount), o.d)) return stop_again(Halt::bad_access); \
    break;                                                                                               \
  case Opcode::NAME##_lit:                                                                               \
    if (!transfer<true>(WHICH, (r[15] & ~3U) + o.imm, o.d)) return stop_again(Halt::bad_access);         \
    break;
#define FINEMOTE_STORE(NAME, WHICH)                                                                       \
  case Opcode::NAME##_imm:                                                                                \
    if (!transfer<false>(WHICH, r[o.n] + o.imm, o.d)) return stop_again(Halt::bad_access);                \
    break;                                                                                                \
  case Opcode::NAME##_reg:                                                                                \
    if (!transfer<false>(WHICH, r[o.n] + (r[o.m] << o.amount), o.d)) return stop_again(Halt::bad_access); \
    break;

      switch (o.kind) {
        FINEMOTE_LOGIC(and, x & y)
        FINEMOTE_LOGIC(bic, x & ~y)
        FINEMOTE_LOGIC(orr, x | y)
        FINEMOTE_LOGIC(orn, x | ~y)
        FINEMOTE_LOGIC(eor, x ^ y)
        FINEMOTE_LOGIC(mov, y)
        FINEMOTE_LOGIC(mvn, ~y)
        FINEMOTE_FORMS(tst, FINEMOTE_TEST, x & y)
        FINEMOTE_FORMS(teq, FINEMOTE_TEST, x ^ y)
        FINEMOTE_FORMS(cmp, FINEMOTE_COMPARE, add(x, ~y, 1, g.c, g.v))
        FINEMOTE_FORMS(cmn, FINEMOTE_COMPARE, add(x, y, 0, g.c, g.v))
        FINEMOTE_SUM(add, x, y, 0)
        FINEMOTE_SUM(adc, x, y, g.c)
        FINEMOTE_SUM(sub, x, ~y, 1)
        FINEMOTE_SUM(sbc, x, ~y, g.c)
        FINEMOTE_SUM(rsb, y, ~x, 1)
        FINEMOTE_LOAD(ldr, 0)
        FINEMOTE_LOAD(ldrb, 1)
        FINEMOTE_LOAD(ldrh, 2)
        FINEMOTE_LOAD(ldrsb, 3)
        FINEMOTE_LOAD(ldrsh, 4)
        FINEMOTE_STORE(str, 5)
        FINEMOTE_STORE(strb, 6)
        FINEMOTE_STORE(strh, 7)
#undef FINEMOTE_SUM
#undef FINEMOTE_LOGIC
#undef FINEMOTE_SET_SUM
#undef FINEMOTE_SET_LOGIC
#undef FINEMOTE_COMPARE
#undef FINEMOTE_TEST
#undef FINEMOTE_PLAIN
#undef FINEMOTE_FORMS
#undef FINEMOTE_LOAD
#undef FINEMOTE_STORE
        case Opcode::shift_by: {
          std::uint32_t carry = g.c;
          r[o.d] = shift_by(o.shift, r[o.n], r[o.m] & 0xFF, carry);
          break;
        }
        case Opcode::shifts_by: {
          std::uint32_t carry = g.c;
          r[o.d] = shift_by(o.shift, r[o.n], r[o.m] & 0xFF, carry);
          set_nz(r[o.d]);
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
            return stop_again(Halt::bad_access);
          next = r[15] + 2 * halves;
          break;
        }
        case Opcode::indexed:
          if (!indexed(o)) return stop_again(Halt::bad_access);
          break;
        case Opcode::ldm: {
          std::uint32_t target = 0;
          if (!load_multiple(o, target)) return stop_again(Halt::bad_access);
          if ((o.imm & 0x8000) == 0) break;
          if (const Halt why = interwork(target); why != Halt::asked) return why;
          break;
        }
        case Opcode::stm:
          if (!store_multiple(o)) return stop_again(Halt::bad_access);
          break;
        case Opcode::ldrd:
        case Opcode::strd:
          if (!dual(o, o.kind == Opcode::ldrd)) return stop_again(Halt::bad_access);
          break;
        case Opcode::ldrex:
        case Opcode::strex:
          if (!exclusive(o)) return stop_again(Halt::bad_access);
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
          set_nz(r[o.d]);
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
          if (!float_memory(o)) return stop_again(Halt::bad_access);
          break;
        case Opcode::vldr_word:
          if (!begin_float()) return stop_again(Halt::no_fpu);
          if (!load<std::uint32_t>(r[o.n] + o.imm, g.s[o.d])) return stop_again(Halt::bad_access);
          break;
        case Opcode::vstr_word:
          if (!begin_float()) return stop_again(Halt::no_fpu);
          if (!store<std::uint32_t>(r[o.n] + o.imm, g.s[o.d])) return stop_again(Halt::bad_access);
          break;
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
