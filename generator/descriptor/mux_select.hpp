// How a mux is told which of its channels to connect: the wire formats that the descriptor of an expander can name.
#pragma once

#include <cstdint>
#include <string_view>

namespace finemote::gen {

/// One of them.
struct MuxSelect {
  const char* name;                                 ///< as `select` of a descriptor spells it
  std::uint32_t channels;                           ///< it can tell apart
  std::int64_t bytes;                               ///< written to the mux, without its address
  std::uint32_t (*control)(std::uint32_t channel);  ///< what finemote::MuxRoute writes to connect a channel
};

/// Null where there is none of this name; `schemas/expander.schema.json` lists the same names.
const MuxSelect* find_mux_select(std::string_view name);

}  // namespace finemote::gen
