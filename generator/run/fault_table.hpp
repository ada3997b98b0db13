// What the faults mean that a firmware counts: `schemas/faults.json`, the table of docs/reference/faults.md.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "generator/diagnostic/diagnostics.hpp"

namespace finemote::gen {

/// A fault the firmware counted: finemote::FaultRecord.
struct FaultCount {
  unsigned module = 0, number = 0, count = 0;
};

struct FaultMeaning {
  unsigned module = 0;
  std::optional<unsigned> number;  ///< none: every number of the module
  std::string module_name, what, effect;
  bool stops = false;    ///< the firmware goes to its safe stop and stays there
  bool overrun = false;  ///< it does where the board's param 'overrun' is 'safe_stop'
};

using FaultTable = std::vector<FaultMeaning>;

/// Reads the table. @throws std::runtime_error when it is missing or broken
FaultTable load_fault_table(const std::string& data_dir);

/// Null: the table has no such fault.
const FaultMeaning* meaning_of(const FaultTable& table, const FaultCount& fault);

/// `inverted line on a port without inverter (uart 16)`; with a count above one how often.
std::string fault_text(const FaultTable& table, const FaultCount& fault);

/// The fault that stopped the firmware: the first one that stops; null when none does. `overrun_stops`: an overrun
/// does, too, as the board's param asked for.
const FaultCount* stopping_fault(const FaultTable& table, const std::vector<FaultCount>& faults, bool overrun_stops);

/// Reports FM6002: `stopped` is the fault, one of `faults`, `when` says when (`at 20 ms`).
void report_safe_stop(const FaultTable& table, const std::vector<FaultCount>& faults, const FaultCount& stopped,
                      const std::string& when, Diagnostics& diagnostics);

}  // namespace finemote::gen
