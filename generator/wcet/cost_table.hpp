// All numbers of cycles that a bound is made of: of instructions, of fetching them, and of what they access.
#pragma once

#include <optional>
#include <vector>

#include "generator/image/instruction.hpp"
#include "generator/wcet/memory_map.hpp"

namespace finemote::gen::wcet {

/// Documented maxima. Sources of instructions, with memory that never lets them wait: Cortex-M4 TRM (DDI 0439D) tables
/// 3-1 and 7-1 with the notes of 3.3: an address that the instruction before computed costs a cycle, a result of the
/// FPU that the next one takes another, a refill of the pipeline three. tests/wcet/documents.hpp holds each to its row.
struct CostTable {
  /// What accesses memory, and takes what its operands say.
  enum class Kind { single, exclusive, two, several, stack, float_single, float_two };

  struct Row {
    unsigned id;  ///< ARM_INS_*
    Cycles cycles;
  };
  /// Of instructions whose time does not depend on operands, without the refill where they go elsewhere. One that is
  /// in no row and accesses no memory has no documented maximum, or no place in code that must end in time (WFI, SVC).
  std::vector<Row> fixed = {};

  Cycles single = 3;             ///< a load or store of one word, halfword or byte
  Cycles exclusive = 3;          ///< LDREX, STREX and their like
  Cycles two = 4;                ///< LDRD, STRD
  Cycles float_single = 3;       ///< VLDR, VSTR of a single
  Cycles float_two = 4;          ///< of a double
  Cycles several = 2, word = 1;  ///< load and store multiple: once, and for each word

  /// Accesses that a word, or a halfword, takes besides where it is not aligned: TRM 3.3.2. Each costs a cycle, and
  /// waits.
  Cycles unaligned_word = 2, unaligned_half = 1;

  Cycles taken = 3;    ///< the refill: besides, after a branch that is taken, a call and a return
  Cycles skipped = 1;  ///< an instruction in an IT block whose condition fails

  Cycles straddling = 1;      ///< a wide instruction at an odd halfword may starve the decoder: not documented
  Cycles wait_states = 5;     ///< of a line of flash at 168 MHz and 2.7 V: RM0090 table 10
  Cycles read_in_flight = 6;  ///< a whole line of flash before it: reads cannot be taken back

  /// Of a routine that uses the FPU: the registers of what it interrupts are saved at the first such instruction, 17
  /// words and a wait for the last, and restored by a return of 27 cycles in place of 10: TRM 3.9.1.
  Cycles fpu_context = 35;

  MemoryWaits waits = {};
};

/// The one that bounds are made with.
const CostTable& documented_costs();

/// Cycles of an instruction that runs; none: it has no known maximum.
std::optional<Cycles> longest_time(const Instruction& instruction, const CostTable& table = documented_costs());

}  // namespace finemote::gen::wcet
