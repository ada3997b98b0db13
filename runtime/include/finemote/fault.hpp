// Counts what went wrong as (module, number), and stops the robot safely when it cannot go on.
#pragma once

#include <cstdint>

/// A text for whoever listens: kept out of the images of boards nobody listens to (board.cmake defines
/// FINEMOTE_SILENT).
#ifdef FINEMOTE_SILENT
#define FINEMOTE_TEXT(text) nullptr
#else
#define FINEMOTE_TEXT(text) text
#endif

namespace finemote {

/// Who reports a fault. A number means one thing in its module: a bus counts from 1, the board's driver of its port
/// from 16 (PWM the other way round). docs/reference/faults.md lists them.
enum class Module : std::uint8_t {
  core = 1,  ///< processor faults, unexpected interrupts, stack guard: see CoreFault
  schedule,  ///< the schedule cannot run on this board, or overran
  order,     ///< a parent was constructed before its child; number: index of the check
  uart,
  i2c,
  spi,
  can,
  pwm,
  rs485,
  gpio,
  device,
  board,
};

/// Numbers of Module::core.
enum class CoreFault : std::uint8_t {
  hard = 1,
  memory,
  bus,
  usage,
  nmi,
  stack,                 ///< the stack guard was touched
  unexpected_interrupt,  ///< a line without a routine
  code_copy,             ///< the copy of the code in SRAM was wrong, and was made again
};

/// Numbers of Module::schedule.
enum class ScheduleFault : std::uint8_t {
  empty = 1,      ///< no buckets
  bad_tick,       ///< the tick is no whole number of core cycles, or longer than the release timer
  bad_period,     ///< a period is not a multiple of the tick
  bad_lines,      ///< the lines are not all in one word of the interrupt controller
  too_many,       ///< more buckets than the scheduler has room for
  not_monotonic,  ///< a longer period has the more urgent priority
  overrun,        ///< a bucket was released while pending or running (counted)
  no_timer,       ///< the release timer does not count
};

/// How often something went wrong.
struct FaultRecord {
  Module module;        ///< who reported it
  std::uint8_t number;  ///< what it is, in its module
  std::uint16_t count;  ///< sticks at 65535
};

/// Number of different (module, number) pairs that are kept; further ones only raise faults_lost().
inline constexpr unsigned kFaultRecords = 16;

/// Counts a fault the caller has survived. Bounded; from everywhere, interrupts included.
void count_fault(Module module, std::uint8_t number);

/// How often this fault was counted. Context: any.
std::uint16_t fault_count(Module module, std::uint8_t number);

/// Record `index` < kFaultRecords; count 0 when there is none. Context: any.
FaultRecord fault_record(unsigned index);
/// Faults that were counted in no record, because all were taken. Context: any.
std::uint32_t faults_lost();

/// Counts the fault, brings every actuator to its safe output and does not return: the buses and the watchdog live on.
/// `text` explains it to whoever listens (semihosting, host); may be null.
[[noreturn]] void stop_safely(Module module, std::uint8_t number, const char* text = nullptr);

}  // namespace finemote
