// Loads and stores of several words, with write-back, exclusive, and of floating-point registers.
#include <bit>
#include <cstring>

#include "emulator/core/interpreter.hpp"

namespace finemote::emulator {

bool Interpreter::transfer(Access what, std::uint32_t address, unsigned t) {
  switch (what) {
    case Access::ldr:
      return transfer<Access::ldr>(address, t);
    case Access::ldrb:
      return transfer<Access::ldrb>(address, t);
    case Access::ldrh:
      return transfer<Access::ldrh>(address, t);
    case Access::ldrsb:
      return transfer<Access::ldrsb>(address, t);
    case Access::ldrsh:
      return transfer<Access::ldrsh>(address, t);
    case Access::str:
      return transfer<Access::str>(address, t);
    case Access::strb:
      return transfer<Access::strb>(address, t);
    default:
      return transfer<Access::strh>(address, t);
  }
}

bool Interpreter::indexed(const Operation& o) {
  const std::uint32_t moved = registers.r[o.n] + o.imm, address = o.mode == 1 ? moved : registers.r[o.n];
  if (!transfer(static_cast<Access>(o.a), address, o.d)) return false;
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
  if (std::uint8_t* to = is_watched(address) ? nullptr : in_ram(address, o.amount)) {
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
    constexpr Access kLoads[] = {Access::ldrb, Access::ldrh, Access::ldr};
    return transfer(kLoads[o.amount], address, o.d);
  }
  if (registers.exclusive) {
    constexpr Access kStores[] = {Access::strb, Access::strh, Access::str};
    if (!transfer(kStores[o.amount], address, o.m)) return false;
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

}  // namespace finemote::emulator
