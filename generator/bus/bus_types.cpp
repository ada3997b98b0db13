#include <stdexcept>

#include "generator/bus/bus_type.hpp"
#include "generator/bus/records.hpp"

namespace finemote::gen {
namespace {

constexpr const BusType* kTypes[] = {&kUartBus, &kRs485Bus, &kI2cBus,  &kSpiBus,
                                     &kCanBus,  &kPwmBus,   &kGpioBus, &kVirtualBus};

}  // namespace

std::span<const BusType* const> bus_types() { return kTypes; }

const BusType& bus_type(BusKind kind) {
  for (const BusType* type : kTypes) {
    if (type->kind == kind) return *type;
  }
  throw std::logic_error("a kind of bus without a record");
}

const BusType& expander_bus_type() {
  for (const BusType* type : kTypes) {
    if (type->carries_expanders) return *type;
  }
  throw std::logic_error("no kind of bus carries expanders");
}

std::optional<BusKind> bus_kind(std::string_view name) {
  for (const BusType* type : kTypes) {
    if (type->name == name) return type->kind;
  }
  return {};
}

std::string bus_kind_name(BusKind kind) { return std::string(bus_type(kind).name); }

std::vector<std::string> bus_kind_names(const std::vector<BusKind>& kinds) {
  std::vector<std::string> names;
  for (const BusKind kind : kinds) names.push_back(bus_kind_name(kind));
  return names;
}

std::vector<std::string> bus_kind_names() {
  std::vector<std::string> names;
  for (const BusType* type : kTypes) names.emplace_back(type->name);
  return names;
}

}  // namespace finemote::gen
