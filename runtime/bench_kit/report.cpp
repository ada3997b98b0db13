#include "report.hpp"

#include "record.hpp"
#include "runtime/chips/stm32f4/wait.hpp"
#include "uart_line.hpp"

namespace finemote::bench_kit {
namespace {

namespace usart = stm32f4::usart;

char text[kReportBytes];

/// RTT's control block with one buffer up, as SEGGER's probes and others look for it.
struct RttControl {
  char id[16];
  std::int32_t up_buffers, down_buffers;
  const char* name;
  char* buffer;
  std::uint32_t size;
  volatile std::uint32_t write, read;
  std::uint32_t flags;  ///< 0: what does not fit is left out
};

}  // namespace
}  // namespace finemote::bench_kit

extern "C" {
extern finemote::bench_kit::RttControl _SEGGER_RTT;
__attribute__((used)) finemote::bench_kit::RttControl _SEGGER_RTT{
    "SEGGER RTT", 1, 0, "finemote bench", finemote::bench_kit::text, sizeof finemote::bench_kit::text, 0, 0, 0};
}

namespace finemote::bench_kit {
namespace {

/// Appends to the text; what does not fit is left out, so that a reader sees that the line has no end.
class Writer {
 public:
  Writer& operator<<(const char* words) {
    while (*words != '\0') add(*words++);
    return *this;
  }
  Writer& operator<<(std::uint32_t number) {
    char digits[10];
    unsigned count = 0;
    do {
      digits[count++] = static_cast<char>('0' + number % 10);
      number /= 10;
    } while (number != 0);
    while (count != 0) add(digits[--count]);
    return *this;
  }
  [[nodiscard]] std::uint32_t size() const { return size_; }

 private:
  void add(char c) {
    if (size_ + 1 < sizeof text) text[size_++] = c;
  }

  std::uint32_t size_ = 0;
};

const char* words_for(Missing missing) {
  switch (missing) {
    case Missing::answer:
      return "no answer in time";
    case Missing::clock:
      return "the clock of the board does not run";
    case Missing::restart:
      return "the board was reset in the middle of it";
    default:
      return "not run";
  }
}

void write_expected(Writer& out, const Planned& test) {
  if (!test.is_judged) {
    out << "null";
  } else if (test.least == test.most) {
    out << test.least;
  } else {
    out << R"({"min":)" << test.least << R"(,"max":)" << test.most << "}";
  }
}

void write_test(Writer& out, const Planned& test, const Entry& found) {
  out << R"({"name":")" << test.name << R"(","value":)";
  const bool is_done = found.missing == Missing::nothing;
  if (is_done) {
    out << found.value;
  } else {
    out << "null";
  }
  out << R"(,"expected":)";
  write_expected(out, test);
  const bool is_ok = is_done && (!test.is_judged || (found.value >= test.least && found.value <= test.most));
  out << R"(,"ok":)" << (is_ok ? "true" : "false");
  if (!is_done) out << R"(,"why":")" << words_for(found.missing) << R"(")";
  out << "}";
}

/// What only lacks a jumper or a partner has not failed: it stands apart.
bool lacks_partner(unsigned test) { return entry(test).missing == Missing::partner; }

void write_tests(Writer& out) {
  const char* between = "";
  for (unsigned i = 0; i < kTestCount; ++i) {
    if (lacks_partner(i)) continue;
    out << between;
    between = ",";
    write_test(out, kTests[i], entry(i));
  }
}

void write_not_done(Writer& out) {
  const char* between = "";
  for (unsigned i = 0; i < kTestCount; ++i) {
    if (!lacks_partner(i)) continue;
    out << between << R"({"name":")" << kTests[i].name << R"(","why":")" << kTests[i].needs << R"("})";
    between = ",";
  }
}

}  // namespace

void write_report() {
  Writer out;
  out << R"({"schema":"finemote.bench/1","board":")" << kBoardName << R"(","robot":")" << kRobotName << R"(","plan":")"
      << kPlanName << R"(","tests":[)";
  write_tests(out);
  out << R"(],"not_done":[)";
  write_not_done(out);
  out << "]}\n";
  _SEGGER_RTT.write = out.size();
}

void send_report(std::uint32_t bus_hz) {
  start_uart(kReportPort, bus_hz, usart::kTransmitterOn);
  const stm32f4::UsartRegisters registers = kReportPort.peripheral.usart;
  // Three bytes of ten bits; a poll takes at least four cycles of the core, which is never slower than the bus.
  const std::uint32_t polls = 3 * 10 * 2 * (bus_hz / kReportBaud);
  for (std::uint32_t i = 0; i < _SEGGER_RTT.write; ++i) {
    if (!stm32f4::wait_for(registers.sr(), usart::kTransmitEmpty, usart::kTransmitEmpty, polls)) return;
    registers.dr().write(static_cast<unsigned char>(text[i]));
  }
}

}  // namespace finemote::bench_kit
