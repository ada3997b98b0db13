#include "generator/timing/assumptions.hpp"

namespace finemote::gen::timing {
namespace {

using enum Assumption::Detected;

constexpr Assumption kAssumptions[] = {
    {"declared-nodes", "only parts of the robot's devices and expanders send on a bus", undetectable},
    {"declared-traffic",
     "a device and its part send no more frames than the descriptor declares, no longer ones, and on CAN no shorter "
     "ones; the device asks in the stage that its descriptor names, and reads its serial line in update(); a part that "
     "is asked on a serial line answers at once, and on CAN within the time that its descriptor gives a measurement; "
     "where a device has several requests over one connection in a job, none goes again while another waits",
     undetectable},
    {"part-clocks",
     "the clock of a part is off by tolerance_ppm of its descriptor at most, and a measurement takes no "
     "longer than the descriptor says",
     counted},
    {"board-clock",
     "the clock of the board is off by clock_ppm of the board file at most, and its rate is constant "
     "over the length of a bound",
     undetectable},
    {"bring-up", "every part has been set up and sent or measured its first sample", undetectable},
    {"bus-errors", "no frame is damaged, lost or refused, and no line is noisy", counted},
    {"recovery", "no bus is being recovered, and no part is being set up again", counted},
    {"clock-stretching", "no part on I2C holds the clock line", undetectable},
    {"execution-times", "a stage takes no longer than its execution time in the model", counted},
    {"deadlines", "every job ends within its period; where the verdict is schedulable, this follows from the others",
     counted},
    {"compiler",
     "the runtime's own costs are those of the shipped sources with the compiler and the options that "
     "finemote run uses",
     undetectable},
    {"flash",
     "where the code runs in flash, instructions and data are found in the accelerator, as where the runtime's own "
     "costs were measured",
     undetectable},
    {"supply", "the supply stays at 2.7 V or more, which the wait states of the flash are for", undetectable},
    {"flash-write", "nobody erases or programs the flash while the robot runs", undetectable},
    {"debugger", "no debugger halts the core or reads memory while the robot runs", undetectable},
    {"dma-beats", "every DMA stream moves single items: none holds the bus for a burst", undetectable},
    {"bus-masters", "nothing but the core and the DMA streams of the robot's buses accesses memory", undetectable},
    {"interrupts", "no interrupts are enabled but the release, the buckets and those of buses and declared lines",
     stopped},
    {"masked-sections", "nobody but the runtime masks interrupts", undetectable},
    {"stack", "the stack stays inside its region", stopped},
};

}  // namespace

std::span<const Assumption> assumptions() { return kAssumptions; }

std::string_view to_string(Assumption::Detected detected) {
  switch (detected) {
    case counted:
      return "counted";
    case stopped:
      return "stopped";
    case undetectable:
      return "undetectable";
  }
  return "";
}

}  // namespace finemote::gen::timing
