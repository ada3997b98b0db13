// The Type C board's wiring, out of its board file.
#pragma once

#include <nlohmann/json.hpp>

#include "emulator/chip/wiring.hpp"
#include "source_dir.hpp"
#include "tests/read.hpp"

namespace finemote::test {

inline emulator::Wiring type_c() {
  const std::string file = read(finemote::test::source_dir() + "/schemas/boards/robomaster_type_c.json");
  return emulator::read_wiring(nlohmann::ordered_json::parse(file));
}

}  // namespace finemote::test
