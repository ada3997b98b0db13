#include "generator/wcet/presumed_return.hpp"

namespace finemote::gen::wcet {

Machine presumed_return(Machine machine) {
  for (const int reg : {ARM_REG_R0, ARM_REG_R1, ARM_REG_R2, ARM_REG_R3, ARM_REG_R12, ARM_REG_LR})
    machine.set(reg, Value::in(Interval::any()));
  machine.set_flags(std::nullopt);
  machine.set_exclusive(true);
  machine.keep_link();
  return machine;
}

}  // namespace finemote::gen::wcet
