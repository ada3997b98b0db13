// An entry of a part to where it is wired, and to whom it stands in the way there.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "emulator/scenario/grammar.hpp"
#include "generator/json/value.hpp"

namespace finemote::scenario {

/// How a part is wired, as far as it can stand in another's way.
struct Place {
  /// Something that only one part can have.
  struct Hold {
    std::string what;    ///< in words: `has chip select 0 of 'spi1'`
    std::string member;  ///< of the entry, which says so
  };
  std::string port;            ///< empty: it is behind a mux, or on no bus
  std::string mux;             ///< the mux it is behind
  std::string bus;             ///< of an I2C part: in words, `'i2c2'` or `channel 3 of 'mux'`
  std::optional<int> address;  ///< of an I2C part
  std::vector<Hold> holds;
};

/// Of an entry that may have mistakes: what is missing or of another type is left out.
Place place_of(const gen::json::Value& entry, const Model& model);

}  // namespace finemote::scenario
