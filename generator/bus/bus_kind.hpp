// Bus kinds by the names the extension and the descriptors give them.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace finemote::gen {

/// The kinds of bus of the extension. What there is to know about one: bus_type(), in bus_type.hpp.
enum class BusKind { uart, rs485, i2c, spi, can, pwm, gpio, virtual_bus };

/// `uart` -> BusKind::uart; `virtual` -> BusKind::virtual_bus; none when there is no such kind.
std::optional<BusKind> bus_kind(std::string_view name);

std::string bus_kind_name(BusKind kind);

/// The names of these kinds, in their order.
std::vector<std::string> bus_kind_names(const std::vector<BusKind>& kinds);

/// All names, in the order of the reference.
std::vector<std::string> bus_kind_names();

}  // namespace finemote::gen
