#include "generator/descriptor/bus_kind.hpp"

#include <array>

namespace finemote::gen {
namespace {

struct NamedKind {
  std::string_view name;
  BusKind kind;
};

constexpr std::array<NamedKind, 8> kKinds{{{"uart", BusKind::uart},
                                           {"rs485", BusKind::rs485},
                                           {"i2c", BusKind::i2c},
                                           {"spi", BusKind::spi},
                                           {"can", BusKind::can},
                                           {"pwm", BusKind::pwm},
                                           {"gpio", BusKind::gpio},
                                           {"virtual", BusKind::virtual_bus}}};

}  // namespace

std::optional<BusKind> bus_kind(std::string_view name) {
  for (const NamedKind& entry : kKinds) {
    if (entry.name == name) return entry.kind;
  }
  return {};
}

std::string bus_kind_name(BusKind kind) {
  for (const NamedKind& entry : kKinds) {
    if (entry.kind == kind) return std::string(entry.name);
  }
  return {};
}

std::vector<std::string> bus_kind_names(const std::vector<BusKind>& kinds) {
  std::vector<std::string> names;
  for (const BusKind kind : kinds) names.push_back(bus_kind_name(kind));
  return names;
}

std::vector<std::string> bus_kind_names() {
  std::vector<std::string> names;
  for (const NamedKind& entry : kKinds) names.emplace_back(entry.name);
  return names;
}

}  // namespace finemote::gen
