// The static plan: which stage runs when, in which bucket, and how data crosses from one bucket to another.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "generator/diagnostic/diagnostics.hpp"
#include "generator/forest/forest.hpp"
#include "generator/model/robot.hpp"
#include "generator/units/duration.hpp"

namespace finemote::gen {

/// All devices of one period. A job runs their updates in order, then their handles in reverse order, then flushes.
struct Bucket {
  Duration period;
  std::string label;               ///< `10ms`, part of generated names
  std::uint32_t priority = 0;      ///< NVIC level, 0 is the most urgent
  std::uint32_t line = 0;          ///< interrupt line it runs in
  std::vector<DeviceId> devices;   ///< in schedule order
  std::vector<SegmentId> flushes;  ///< shared outputs written once at the end of a job
};

/// A value moved from one bucket (or tree) to another by the generated schedule.
struct Crossing {
  enum class Direction { state, command };
  enum class Kind {
    to_slow,  ///< the writer preempts the reader: three-slot latch
    to_fast,  ///< the reader preempts the writer: two-slot latch
    copy,     ///< same bucket, other tree: plain copy before the reader's stage
  };
  Direction direction = Direction::state;
  Kind kind = Kind::copy;
  DeviceId producer;   ///< device whose update() (state) or handle() (command) makes the value
  DeviceId consumer;   ///< device whose update() (state) or handle() (command) uses it
  DeviceId home;       ///< device whose tree header holds latch and copy: the parent or reader
  std::string type;    ///< C++ type of the value: `finemote::Imu::State`
  std::string member;  ///< member of the producer (state) or of the consumer (command)
  std::string name;    ///< `imu_to_rov`; the latch adds `_latch`
};

/// What one element of a role is bound to.
struct Binding {
  DeviceId device;  ///< the child or observed device
  bool is_read = false;
  std::optional<std::size_t> state_crossing;    ///< index into Schedule::crossings; none: direct reference
  std::optional<std::size_t> command_crossing;  ///< the same for the command
  bool has_command = false;                     ///< the role's port carries a command
  bool sink = false;      ///< the command goes nowhere: an observed device, or a sensor in a role of `any`
  std::string sink_name;  ///< `rov_depth_sink_1`
  std::string state_member, command_member;
};

/// One role of one device with everything bound to it: children first, then `reads`, each in document order.
struct RoleBinding {
  std::string interface;  ///< C++ tag: `finemote::Thruster`, `finemote::Any`
  bool single = false;    ///< exactly one: passed as a Port; else as an array
  std::string array;      ///< name of the generated array, `rov_depth`; empty when single or nothing is bound
  std::vector<Binding> bindings;
};

/// A transfer slot: one per device and shared bus.
struct Slot {
  SegmentId segment;
  std::optional<DeviceId> device;  ///< whose slot it is: this or `expander`
  std::optional<ExpanderId> expander;
  std::uint32_t address = 0;               ///< i2c address, CAN id or chip select
  std::uint32_t priority = 0;              ///< index of the fastest bucket that uses it: 0 is the most urgent
  std::string name;                        ///< C++ name in namespace slots
  std::uint32_t spi_mode = kUsualSpiMode;  ///< spi: clock mode of its transfers, CPOL * 2 + CPHA
};

struct Schedule {
  std::vector<Bucket> buckets;                      ///< shortest period first
  Table<DeviceId, std::size_t> bucket_of;           ///< index into buckets
  std::vector<Crossing> crossings;                  ///< in schedule order of their consumers
  Table<DeviceId, std::vector<RoleBinding>> roles;  ///< in DeviceType::roles order
  std::vector<Slot> slots;                          ///< per physical bus in document order, most urgent first
};

/// Plans buckets rate-monotonically (paper section 4.2) on the lines and levels of the board.
/// Reports FM3201 (more buckets than lines or levels) and FM3202 (two generated names are the same).
Schedule plan_schedule(const Robot& robot, const Forest& forest, Diagnostics& diagnostics);

}  // namespace finemote::gen
