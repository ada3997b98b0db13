// What a board is, as its JSON file says (`schemas/boards/<board>.json`).
#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "generator/bus/rate_rule.hpp"
#include "generator/descriptor/clocks.hpp"
#include "generator/descriptor/connector.hpp"
#include "generator/descriptor/costs.hpp"
#include "generator/descriptor/device_type.hpp"
#include "generator/descriptor/drivers.hpp"
#include "generator/units/duration.hpp"

namespace finemote::gen {

/// What a port occupies on the chip: two ports that share one cannot be used together.
struct Resource {
  std::string kind;  ///< `pin`, `DMA stream`, `timer channel`, `interrupt`
  std::string name;  ///< `PA9`, `DMA2 stream 5`
};

/// A pin a port is led out on.
struct PortPin {
  std::string pin;     ///< `PA9`
  std::string signal;  ///< `tx`
  int alternate_function = 0;
};

struct DmaStream {
  std::string signal;      ///< `rx`
  std::string controller;  ///< `dma2`
  int stream = 0, channel = 0;

  /// For people: `DMA2 stream 5`.
  [[nodiscard]] std::string name() const;
};

struct InterruptLine {
  std::string name;  ///< `USART1`
  std::uint32_t number = 0;

  /// For people: `USART1 (line 37)`.
  [[nodiscard]] std::string text() const;
};

struct TimerChannel {
  std::string timer;  ///< `TIM1`, whose outputs repeat together
  int channel = 0;
};

struct Port {
  std::string name;                     ///< chip name: `usart1`
  std::vector<std::string> silkscreen;  ///< what the board or its users call it; an error whose hint names both
  std::string connector;                ///< for people
  std::vector<BusKind> kinds;           ///< what it can serve
  std::vector<PortPin> pins;
  std::vector<DmaStream> dma;
  std::vector<InterruptLine> interrupts;
  std::vector<std::string> selects;      ///< spi: pins of the chip selects, by channel; empty: not known
  std::optional<TimerChannel> timer;     ///< pwm
  std::vector<Resource> resources;       ///< pins, DMA streams, timer channel and interrupt lines together
  std::uint32_t channels = 0;            ///< PWM outputs, chip selects; 0: neither
  Duration period = milliseconds(20);    ///< how often a PWM port repeats its pulse
  std::optional<std::int64_t> clock_hz;  ///< kernel clock the rate is divided from
  const RateRule* rate_rule = nullptr;   ///< how the clock makes a rate; null: as usual for the kind of bus
  std::optional<std::int64_t> min_rate;  ///< of baud, clock or bitrate
  std::optional<std::int64_t> max_rate;
  std::vector<std::int64_t> rates;           ///< the only ones, where not every one in range can be made
  std::string drives;                        ///< interface of what the board has at this PWM output; empty: open
  bool has_inverter = false;                 ///< uart: the board inverts the receive line
  std::int64_t max_rate_error_ppm = 20'000;  ///< how far the rate made may be from the rate asked for

  [[nodiscard]] bool serves(BusKind kind) const { return std::find(kinds.begin(), kinds.end(), kind) != kinds.end(); }

  /// Empty: none.
  [[nodiscard]] std::string timer_name() const { return timer ? timer->timer : std::string(); }
};

/// The part of the board whose data-ready line a pin is.
struct DataReady {
  std::string port;                      ///< the part's: `spi1`
  std::optional<std::uint32_t> channel;  ///< spi: its chip select; none: the part is alone on the port
};

/// A pin of the board with a name, for `<use pin=...>`.
struct NamedPin {
  std::string name;                    ///< `key`
  std::string pin;                     ///< `PA0`
  std::vector<std::string> functions;  ///< input, output, interrupt, pwm, analog
  bool active_low = false;
  std::string summary;
  std::optional<DataReady> data_ready;  ///< none: no such line
  std::optional<bool> rests_high;       ///< level from start-up on, until somebody uses it; none: an input
  std::string converter;                ///< analog: its port, `adc3`; empty: not analog
  std::uint32_t input = 0;              ///< analog: of the converter
  std::int64_t full_scale_mv = 0;       ///< analog: what the highest code means, dividers included

  /// Whether `function` is among its functions.
  [[nodiscard]] bool can(std::string_view function) const {
    return std::find(functions.begin(), functions.end(), function) != functions.end();
  }
};

/// Pins that the board wires to something of its own.
struct ReservedPins {
  std::vector<std::string> pins;  ///< `PA13`
  std::string purpose;            ///< `the debugger (SWDIO, SWCLK)`
  std::string port;               ///< devices on a bus at this port may use them; empty: nobody may
};

/// An interrupt line no used peripheral needs; a period bucket may run in it.
struct SpareLine {
  std::uint32_t number = 0;
  std::string name;
};

/// An interrupt line that no bucket may run in.
struct ForbiddenLine {
  std::uint32_t number = 0;
  std::string why;
};

struct Board {
  std::string name;
  std::string summary;
  std::string display_path;
  std::string chip;           ///< folder below runtime/chips with its code; `host`: none, this computer
  bool stands_in = false;     ///< plays the robots of other boards, and has all their ports
  bool is_emulated = false;   ///< the emulated board can be wired as this one
  bool is_suggested = false;  ///< what hints and examples name
  std::optional<Clocks> clocks;
  std::vector<Memory> memory;
  std::int64_t cpu_hz = 0;
  std::int64_t clock_ppm = 50;  ///< how far the clock that all its times come from may be off, both ways
  Duration default_tick = milliseconds(1), min_tick = nanoseconds(1), max_tick = seconds(1);
  std::vector<Port> ports;
  std::vector<NamedPin> pins;
  std::vector<std::string> chip_pins;  ///< those that the package of the chip has, in order
  std::vector<ReservedPins> reserved_pins;
  std::vector<Connector> connectors;  ///< empty: not known
  std::vector<ForbiddenLine> forbidden_lines;
  std::vector<SpareLine> lines;                                 ///< in order of use
  std::uint32_t first_bucket_level = 0, last_bucket_level = 0;  ///< NVIC priority levels for buckets, inclusive
  std::vector<ParamSpec> params;                                ///< of the `<board>` element
  Costs costs;                                                  ///< where it runs its code in flash
  Costs costs_in_sram;                                          ///< where it runs it in SRAM
  Drivers drivers;
  bool has_watchdog = false;   ///< only hardware has one
  Duration analog_conversion;  ///< of one analog input, at most

  /// This computer: no chip, no cross compiler.
  [[nodiscard]] bool is_host() const { return chip == "host"; }
  [[nodiscard]] const Port* port(std::string_view port_name) const {
    for (const Port& p : ports) {
      if (p.name == port_name) return &p;
    }
    return nullptr;
  }
  /// What the runtime's driver of a kind of bus costs; null where the board has none.
  [[nodiscard]] const Driver* driver(BusKind kind) const {
    const auto found = drivers.find(kind);
    return found == drivers.end() ? nullptr : &found->second;
  }
  [[nodiscard]] const ReservedPins* reserved_pin(std::string_view pin) const {
    for (const ReservedPins& r : reserved_pins) {
      for (const std::string& p : r.pins) {
        if (p == pin) return &r;
      }
    }
    return nullptr;
  }
  [[nodiscard]] const NamedPin* named_pin(std::string_view pin_name) const {
    for (const NamedPin& p : pins) {
      if (p.name == pin_name || p.pin == pin_name) return &p;
    }
    return nullptr;
  }
};

}  // namespace finemote::gen
