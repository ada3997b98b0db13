// What a board is, as its JSON file says (`schemas/boards/<board>.json`).
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "generator/descriptor/device_type.hpp"

namespace finemote::gen {

struct Port {
  std::string name;                    ///< chip name: `usart1`
  std::vector<std::string> silkscreen; ///< what the board or its users call it; an error whose hint names both
  std::string connector;               ///< for people
  std::vector<BusKind> kinds;          ///< what it can serve
  std::vector<std::string> pins;
  std::vector<std::string> dma;
  std::vector<std::string> interrupts;
  std::optional<std::int64_t> clock_hz;     ///< kernel clock the rate is divided from
  std::optional<std::int64_t> max_rate;     ///< of baud, clock or bitrate
};

/// An interrupt line no used peripheral needs; a period bucket may run in it.
struct SpareLine {
  std::uint32_t number = 0;
  std::string name;
};

struct Board {
  std::string name;
  std::string summary;
  std::string display_path;
  std::int64_t cpu_hz = 0;
  std::vector<Port> ports;
  std::vector<SpareLine> lines;       ///< in order of use
  std::uint32_t first_bucket_level = 0, last_bucket_level = 0;  ///< NVIC priority levels for buckets, inclusive
  std::vector<ParamSpec> params;      ///< of the `<board>` element
  std::string raw_json;               ///< the whole file: costs, driver data, watchdog, errata

  [[nodiscard]] const Port* port(std::string_view port_name) const {
    for (const Port& p : ports) {
      if (p.name == port_name) return &p;
    }
    return nullptr;
  }
};

}  // namespace finemote::gen
