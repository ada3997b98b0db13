// Every way to use the hardware wrongly that the emulator reports, each beside the same done rightly, which it must not
// report. Late interrupt flags have a test of their own.
#include <functional>

#include "catch.hpp"
#include "emulator/parts/tca9548a.hpp"
#include "tests/emulator/bench.hpp"

using namespace finemote::emulator;

namespace {

constexpr std::uint32_t kRccCr = 0x40023800, kPllcfgr = 0x40023804, kCfgr = 0x40023808, kAhb1 = 0x40023830,
                        kApb1 = 0x40023840, kApb2 = 0x40023844, kFlash = 0x40023C00;
constexpr std::uint32_t kTim4 = 0x40000800, kUsart6 = 0x40011400, kI2c2 = 0x40005800, kSpi1 = 0x40013000,
                        kCan1 = 0x40006400, kAdc = 0x40012000, kDma1 = 0x40026000, kDma2 = 0x40026400,
                        kGpioF = 0x40021400, kExti = 0x40013C00, kSyscfg = 0x40013800, kPower = 0x40007000;

/// One rule: `use` breaks it when told to.
struct Rule {
  const char* what;
  const char* text;  ///< of the report
  std::function<void(Bench& bench, bool wrong)> use;
};

void check(Misuse misuse, const std::vector<Rule>& rules) {
  for (const Rule& rule : rules) {
    for (const bool wrong : {true, false}) {
      INFO(rule.what << (wrong ? ", wrong" : ", right"));
      Bench bench;
      rule.use(bench, wrong);
      bool found = false;
      for (const Report& report : bench.board.reports()) {
        INFO(name_of(report.misuse) << ": " << report.text);
        CHECK(wrong);
        CHECK(report.misuse == misuse);
        found = found || report.text.find(rule.text) != std::string::npos;
      }
      CHECK(found == wrong);
    }
  }
}

void clocks_on(Bench& bench) {
  bench.write(kAhb1, 0x1FF | 3U << 21);
  bench.write(kApb1, 1U << 2 | 1U << 22 | 1U << 25 | 1U << 28);
  bench.write(kApb2, 1U << 5 | 1U << 10 | 1U << 12 | 1U << 14);
}

/// The PLL on the crystal of 12 MHz, and the core on it.
void run_fast(Bench& bench, std::uint32_t m, std::uint32_t n, std::uint32_t prescalers, std::uint32_t wait_states) {
  bench.write(kRccCr, 0x83 | 1U << 16);
  bench.run(3'000'000);
  bench.write(kPllcfgr, m | n << 6 | 1U << 22 | 7U << 24);
  bench.write(kFlash, wait_states);
  bench.write(kRccCr, 0x83 | 1U << 16 | 1U << 24);
  bench.run(1'000'000);
  bench.write(kCfgr, prescalers | 2);
}
constexpr std::uint32_t kPrescalers = 5U << 10 | 4U << 13;

void move_memory(Bench& bench, std::uint32_t from, std::uint32_t to) {
  clocks_on(bench);
  bench.write(kDma2 + 0x18, from);
  bench.write(kDma2 + 0x1C, to);
  bench.write(kDma2 + 0x14, 4);
  bench.write(kDma2 + 0x10, 2U << 6 | 1U << 9 | 1U << 10 | 1);
  bench.run(100'000);
}

void start_usart(Bench& bench, std::uint32_t control1 = 0x200C, std::uint32_t control2 = 0) {
  clocks_on(bench);
  bench.write(kUsart6 + 0x08, 139);  // 115108 baud at 16 MHz
  bench.write(kUsart6 + 0x10, control2);
  bench.write(kUsart6 + 0x0C, control1);
}

void start_i2c(Bench& bench, std::uint32_t mhz = 16) {
  clocks_on(bench);
  bench.write(kI2c2 + 0x04, mhz);
  bench.write(kI2c2 + 0x1C, 80);
  bench.write(kI2c2, 1);
}

/// The START was sent; SR1 is not read.
void i2c_start(Bench& bench) {
  start_i2c(bench);
  bench.write(kI2c2, 0x101);
  bench.run(50'000);
}

void start_spi(Bench& bench, std::uint32_t control = 0x344) {
  clocks_on(bench);
  bench.write(kSpi1, control);
}

void start_can(Bench& bench) {
  clocks_on(bench);
  bench.write(kCan1, 1);
  bench.write(kCan1 + 0x1C, 0x001B0001);
}

void start_adc(Bench& bench, std::uint64_t stable_ns = 10'000) {
  clocks_on(bench);
  bench.write(kGpioF, 3U << 20);  // PF10 analog
  bench.write(kAdc + 0x304, 1U << 16);
  bench.write(kAdc + 0x234, 8);
  bench.write(kAdc + 0x208, 1);
  bench.run(stable_ns);
}

SpiPart deaf_part() {
  return SpiPart{[](bool) {}, [](std::uint8_t) { return std::uint8_t{0}; }};
}
/// Chip selects of the board: PA4 and PB0, high.
void attach_two(Bench& bench) {
  bench.board.chip().attach_spi("spi1", 0, deaf_part());
  bench.board.chip().attach_spi("spi1", 1, deaf_part());
  clocks_on(bench);
  bench.write(0x40020018, 1U << 4);
  bench.write(0x40020418, 1);
  bench.write(0x40020000, 0xA8000000 | 1U << 8);
  bench.write(0x40020400, 0x280 | 1);
}

}  // namespace

TEST_CASE("a peripheral before its clock") {
  check(Misuse::unclocked, {{"write", "usart6 is touched before its clock is on",
                             [](Bench& b, bool wrong) {
                               b.write(kApb2, wrong ? 1U << 4 : 1U << 5);  // USART1's, or its own
                               b.write(kUsart6 + 0x08, 139);
                             }},
                            {"read", "gpiof is touched before its clock is on",
                             [](Bench& b, bool wrong) {
                               if (!wrong) b.write(kAhb1, 1U << 5);
                               b.read(kGpioF + 0x10);
                             }},
                            {"turned off again", "spi1 is touched", [](Bench& b, bool wrong) {
                               b.write(kApb2, 1U << 12);
                               b.read(kSpi1 + 8);
                               if (wrong) b.write(kApb2, 0);
                               b.read(kSpi1 + 8);
                             }}});
}

TEST_CASE("registers and bits nobody models") {
  const auto bits = [](std::uint32_t address, std::uint32_t bad, std::uint32_t good) {
    return [=](Bench& b, bool wrong) {
      clocks_on(b);
      b.write(address, wrong ? bad : good);
    };
  };
  check(Misuse::unmodelled,
        {{"peripheral", "peripheral address", [](Bench& b, bool wrong) { b.read(wrong ? 0x40015C00 : kRccCr); }},
         {"register", "register at offset 0x88", [](Bench& b, bool wrong) { b.read(wrong ? kRccCr + 0x88 : kRccCr); }},
         {"register written", "register at offset 0x88 written",
          [](Bench& b, bool wrong) { b.write(wrong ? kRccCr + 0x88 : kAhb1, 1); }},
         {"core register", "core register 0xE000ED3C",
          [](Bench& b, bool wrong) { b.read_core(wrong ? 0xE000ED3C : 0xE000ED28); }},
         {"traps of divisions by zero", "core register CCR bit 0x00000010",
          [](Bench& b, bool wrong) { b.write_core(0xE000ED14, wrong ? 0x218 : 0x208); }},
         {"middle of a register", "middle",
          [](Bench& b, bool wrong) {
            clocks_on(b);
            b.board.chip().write(kUsart6 + (wrong ? 9 : 8), 1, 139);
          }},
         {"clock output; the read-only status of the switch", "rcc CFGR bits", bits(kCfgr, 1U << 21, 0xC)},
         {"power down", "pwr CR bits", bits(kPower, 0x4002, 0x4000)},
         {"LIN", "usart6 CR2 bits", bits(kUsart6 + 0x10, 1U << 14, 2U << 12)},
         {"reserved bit of a USART", "usart6 CR1 bits", bits(kUsart6 + 0x0C, 1U << 14, 1U << 15)},
         {"half duplex", "usart6 CR3 bits", bits(kUsart6 + 0x14, 8, 0xC1)},
         {"reserved bit of I2C", "i2c2 CR2 bits", bits(kI2c2 + 0x04, 1U << 13 | 16, 1U << 11 | 16)},
         {"SMBus", "i2c2 CR1 bits", bits(kI2c2, 3, 1)},
         {"least significant bit first", "spi1 CR1 bits", bits(kSpi1, 0x3C4, 0xB44)},
         {"I2S", "spi1 I2SCFGR bits", bits(kSpi1 + 0x1C, 0x800, 0)},
         {"TI frames", "spi1 CR2 bits", bits(kSpi1 + 4, 0x10, 0xE7)},
         {"peripheral flow control", "SxCR bits", bits(kDma2 + 0x10, 0x20, 0x40)},
         {"compare mode", "compare mode", bits(kTim4 + 0x18, 0x30, 0x68)},
         {"input", "CCMR bits", bits(kTim4 + 0x1C, 1, 0x6800)},
         {"counting down", "tim4 CR1 bits", bits(kTim4, 0x10, 0x80)},
         {"complementary output", "tim4 CCER bits", bits(kTim4 + 0x20, 5, 0x1113)},
         {"DMA request of a timer", "tim4 DIER bits", bits(kTim4 + 0x0C, 0x100, 3)},
         {"slave mode", "tim4 SMCR bits", bits(kTim4 + 0x08, 4, 3)},
         {"burst of a timer", "tim4 DMA bits", bits(kTim4 + 0x48, 1, 0)},
         {"repetition counter", "tim1 RCR bits",
          [](Bench& b, bool wrong) {
            b.write(kApb2, 1);
            b.write(0x40010000 + 0x30, wrong ? 1 : 0);
          }},
         {"break input", "tim1 BDTR bits",
          [](Bench& b, bool wrong) {
            b.write(kApb2, 1);
            b.write(0x40010000 + 0x44, wrong ? 0x9000 : 0xA000);  // its polarity alone does nothing
          }},
         {"extended frame", "extended or remote frame",
          [](Bench& b, bool wrong) {
            start_can(b);
            b.write(kCan1 + 0x180, 0x123U << 21 | (wrong ? 4U : 0) | 1);
          }},
         {"time triggered", "can1 MCR bits", bits(kCan1, 0x81, 5)},
         {"injected conversion", "adc3 CR2 bits", bits(kAdc + 0x208, 1U << 22 | 1, 3)},
         {"trigger of a timer", "adc3 trigger", bits(kAdc + 0x208, 1U << 28 | 1, 1)},
         {"event", "exti EMR bits", bits(kExti + 4, 1, 0)},
         {"internal line", "exti line bits", bits(kExti, 1U << 17, 0xFFFF)},
         {"system memory at 0", "syscfg MEMRMP", [](Bench& b, bool wrong) {
            clocks_on(b);
            b.write(kSyscfg, wrong ? 1 : 3);
          }}});
}

TEST_CASE("DMA where it does not reach") {
  constexpr std::uint32_t kRam = 0x20002000, kCoreRam = 0x10000000, kInFlash = 0x08000000;
  const auto move = [](std::uint32_t from, std::uint32_t to) {
    return [=](Bench& b, bool wrong) { move_memory(b, wrong ? from : kInFlash, wrong ? to : kRam); };
  };
  check(Misuse::dma_unreachable,
        {{"into core-coupled RAM", "dma2 cannot reach 0x10000000", move(kRam, kCoreRam)},
         {"out of core-coupled RAM", "dma2 cannot reach 0x10000010", move(kCoreRam + 16, kRam)},
         {"to a peripheral whose address was not set", "dma2 cannot reach 0x0",
          [](Bench& b, bool wrong) {
            start_usart(b);
            b.write(kUsart6 + 0x14, 1U << 7);
            b.write(kDma2 + 0xA0 + 0x08, wrong ? 0 : kUsart6 + 4);
            b.write(kDma2 + 0xA0 + 0x0C, kRam);
            b.write(kDma2 + 0xA0 + 0x04, 1);
            b.write(kDma2 + 0xA0, 5U << 25 | 1U << 10 | 1U << 6 | 1);
          }},
         {"by the first controller, behind the other bridge", "dma1 cannot reach 0x40011004",
          [](Bench& b, bool wrong) {
            clocks_on(b);
            b.write(kApb1, 1U << 22 | 1U << 17);
            b.write(kApb2, 1U << 4);
            b.write(0x40004400 + 0x0C, 0x2008);  // USART2 asks
            b.write(0x40004400 + 0x14, 1U << 7);
            b.write(0x40011000 + 0x0C, 0x2008);
            b.write(kDma1 + 0xA0 + 0x08, wrong ? 0x40011004 : 0x40004404);
            b.write(kDma1 + 0xA0 + 0x0C, kRam);
            b.write(kDma1 + 0xA0 + 0x04, 1);
            b.write(kDma1 + 0xA0, 4U << 25 | 1U << 10 | 1U << 6 | 1);
          }},
         {"into flash", "dma2 cannot reach 0x8000000", move(kRam, kInFlash)},
         {"nowhere", "dma2 cannot reach 0x20020000", move(kRam, 0x20020000)}});
}

TEST_CASE("clocks out of their limits") {
  const auto fast = [](std::uint32_t m, std::uint32_t n, std::uint32_t prescalers, std::uint32_t wait_states) {
    return [=](Bench& b, bool wrong) {
      wrong ? run_fast(b, m, n, prescalers, wait_states) : run_fast(b, 6, 168, kPrescalers, 5);
    };
  };
  check(Misuse::clock,
        {{"wait states", "too few flash wait states for 168000000 Hz", fast(6, 168, kPrescalers, 4)},
         {"core", "above 168 MHz", fast(6, 172, kPrescalers, 5)},
         {"APB1", "APB1 runs above 42 MHz", fast(6, 168, 4U << 10 | 4U << 13, 5)},
         {"APB2", "APB2 runs above 84 MHz", fast(6, 168, 5U << 10, 5)},
         {"VCO too fast", "VCO is not at 100 to 432 MHz", fast(6, 220, 7U << 10 | 7U << 13 | 8U << 4, 7)},
         {"VCO too slow", "VCO is not at 100 to 432 MHz", fast(6, 48, kPrescalers, 5)},
         {"input too slow", "input is not 1 to 2 MHz", fast(16, 200, kPrescalers, 5)},
         {"input too fast", "input is not 1 to 2 MHz", fast(4, 112, kPrescalers, 5)},
         {"PLL changed while on", "PLLCFGR is written while the PLL is on",
          [](Bench& b, bool wrong) {
            run_fast(b, 6, 168, kPrescalers, 5);
            if (!wrong) {
              b.write(kCfgr, kPrescalers);  // back to the internal clock first
              b.write(kRccCr, 0x83 | 1U << 16);
            }
            b.write(kPllcfgr, 6 | 168U << 6 | 1U << 22 | 7U << 24);
          }},
         {"PLL before its source", "before its source is ready",
          [](Bench& b, bool wrong) {
            b.write(kPllcfgr, 6 | 168U << 6 | 1U << 22 | 7U << 24);
            b.write(kRccCr, 0x83 | 1U << 16);
            b.run(wrong ? 100'000 : 3'000'000);
            b.write(kRccCr, 0x83 | 1U << 16 | 1U << 24);
          }},
         {"converter", "adc3 runs above 36 MHz", [](Bench& b, bool wrong) {
            run_fast(b, 6, 168, kPrescalers, 5);
            start_adc(b);
            if (wrong) b.write(kAdc + 0x304, 0);  // 84 MHz by two
            b.write(kAdc + 0x208, 1U << 30 | 1);
          }}});
}

TEST_CASE("a format that is rarely meant") {
  const auto format = [](std::uint32_t bad, std::uint32_t good) {
    return [=](Bench& b, bool wrong) { start_usart(b, wrong ? bad : good); };
  };
  check(Misuse::wire, {{"nine data bits", "nine data bits", format(0x3000, 0x3400)},
                       {"seven data bits", "seven data bits", format(0x2400, 0x3400)}});
}

TEST_CASE("serial lines in an order the manual forbids") {
  check(Misuse::protocol,
        {{"transmitter off", "usart6 is given a byte while its transmitter is off",
          [](Bench& b, bool wrong) {
            start_usart(b, wrong ? 0x2004 : 0x2008);
            b.write(kUsart6 + 4, 0x55);
          }},
         {"byte upon byte", "usart6 is given a byte before the last one left", [](Bench& b, bool wrong) {
            start_usart(b);
            b.write(kUsart6 + 4, 1);
            if (!wrong) b.run(200'000);
            b.write(kUsart6 + 4, 2);
          }}});
}

TEST_CASE("I2C in an order the manual forbids") {
  check(Misuse::protocol, {{"CR1 while a START is pending", "CR1 is written while a START or STOP is pending",
                            [](Bench& b, bool wrong) {
                              start_i2c(b);
                              b.write(kI2c2, 0x101);
                              if (!wrong) b.run(50'000);
                              b.write(kI2c2, 0x501);
                            }},
                           {"FREQ", "FREQ is not its clock",
                            [](Bench& b, bool wrong) {
                              start_i2c(b, wrong ? 42 : 16);
                              b.write(kI2c2, 0x101);
                            }},
                           {"timing while on", "timing is set while it is on",
                            [](Bench& b, bool wrong) {
                              start_i2c(b);
                              if (!wrong) b.write(kI2c2, 0);
                              b.write(kI2c2 + 0x20, 17);
                            }},
                           {"address before SR1", "address is written before SR1 was read",
                            [](Bench& b, bool wrong) {
                              i2c_start(b);
                              if (!wrong) b.read(kI2c2 + 0x14);
                              b.write(kI2c2 + 0x10, 0xE0);
                            }},
                           {"byte outside a transfer", "DR is written outside a transfer", [](Bench& b, bool wrong) {
                              i2c_start(b);
                              b.read(kI2c2 + 0x14);
                              b.write(kI2c2 + 0x10, 0xE0);
                              if (wrong) b.write(kI2c2 + 0x10, 1);  // nobody has acknowledged yet
                            }}});
}

TEST_CASE("SPI in an order the manual forbids") {
  check(Misuse::protocol,
        {{"clock while on", "mode or clock is changed while it is on",
          [](Bench& b, bool wrong) {
            start_spi(b);
            if (!wrong) b.write(kSpi1, 0x304);
            b.write(kSpi1, 0x34C);
          }},
         {"select low", "mode fault", [](Bench& b, bool wrong) { start_spi(b, wrong ? 0x244 : 0x344); }},
         {"off in the middle of a byte", "turned off in the middle of a byte",
          [](Bench& b, bool wrong) {
            start_spi(b);
            b.write(kSpi1 + 0x0C, 0x55);
            if (!wrong) b.run(10'000);
            b.write(kSpi1, 0x304);
          }},
         {"byte while off", "is given a byte while it is off", [](Bench& b, bool wrong) {
            start_spi(b, wrong ? 0x304 : 0x344);
            b.write(kSpi1 + 0x0C, 0x55);
          }}});
}

TEST_CASE("CAN in an order the manual forbids") {
  check(Misuse::protocol, {{"filters", "CAN filters are written outside their initialisation mode",
                            [](Bench& b, bool wrong) {
                              clocks_on(b);
                              if (wrong) b.write(kCan1 + 0x200, 0x2A1C0E00);
                              b.write(kCan1 + 0x240, 1);
                            }},
                           {"bit timing", "can1 bit timing is written outside the initialisation mode",
                            [](Bench& b, bool wrong) {
                              start_can(b);
                              if (wrong) b.write(kCan1, 0);
                              b.write(kCan1 + 0x1C, 0x001B0002);
                            }},
                           {"mailbox", "can1 mailbox is written while it waits", [](Bench& b, bool wrong) {
                              start_can(b);
                              b.write(kCan1, 0);
                              b.write(kCan1 + 0x180, 0x123U << 21 | 1);
                              b.write(kCan1 + (wrong ? 0x188 : 0x198), 1);  // this one, or the next
                            }}});
}

TEST_CASE("DMA in an order the manual forbids") {
  check(Misuse::protocol, {{"set up while on", "dma2 stream 0 is set up while it is on",
                            [](Bench& b, bool wrong) {
                              clocks_on(b);
                              b.write(kDma2 + 0x14, 1);
                              b.write(kDma2 + 0x10, 4U << 25 | 1);
                              if (!wrong) b.write(kDma2 + 0x10, 4U << 25);
                              b.write(kDma2 + 0x14, 2);
                            }},
                           {"flags of the last transfer", "is turned on with flags of its last transfer set",
                            [](Bench& b, bool wrong) {
                              move_memory(b, 0x20002000, 0x20002020);
                              if (!wrong) b.write(kDma2 + 8, 0x3D);
                              b.write(kDma2 + 0x10, 4U << 25 | 1);
                            }},
                           {"memory to memory", "dma1 cannot move memory to memory", [](Bench& b, bool wrong) {
                              const std::uint32_t stream = (wrong ? kDma1 : kDma2) + 0x10;
                              clocks_on(b);
                              b.write(stream + 0x08, 0x20002000);
                              b.write(stream + 0x0C, 0x20002020);
                              b.write(stream + 0x04, 4);
                              b.write(stream, 2U << 6 | 1);
                            }}});
}

TEST_CASE("converter and watchdog in an order the manual forbids") {
  constexpr std::uint32_t kStart = 1U << 30 | 1;
  check(Misuse::protocol, {{"off", "adc3 is started while it is off",
                            [](Bench& b, bool wrong) {
                              start_adc(b);
                              b.write(kAdc + 0x208, wrong ? 1U << 30 : kStart);
                            }},
                           {"not stable yet", "adc3 is started before it is stable",
                            [](Bench& b, bool wrong) {
                              start_adc(b, wrong ? 1'000 : 10'000);
                              b.write(kAdc + 0x208, kStart);
                            }},
                           {"converting", "adc3 is started while it converts",
                            [](Bench& b, bool wrong) {
                              start_adc(b);
                              b.write(kAdc + 0x208, kStart);
                              if (!wrong) b.run(200'000);
                              b.write(kAdc + 0x208, kStart);
                            }},
                           {"digital pin", "adc3 measures a pin that is not analog",
                            [](Bench& b, bool wrong) {
                              start_adc(b);
                              if (wrong) b.write(kGpioF, 0);
                              b.write(kAdc + 0x208, kStart);
                            }},
                           {"key of the watchdog", "iwdg is written without its key", [](Bench& b, bool wrong) {
                              if (!wrong) b.write(0x40003000, 0x5555);
                              b.write(0x40003004, 3);
                            }}});
}

TEST_CASE("wires with two opinions") {
  const auto listen = [](SerialFormat other) {
    return [=](Bench& b, bool wrong) {
      start_usart(b, 0x2004);
      b.board.chip().usart("usart6")->send_in({1}, wrong ? other : SerialFormat{115200, false, 1});
      b.run(1'000'000);
    };
  };
  check(Misuse::wire,
        {{"rate", "usart6 listens in another rate or format than is sent", listen({57600, false, 1})},
         {"parity", "usart6 listens in another rate or format than is sent", listen({115200, true, 1})},
         {"select in the middle of a byte", "spi1 chip select rises in the middle of a byte",
          [](Bench& b, bool wrong) {
            attach_two(b);
            start_spi(b);
            b.write(0x40020018, 1U << 20);
            b.write(kSpi1 + 0x0C, 0x55);
            if (!wrong) b.run(10'000);
            b.write(0x40020018, 1U << 4);
          }},
         {"two selects", "spi1 has two chip selects low",
          [](Bench& b, bool wrong) {
            attach_two(b);
            start_spi(b);
            b.write(0x40020018, 1U << 20);
            if (wrong) b.write(0x40020418, 1U << 16);
            b.write(kSpi1 + 0x0C, 0x55);
            b.run(10'000);
          }},
         {"STOP after an acknowledged byte", "i2c2 sends STOP after a byte it acknowledged", [](Bench& b, bool wrong) {
            Tca9548a part(0x70);
            b.board.chip().i2c("i2c2")->line.attach(part);
            i2c_start(b);
            b.read(kI2c2 + 0x14);
            b.write(kI2c2 + 0x10, 0xE1);
            b.run(150'000);
            b.read(kI2c2 + 0x14);
            b.write(kI2c2, wrong ? 0x401 : 1);
            b.read(kI2c2 + 0x18);
            b.write(kI2c2, wrong ? 0x601 : 0x201);
            b.run(150'000);
          }}});
}

TEST_CASE("processor faults") {
  struct Program {
    const char* text;
    Code wrong, right;  // r0: 0x30000000, r1: 0x20000000, r2: 0x10000001, r3: 0x08000188
  };
  const Program programs[] = {
      {"undefined instruction", {0xDE00}, {kNop}},
      {"access to 0x30000000", {0x6804}, {0x680C}},                                 // ldr r4, [r0]; [r1]
      {"no instruction at 0x10000000", {0x4710}, {0x3301, 0x4718}},                 // bx r2; adds r3, #1; bx r3
      {"jump out of Thumb state", {0x4718}, {0x3301, 0x4718}},                      // bx r3
      {"floating point before the FPU is on", {0xEEB0, 0x0A40}, {0xEA4F, 0x0400}},  // vmov.f32 s0, s0; mov.w r4, r0
      {"finds no stack at", {0x4685, 0xDF00}, {0xDF00}},                            // mov sp, r0; svc
  };
  for (const Program& program : programs) {
    for (const bool wrong : {true, false}) {
      const Code end = {0xE7FE};
      Bench bench(bench_image(1, (wrong ? program.wrong : program.right) + end,
                              {0x30000000, 0x20000000, 0x10000001, 0x08000188}));
      INFO(program.text << (wrong ? ", wrong" : ", right"));
      bool found = false;
      for (const Report& report : bench.board.reports()) {
        INFO(name_of(report.misuse) << ": " << report.text);
        CHECK(wrong);
        CHECK(report.misuse == Misuse::fault);
        found = found || report.text.find(program.text) != std::string::npos;
      }
      CHECK(found == wrong);
    }
  }
}

TEST_CASE("the stack pointer in a region without access is a fault, above it it is none") {
  for (const bool wrong : {true, false}) {
    // str r1, [r0] turns the region on; sub sp, #256; push {r4}: down from 0x20001000.
    Bench bench(bench_image(16 + 28, {0x6001, 0xB0C0, 0xB410, 0xE7FE}, {0xE000ED94, 5, 0, 0}));
    bench.write_core(0xE000ED98, 0);
    bench.write_core(0xE000ED9C, wrong ? 0x20000E00 : 0x20000D00);
    bench.write_core(0xE000EDA0, 7U << 1 | 1);  // 256 bytes, no access
    bench.enable_line(28);
    bench.board.world().system().nvic().pend(16 + 28);
    bench.run(5'000);
    INFO((wrong ? "wrong" : "right"));
    CHECK(bench.entered(28) == 1);
    CHECK(bench.reported(Misuse::fault) == wrong);
  }
}

TEST_CASE("rounding modes of the FPU are reported, its default is not") {
  for (const bool wrong : {true, false}) {
    // Turns the FPU on, then vmsr fpscr, r1.
    const Code on_and_set = {0x6801, 0xF441, 0x0170, 0x6001, 0xEEE1, 0x2A10, 0xE7FE};
    Bench bench(bench_image(1, on_and_set, {0xE000ED88, 0, wrong ? 1U << 22 : 0, 0}));
    bench.run(1'000);
    CHECK(bench.reported(Misuse::unmodelled) == wrong);
    CHECK(!bench.reported(Misuse::fault));
  }
}
