#include "generator/descriptor/interrupts.hpp"

#include "generator/descriptor/member.hpp"

namespace finemote::gen {

Interrupt read_interrupt(const Json& value) {
  Interrupt interrupt;
  interrupt.source = value.at("source").get<std::string>();
  interrupt.use = value.value("use", std::string());
  interrupt.is_autonomous = value.at("arrival").get<std::string>() == "autonomous";
  interrupt.count = value.value("count", std::int64_t{1});
  interrupt.min_interval = duration_member(value, "min_interval_ns");
  interrupt.wcet = duration_member(value, "wcet_ns");
  return interrupt;
}

}  // namespace finemote::gen
