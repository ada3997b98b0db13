#include "report.hpp"

#include "finemote/bus_counters.hpp"
#include "finemote/fault.hpp"
#include "finemote/monitor.hpp"
#include "finemote/schedule.hpp"
#include "runtime/chips/cortex_m4/trace.hpp"
#include "semihosting.hpp"

namespace finemote::qemu_f405 {
namespace {

/// One line of text under construction.
class Line {
 public:
  explicit Line(char tag) { text_[0] = tag; }
  Line& number(std::uint64_t value) {
    char digits[20];
    unsigned count = 0;
    do digits[count++] = static_cast<char>('0' + value % 10);
    while ((value /= 10) != 0);
    text_[size_++] = ' ';
    while (count > 0) text_[size_++] = digits[--count];
    return *this;
  }
  Line& word(char letter) {
    text_[size_++] = ' ';
    text_[size_++] = letter;
    return *this;
  }
  void write() {
    text_[size_++] = '\n';
    text_[size_] = '\0';
    qemu_f405::write(text_);
  }

 private:
#ifdef FINEMOTE_MONITOR
  char text_[112];  // five numbers of 20 digits at most
#else
  char text_[80];  // three numbers of 20 digits at most
#endif
  unsigned size_ = 1;
};

#ifdef FINEMOTE_TRACE

// Cycle counts wrap every 25.6 s; two events in a row are never that far apart in the same run of stages.
class Unwrapped {
 public:
  std::uint64_t operator()(std::uint32_t cycles) {
    return total_ += static_cast<std::uint32_t>(cycles - static_cast<std::uint32_t>(total_));
  }

 private:
  std::uint64_t total_ = 0;
};

Unwrapped unwrap;

#endif

}  // namespace

void report_events() {
#ifdef FINEMOTE_TRACE
  TraceEvent event;
  while (cortex_m4::take_event(event)) {
    const std::uint64_t ns = unwrap(event.cycles) * 125 / 21;
    Line('E').number(ns).number(event.code >> 1).word((event.code & 1U) != 0 ? 'E' : 'B').write();
  }
#endif
}

void report_run() {
  report_events();
  for (unsigned i = 0; i < finemote_schedule.buckets.size(); ++i) Line('O').number(i).number(overruns(i)).write();
  unsigned number = 0;
  for (const BusCounters* bus = first_bus(); bus != nullptr; bus = bus->next) {
    Line('B').number(number++).number(bus->transfers).number(bus->errors).write();
  }
  for (unsigned i = 0; i < kFaultRecords && fault_record(i).count != 0; ++i) {
    const FaultRecord record = fault_record(i);
    Line('F').number(static_cast<unsigned>(record.module)).number(record.number).number(record.count).write();
  }
#ifdef FINEMOTE_MONITOR
  for (unsigned i = 0; i < finemote_monitor.devices.size(); ++i) {
    const MonitorRecord& record = finemote_monitor.records[i];
    Line line('M');
    line.number(i).number(static_cast<std::uint64_t>(record.response_max));
    line.number(static_cast<std::uint64_t>(record.age_max)).number(record.response_violations);
    line.number(record.age_violations).write();
  }
#endif
#ifdef FINEMOTE_TRACE
  if (cortex_m4::lost_events() != 0) Line('L').number(cortex_m4::lost_events()).write();
#endif
}

void report_stop() { Line('S').number(static_cast<std::uint64_t>(now())).write(); }

}  // namespace finemote::qemu_f405
