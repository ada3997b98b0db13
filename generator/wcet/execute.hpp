// One instruction on a machine.
#pragma once

#include <cstdint>
#include <map>

#include "generator/image/instruction.hpp"
#include "generator/wcet/constants.hpp"
#include "generator/wcet/machine.hpp"

namespace finemote::gen::wcet {

/// All that is stored in words, by address.
using WordStores = std::map<std::uint32_t, Interval>;

/// What an image is to its instructions.
struct Surroundings {
  const Constants& constants;
  Unknowns& unknowns;
  WordStores* stores = nullptr;  ///< not null: gathers what is stored at constant addresses outside the stack
  /// An exception may come between an exclusive load and its store, which fails then; else none does.
  bool exclusive_may_fail = false;
};

/// The flags of `left - right`, whose values are in these registers, if in any.
Comparison comparison_of(Value a, Value b, int left, int right);

/// Carries out an instruction whose condition holds. Whatever it may change and is not modelled becomes unknown.
/// Source: ARMv7-M A7.7.
void execute(const Instruction& instruction, const Surroundings& surroundings, Machine& machine);

}  // namespace finemote::gen::wcet
