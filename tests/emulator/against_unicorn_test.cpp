// The interpreter against libunicorn: the same instruction on the same registers and memory must leave the same.
#include <unicorn/unicorn.h>

#include <bit>
#include <random>
#include <string>
#include <vector>

#include "catch.hpp"
#include "emulator/core/interpreter.hpp"

using namespace finemote::emulator;

namespace {

constexpr std::uint32_t kCode = 0x08001000, kScratch = 0x20010000, kScratchBytes = 0x4000;

/// Nothing but memory.
class Nothing : public Outside {
 public:
  bool read(std::uint32_t, unsigned, std::uint32_t&) override { return false; }
  bool write(std::uint32_t, unsigned, std::uint32_t) override { return false; }
  bool stops(std::uint32_t address) override { return address == end || left-- == 0; }
  void masks_changed() override {}
  void stack_moved() override {}
  void passed(std::uint32_t, Time) override {}
  void saved_float(Time, Time) override {}
  void report_unmodelled(const char*) override {}
  unsigned left = 0;
  std::uint32_t end = 0;
};

struct State {
  std::uint32_t r[16], flags, s[32], float_flags;
};

/// What both sides compute with: the same bytes in flash and RAM.
struct Memory {
  std::vector<std::uint8_t> flash = std::vector<std::uint8_t>(Memories::kFlashBytes, 0xFF),
                            ram = std::vector<std::uint8_t>(Memories::kRamBytes),
                            core_ram = std::vector<std::uint8_t>(Memories::kCoreRamBytes),
                            system = std::vector<std::uint8_t>(Memories::kSystemBytes);
};

class Ours {
 public:
  Ours()
      : core_(Memories{memory.flash.data(), memory.ram.data(), memory.core_ram.data(), memory.system.data()}, nothing_,
              tags_) {
    tags_.turn_on();  // they change nothing of what is computed
    core_.fpu_on = true;
    core_.pace.cycle = 1;
  }

  /// @param instructions  to run at most; 0: as many as there are before `end`
  /// @return false: no such instruction, or no such memory
  bool step(State& state, unsigned instructions, std::uint32_t end = 0) {
    Registers& g = core_.registers;
    g = Registers{};
    std::copy(state.r, state.r + 15, g.r.begin());
    std::copy(state.s, state.s + 32, g.s.begin());
    g.set_flags(state.flags);
    g.fpscr = state.float_flags;
    g.next = state.r[15];
    core_.take_apart_flash(0);
    nothing_.left = instructions != 0 ? instructions : 100;
    nothing_.end = end;
    const Halt why = core_.run();
    if (why != Halt::asked && why != Halt::no_instruction) return false;
    std::copy(g.r.begin(), g.r.begin() + 15, state.r);
    std::copy(g.s.begin(), g.s.end(), state.s);
    state.r[15] = g.next;
    state.flags = g.flags();
    state.float_flags = g.fpscr & 0xF0000000U;
    return true;
  }

  Memory memory;

 private:
  Nothing nothing_;
  Provenance provenance_;
  TagFlow tags_{provenance_};
  Interpreter core_;
};

class Theirs {
 public:
  Theirs() {
    uc_open(UC_ARCH_ARM, static_cast<uc_mode>(UC_MODE_THUMB | UC_MODE_MCLASS), &uc_);
    uc_ctl_set_cpu_model(uc_, UC_CPU_ARM_CORTEX_M4);
    uc_mem_map_ptr(uc_, Memories::kFlashBase, Memories::kFlashBytes, UC_PROT_ALL, memory.flash.data());
    uc_mem_map_ptr(uc_, Memories::kRamBase, Memories::kRamBytes, UC_PROT_ALL, memory.ram.data());
    set(UC_ARM_REG_C1_C0_2, 0xFU << 20);
    set(UC_ARM_REG_FPEXC, 1U << 30);
  }
  ~Theirs() { uc_close(uc_); }
  Theirs(const Theirs&) = delete;
  Theirs& operator=(const Theirs&) = delete;

  bool step(State& state, unsigned instructions, std::uint32_t end = 0xFFFFFFFE) {
    uc_ctl_remove_cache(uc_, kCode, kCode + 24);
    for (int i = 0; i < 13; ++i) set(UC_ARM_REG_R0 + i, state.r[i]);
    set(UC_ARM_REG_SP, state.r[13]);
    set(UC_ARM_REG_LR, state.r[14]);
    set(UC_ARM_REG_XPSR, state.flags | 1U << 24);
    for (int i = 0; i < 32; ++i) set(UC_ARM_REG_S0 + i, state.s[i]);
    set(UC_ARM_REG_FPSCR, state.float_flags);
    if (uc_emu_start(uc_, state.r[15] | 1, end, 0, instructions) != UC_ERR_OK) return false;
    for (int i = 0; i < 13; ++i) state.r[i] = get(UC_ARM_REG_R0 + i);
    state.r[13] = get(UC_ARM_REG_SP);
    state.r[14] = get(UC_ARM_REG_LR);
    state.r[15] = get(UC_ARM_REG_PC) & ~1U;
    state.flags = get(UC_ARM_REG_XPSR) & 0xF8000000U;
    for (int i = 0; i < 32; ++i) state.s[i] = get(UC_ARM_REG_S0 + i);
    state.float_flags = get(UC_ARM_REG_FPSCR) & 0xF0000000U;
    return true;
  }

  Memory memory;

 private:
  void set(int reg, std::uint32_t value) { uc_reg_write(uc_, reg, &value); }
  std::uint32_t get(int reg) {
    std::uint32_t value = 0;
    uc_reg_read(uc_, reg, &value);
    return value;
  }
  uc_engine* uc_ = nullptr;
};

/// Encodings the manual calls unpredictable, and what needs more than memory.
bool left_out(const Operation& o, std::uint16_t first, std::uint16_t second) {
  const auto odd = [](unsigned reg) { return reg == 13 || reg == 15; };
  const bool wide = first >= 0xE800;
  switch (o.kind) {
    case Opcode::undefined:
    case Opcode::it:
    case Opcode::wfi:
    case Opcode::cps:
    case Opcode::mrs:
    case Opcode::msr:
    case Opcode::svc:
    case Opcode::bkpt:
    case Opcode::ldrex:
    case Opcode::strex:
    case Opcode::clrex:
    case Opcode::bx:
    case Opcode::blx:
    case Opcode::mov_pc:
    case Opcode::add_pc:
    case Opcode::nop:
    case Opcode::vmsr:
      return true;
    case Opcode::tbb:
    case Opcode::tbh:
      return odd(o.n) || odd(o.m) || o.n == o.m;
    case Opcode::b:
    case Opcode::b_cond:
    case Opcode::bl:
    case Opcode::cbz:
    case Opcode::cbnz:
      return false;
    case Opcode::ldm:
    case Opcode::stm:
      return o.imm == 0 || (o.imm & 0xA000) != 0 || o.n == 15 ||
             (wide && ((o.mode & 1) != 0 || o.kind == Opcode::stm) && (o.imm >> o.n & 1) != 0) ||
             (wide && (o.imm & (o.imm - 1)) == 0) || (o.kind == Opcode::stm && (o.imm >> o.n & 1) != 0);
    case Opcode::ldrd:
    case Opcode::strd:
      return odd(o.d) || odd(o.a) || odd(o.n) || o.d == o.a || ((o.mode & 1) != 0 && (o.n == o.d || o.n == o.a));
    case Opcode::indexed:
      return odd(o.d) || odd(o.n) || o.d == o.n;
    case Opcode::smull:
    case Opcode::umull:
    case Opcode::smlal:
    case Opcode::umlal:
    case Opcode::umaal:
      return odd(o.d) || odd(o.a) || odd(o.n) || odd(o.m) || o.d == o.a;
    case Opcode::sdiv:
    case Opcode::udiv:
      return odd(o.d) || odd(o.n) || odd(o.m) || (second & 0xF000) != 0xF000;
    case Opcode::media: {
      const bool two_results = static_cast<Media>(o.a) == Media::smlalxy || static_cast<Media>(o.a) == Media::smlald;
      const bool third = static_cast<Media>(o.a) == Media::ssat16 || static_cast<Media>(o.a) == Media::usat16;
      if (static_cast<Media>(o.a) == Media::sel) return true;
      return odd(o.d) || odd(o.n) || odd(o.m) || (!third && o.imm == 13) || (third && (second & 0x30) != 0) ||
             (static_cast<Media>(o.a) == Media::smmla && (o.mode & 2) != 0 && o.imm == 15) ||
             (two_results && (o.imm == o.d || o.imm == 15));
    }
    case Opcode::vldr:
    case Opcode::vstr:
    case Opcode::vldm:
    case Opcode::vstm:
      return o.n == 15 || ((second & 0xF00) == 0xB00 && (second & 1) != 0);
    case Opcode::vmov_to_core:
      return odd(o.d);
    case Opcode::vmov_from_core:
      return odd(o.n);
    case Opcode::vmov_pair:
      return odd(o.d) || odd(o.n) || o.d == o.n;
    case Opcode::vmrs:
      return o.d != 15 || (second & 0xEF) != 0;
    case Opcode::bfi:
      return odd(o.d) || o.n == 13 || o.imm < o.amount;
    case Opcode::ubfx:
    case Opcode::sbfx:
      return odd(o.d) || odd(o.n) || o.amount + o.imm > 32;
    case Opcode::mla:
    case Opcode::mls:
      return odd(o.d) || odd(o.n) || odd(o.m) || odd(o.a);
    case Opcode::extend:
      return odd(o.d) || o.n == 13 || odd(o.m);
    case Opcode::vmov_imm:
    case Opcode::vmov:
    case Opcode::vabs:
    case Opcode::vneg:
    case Opcode::vsqrt:
      return (second & 0x20) != 0 && o.kind == Opcode::vmov_imm;
    default:
      if (o.kind >= Opcode::vldr) return false;
      return odd(o.d) || odd(o.n) || odd(o.m);
  }
}

class Chance {
 public:
  std::uint32_t operator()() { return static_cast<std::uint32_t>(engine_()); }
  std::uint32_t below(std::uint32_t end) { return (*this)() % end; }

  /// Numbers where mistakes hide, for integers and floats.
  std::uint32_t value() {
    static constexpr std::uint32_t kHard[] = {
        0,          1,          2,          0x1F,       0x20,       0x7F,       0x80,       0xFF,       0x7FFF,
        0x8000,     0xFFFF,     0x7FFFFFFF, 0x80000000, 0xFFFFFFFF, 0xFFFFFFFE, 0x80008000, 0x7FFF7FFF, 0x3F800000,
        0xBF800000, 0x7F800000, 0xFF800000, 0x7FC00001, 0x7FA00001, 0xFFA00002, 0x00000001, 0x007FFFFF, 0x00800000,
        0x7F7FFFFF, 0x4F000000, 0xCF000000, 0x4F800000, 0x3F000000, 0x3FC00000, 0x33800000, 0x477FF000, 0x38800000};
    switch (below(4)) {
      case 0:
        return kHard[below(sizeof kHard / sizeof *kHard)];
      case 1:
        return 0x3F000000U + below(0x02000000) + (below(2) << 31);
      default:
        return (*this)();
    }
  }

 private:
  std::mt19937 engine_{20240601};
};

std::string text(const char* what, unsigned number, std::uint32_t ours, std::uint32_t theirs) {
  char line[80];
  std::snprintf(line, sizeof line, "%s%u: %08X, libunicorn %08X; ", what, number, ours, theirs);
  return line;
}

std::string difference(const State& a, const State& b) {
  std::string result;
  for (unsigned i = 0; i < 16; ++i)
    if (a.r[i] != b.r[i]) result += text("r", i, a.r[i], b.r[i]);
  for (unsigned i = 0; i < 32; ++i)
    if (a.s[i] != b.s[i]) result += text("s", i, a.s[i], b.s[i]);
  if (a.flags != b.flags) result += text("flags ", 0, a.flags, b.flags);
  if (a.float_flags != b.float_flags) result += text("fpscr ", 0, a.float_flags, b.float_flags);
  return result;
}

/// An encoding of a family: `fixed` where `mask` is clear, chance elsewhere.
struct Family {
  const char* name;
  std::uint32_t fixed, free;
  unsigned count;
};

constexpr Family kFamilies[] = {
    {"16 bits: shifts, sums, moves", 0x00000000, 0x3FFF0000, 6000},
    {"16 bits: data processing", 0x40000000, 0x07FF0000, 2500},
    {"16 bits: loads, stores", 0x48000000, 0x57FF0000, 1500},
    {"16 bits: anything", 0x00000000, 0xFFFF0000, 2500},
    {"modified immediates", 0xF0000000, 0x05FF7FFF, 6000},
    {"plain immediates", 0xF2000000, 0x05FF7FFF, 6000},
    {"branches", 0xF0008000, 0x07FF7FFF, 400},
    {"shifted registers", 0xEA000000, 0x01FF7FFF, 6000},
    {"registers", 0xFA00F000, 0x00FF0FFF, 12000},
    {"multiplications", 0xFB000000, 0x00FFFFFF, 12000},
    {"loads, stores of one", 0xF8000000, 0x01FFFFFF, 6000},
    {"loads, stores of several", 0xE8000000, 0x01FFFFFF, 2500},
    {"float arithmetic", 0xEE000A00, 0x00FFF0EF, 20000},
    {"to and from single floats", 0xEE000A10, 0x001FF080, 500},
    {"to and from halves of doubles", 0xEE000B10, 0x003FF080, 500},
    {"to and from pairs of floats", 0xEC400A10, 0x001FF12F, 500},
    {"flags of floats", 0xEEF1FA10, 0, 100},
    {"float loads and stores", 0xEC000A00, 0x01FFF11F, 1500},
};

}  // namespace

TEST_CASE("every instruction leaves what it leaves on libunicorn", "[core]") {
  Ours ours;
  Theirs theirs;
  Chance chance;
  for (const Family& family : kFamilies) {
    unsigned compared = 0, failed = 0;
    for (unsigned tries = 0; compared < family.count && tries < 40 * family.count; ++tries) {
      const std::uint32_t code = family.fixed | (chance() & family.free);
      const auto first = static_cast<std::uint16_t>(code >> 16), second = static_cast<std::uint16_t>(code);
      const Operation o = take_apart(first, second);
      if (left_out(o, first, second)) continue;
      const bool memory = (o.kind >= Opcode::ldr_imm && o.kind <= Opcode::strd) || o.kind == Opcode::tbb ||
                          o.kind == Opcode::tbh || (o.kind >= Opcode::vldr && o.kind <= Opcode::vstm);
      State state{};
      for (std::uint32_t& r : state.r) r = memory ? chance.below(64) : chance.value();
      if (memory) state.r[o.n & 0xF] = kScratch + kScratchBytes / 2 + 4 * chance.below(64);
      if (memory && chance.below(4) == 0) state.r[o.n & 0xF] += chance.below(4) % (o.kind < Opcode::indexed ? 4 : 1);
      state.r[13] &= ~3U;
      state.r[15] = kCode;
      state.flags = chance() & 0xF8000000U;
      for (std::uint32_t& s : state.s) s = chance.value();
      state.float_flags = chance() & 0xF0000000U;
      // The GE bits of a plain sum show in what a SEL makes of them.
      const bool parallel =
          o.kind == Opcode::media && static_cast<Media>(o.a) == Media::parallel_add && (o.mode & 3) == 0;
      const unsigned steps = parallel ? 2 : 1;
      constexpr std::uint16_t kSel[] = {0xFAA9, 0xF88A};
      for (Memory* m : {&ours.memory, &theirs.memory}) {
        std::memcpy(&m->flash[kCode - Memories::kFlashBase + 4], kSel, 4);
        std::memcpy(&m->flash[kCode - Memories::kFlashBase], &first, 2);
        std::memcpy(&m->flash[kCode - Memories::kFlashBase + 2], &second, 2);
      }
      const std::size_t scratch = kScratch - Memories::kRamBase;
      if (memory) {
        for (std::size_t i = 0; i < kScratchBytes; i += 4) {
          const std::uint32_t word = chance();
          std::memcpy(&ours.memory.ram[scratch + i], &word, 4);
          std::memcpy(&theirs.memory.ram[scratch + i], &word, 4);
        }
      }
      State a = state, b = state;
      if (!ours.step(a, steps) || !theirs.step(b, steps)) continue;
      ++compared;
      std::string found = difference(a, b);
      if (memory && std::memcmp(&ours.memory.ram[scratch], &theirs.memory.ram[scratch], kScratchBytes) != 0)
        found += "memory; ";
      if (found.empty()) continue;
      char encoding[16];
      std::snprintf(encoding, sizeof encoding, "%04X %04X", first, second);
      INFO(family.name << ": " << encoding << ": " << found << "from n " << std::hex << state.r[o.n & 0xF] << " m "
                       << state.r[o.m & 0xF] << " s: " << state.s[o.d & 31] << " " << state.s[o.n & 31] << " "
                       << state.s[o.m & 31]);
      CHECK(found.empty());
      if (++failed == 6) break;
    }
    INFO(family.name);
    CHECK(compared + (failed != 0 ? family.count : 0) >= family.count);
  }
}

namespace {

/// A few instructions in a row, as halfwords.
using Sequence = std::vector<std::uint16_t>;

void put(Sequence& sequence, std::uint32_t code) {
  sequence.push_back(static_cast<std::uint16_t>(code >> 16));
  if (code >> 16 >= 0xE800) sequence.push_back(static_cast<std::uint16_t>(code));
}

/// An IT instruction and its block of sums, shifts, comparisons and immediates.
Sequence it_block(Chance& chance) {
  const std::uint32_t mask = 1 + chance.below(15);
  Sequence result{static_cast<std::uint16_t>(0xBF00 | chance.below(14) << 4 | mask)};
  for (int left = 4 - std::countr_zero(mask); left > 0;) {
    constexpr Family kInside[] = {kFamilies[0], kFamilies[1], kFamilies[4]};
    const Family& family = kInside[chance.below(3)];
    const std::uint32_t code = family.fixed | (chance() & family.free);
    const Operation o = take_apart(static_cast<std::uint16_t>(code >> 16), static_cast<std::uint16_t>(code));
    const bool zero_shift = o.kind == Opcode::mov_reg && o.amount == 0 && code >> 16 < 0xE800;  // not to be in a block
    if (left_out(o, static_cast<std::uint16_t>(code >> 16), static_cast<std::uint16_t>(code)) || zero_shift) continue;
    put(result, code);
    --left;
  }
  return result;
}

/// LDREX{B,H} r1 and STREX{B,H} r3 = r2 at r0, both, one, or with a CLREX between.
Sequence exclusives(Chance& chance) {
  static constexpr std::uint32_t kLoads[] = {0xE8501F00, 0xE8D01F4F, 0xE8D01F5F};
  static constexpr std::uint32_t kStores[] = {0xE8402300, 0xE8C02F43, 0xE8C02F53};
  const std::uint32_t size = chance.below(3);
  Sequence result;
  if (chance.below(4) != 0) put(result, kLoads[size]);
  if (chance.below(4) == 0) put(result, 0xF3BF8F2F);
  put(result, kStores[size]);
  if (chance.below(2) == 0) put(result, kStores[size]);
  return result;
}

std::string difference_after(Ours& ours, Theirs& theirs, const Sequence& sequence, const State& before) {
  const std::size_t scratch = kScratch - Memories::kRamBase;
  for (Memory* m : {&ours.memory, &theirs.memory}) {
    std::memcpy(&m->flash[kCode - Memories::kFlashBase], sequence.data(), 2 * sequence.size());
    std::memset(&m->ram[scratch], 0x5A, kScratchBytes);
  }
  const auto end = static_cast<std::uint32_t>(kCode + 2 * sequence.size());
  State a = before, b = before;
  if (!ours.step(a, 0, end)) return "not run";
  if (!theirs.step(b, 0, end)) return "not run by libunicorn";
  const bool same = std::memcmp(&ours.memory.ram[scratch], &theirs.memory.ram[scratch], kScratchBytes) == 0;
  return difference(a, b) + (same ? "" : "memory");
}

}  // namespace

TEST_CASE("IT blocks and exclusive accesses leave what they leave on libunicorn", "[core]") {
  Ours ours;
  Theirs theirs;
  Chance chance;
  for (unsigned i = 0; i < 6000; ++i) {
    State state{};
    for (std::uint32_t& r : state.r) r = chance.value();
    const bool in_it = i % 4 != 0;
    if (!in_it) state.r[0] = kScratch + 4 * chance.below(64);
    state.r[13] = kScratch;
    state.r[15] = kCode;
    state.flags = chance() & 0xF8000000U;
    const Sequence sequence = in_it ? it_block(chance) : exclusives(chance);
    std::string code;
    for (const std::uint16_t half : sequence) code += text(" ", 0, half, 0).substr(5, 4) + " ";
    INFO(code);
    const std::string found = difference_after(ours, theirs, sequence, state);
    REQUIRE(found == "");
  }
}
