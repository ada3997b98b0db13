#include "generator/descriptor/check_clocks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>

namespace finemote::gen {
namespace {

/// The clocks of the STM32F405 and F407 at their fastest (DS8626, table 14), which drivers, measured costs, waits for
/// memory (generator/wcet) and the emulated chip were made and measured for. Costs are nanoseconds, and neither those
/// of the core nor those of the buses would follow other clocks.
constexpr std::int64_t kCoreHz = 168'000'000, kApb1Hz = 42'000'000, kApb2Hz = 84'000'000;
constexpr std::uint32_t kFlashWaitStates = 5;

/// RM0090 7.3.2: what enters the PLL, of which the driver takes two, and what it makes of it.
constexpr std::array<std::int64_t, 2> kInputsHz{2'000'000, 1'000'000};
constexpr std::int64_t kSlowestVcoHz = 100'000'000, kFastestVcoHz = 432'000'000, kFastestUsbHz = 48'000'000;

/// Peripherals of APB2, RM0090, table 1; the other ones that ports are made of hang on APB1.
constexpr std::string_view kOnApb2[] = {"usart1", "usart6", "spi1", "adc3", "TIM1", "TIM8", "TIM9", "TIM10", "TIM11"};

/// Timers of a bus that is divided run twice as fast: RM0090 7.2.
std::int64_t clock_of(const Port& port) {
  const std::string& peripheral = port.timer ? port.timer->timer : port.name;
  const bool is_on_apb2 = std::find(std::begin(kOnApb2), std::end(kOnApb2), peripheral) != std::end(kOnApb2);
  return (port.timer ? 2 : 1) * (is_on_apb2 ? kApb2Hz : kApb1Hz);
}

/// The "pll" that makes this clock of a crystal; empty: there is none.
std::string pll_for(std::int64_t crystal_hz, std::int64_t core_hz) {
  constexpr std::int64_t kP = 2;
  const std::int64_t q = ceil_div(kP * core_hz, kFastestUsbHz);
  for (const std::int64_t input : kInputsHz) {
    const bool is_whole = crystal_hz % input == 0 && kP * core_hz % input == 0;
    if (!is_whole || crystal_hz / input < 2 || crystal_hz / input > 63 || kP * core_hz / input > 432) continue;
    return fmt::format("\"pll\": {{ \"m\": {}, \"n\": {}, \"p\": {}, \"q\": {} }}", crystal_hz / input,
                       kP * core_hz / input, kP, q);
  }
  return {};
}

class ClockCheck {
 public:
  ClockCheck(const Board& board, const Contradictions& found) : board_(board), found_(found), clocks_(*board.clocks) {}

  void run() {
    const bool can_run = makes_the_core() && can_be_made();
    if (can_run && board_.is_emulated && has_known_times()) check_ports();
  }

 private:
  [[nodiscard]] std::int64_t wanted_hz() const { return board_.is_emulated ? kCoreHz : board_.cpu_hz; }
  [[nodiscard]] std::int64_t vco_hz() const { return std::int64_t{clocks_.crystal_hz} * clocks_.pll_n / clocks_.pll_m; }

  bool makes_the_core() {
    const std::int64_t product = std::int64_t{clocks_.crystal_hz} * clocks_.pll_n;
    const std::int64_t divider = std::int64_t{clocks_.pll_m} * clocks_.pll_p;
    if (product == board_.cpu_hz * divider) return true;
    Diagnostic& finding =
        found_.add(found_.nearest({"cpu", "clock_hz"}, {"clocks"}),
                   fmt::format("the core is to run at {} Hz, but {} Hz of the crystal x n / m / p is {} Hz",
                               board_.cpu_hz, clocks_.crystal_hz, product / divider));
    const bool is_whole = product % divider == 0;
    if (is_whole && (!board_.is_emulated || product == kCoreHz * divider))
      finding.hint(fmt::format("this crystal and \"pll\" make \"clock_hz\": {}", product / divider));
    else if (const std::string pll = pll_for(clocks_.crystal_hz, wanted_hz()); !pll.empty())
      finding.hint(fmt::format("with this crystal: {}", pll));
    return false;
  }

  bool can_be_made() {
    const std::int64_t input = clocks_.crystal_hz / clocks_.pll_m;
    const bool is_input = std::find(kInputsHz.begin(), kInputsHz.end(), input) != kInputsHz.end();
    if (!is_input) return refuse("m", fmt::format("the PLL takes 1 or 2 MHz, and the crystal by m is {} Hz", input));
    if (vco_hz() < kSlowestVcoHz || vco_hz() > kFastestVcoHz)
      return refuse("n", fmt::format("the VCO of the PLL runs at {} to {} Hz, and the crystal by m times n is {} Hz",
                                     kSlowestVcoHz, kFastestVcoHz, vco_hz()));
    if (vco_hz() > kFastestUsbHz * clocks_.pll_q)
      return refuse("q", fmt::format("the clock for USB is {} Hz at most, and the VCO by q is {} Hz", kFastestUsbHz,
                                     vco_hz() / clocks_.pll_q));
    return true;
  }

  bool refuse(const char* divider, const std::string& why) {
    Diagnostic& finding = found_.add({"clocks", "pll", divider}, why);
    if (const std::string pll = pll_for(clocks_.crystal_hz, wanted_hz()); !pll.empty())
      finding.hint(fmt::format("with this crystal: {}", pll));
    return false;
  }

  bool has_known_times() {
    return is_known({"cpu", "clock_hz"}, board_.cpu_hz, kCoreHz, " Hz") &&
           is_known({"clocks", "apb1_hz"}, clocks_.apb1_hz, kApb1Hz, " Hz") &&
           is_known({"clocks", "apb2_hz"}, clocks_.apb2_hz, kApb2Hz, " Hz") &&
           is_known({"clocks", "flash_wait_states"}, clocks_.flash_wait_states, kFlashWaitStates, " wait states");
  }
  bool is_known(const JsonPath& path, std::int64_t value, std::int64_t known, const char* unit) {
    if (value == known) return true;
    found_.add(path, fmt::format("the costs of this chip are known for {}{}, not for {}{}", known, unit, value, unit))
        .note("with another clock no bound would be proven")
        .hint(fmt::format("\"{}\": {}", path.back(), known));
    return false;
  }

  void check_ports() {
    for (std::size_t i = 0; i < board_.ports.size(); ++i) {
      const Port& port = board_.ports[i];
      if (!port.clock_hz || *port.clock_hz == clock_of(port)) continue;
      found_
          .add({"ports", std::to_string(i), "clock_hz"},
               fmt::format("port '{}' is clocked with {} Hz, not {} Hz", port.name, clock_of(port), *port.clock_hz))
          .hint(fmt::format("\"clock_hz\": {}", clock_of(port)));
    }
  }

  const Board& board_;
  const Contradictions& found_;
  const Clocks& clocks_;
};

}  // namespace

void check_clocks(const Board& board, const Contradictions& found) {
  if (board.chip != "stm32f4" || board.stands_in) return;
  if (!board.clocks) {
    found.add({"clocks"}, "there are no clocks: nothing says what the core's is made of");
    return;
  }
  ClockCheck(board, found).run();
}

}  // namespace finemote::gen
