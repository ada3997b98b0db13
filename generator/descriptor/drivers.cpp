#include "generator/descriptor/drivers.hpp"

#include "generator/descriptor/member.hpp"

namespace finemote::gen {
namespace {

DriverSource::RaisedBy read_raised_by(const Json& value) {
  const auto by = optional_member<std::string>(value, "raised_by");
  if (!by) return DriverSource::RaisedBy::either;
  return *by == "transmit" ? DriverSource::RaisedBy::transmit : DriverSource::RaisedBy::receive;
}

DriverSource::Counts read_counts(const Json& value) {
  using Counts = DriverSource::Counts;
  static const std::map<std::string, Counts> kCounts = {{"requests", Counts::requests},
                                                        {"steps", Counts::steps},
                                                        {"ends", Counts::ends},
                                                        {"received", Counts::received},
                                                        {"events", Counts::events}};
  const auto counts = optional_member<std::string>(value, "counts");
  return counts ? kCounts.at(*counts) : Counts::nothing;
}

DriverSource read_source(const Json& value) {
  return {value.at("name").get<std::string>(),
          read_counts(value),
          read_raised_by(value),
          nanoseconds(value.at("isr_wcet_ns").get<std::int64_t>()),
          duration_member(value, "isr_per_slot_ns").value_or(Duration::zero()),
          duration_member(value, "isr_per_frame_ns").value_or(Duration::zero()),
          optional_member<std::int64_t>(value, "isr_waits_bits").value_or(0),
          duration_member(value, "isr_beside_wait_ns"),
          value.at("min_frame_bits").get<std::int64_t>()};
}

Driver read_driver(const Json& value) {
  Driver driver;
  driver.isr_wcet = nanoseconds(value.at("isr_wcet_ns").get<std::int64_t>());
  driver.min_frame_bits = value.at("min_frame_bits").get<std::int64_t>();
  driver.sources = read_list<DriverSource>(value, "sources", read_source);
  driver.supervise = duration_member(value, "supervise_ns").value_or(Duration::zero());
  driver.mailboxes = optional_member<std::size_t>(value, "mailboxes").value_or(0);
  driver.is_assumed = value.at("assumed").get<bool>();
  driver.summary = value.at("summary").get<std::string>();
  return driver;
}

}  // namespace

Drivers read_drivers(const Json& value) {
  Drivers drivers;
  for (const auto& [name, driver] : value.items()) {
    if (const auto kind = bus_kind(name)) drivers[*kind] = read_driver(driver);
  }
  return drivers;
}

}  // namespace finemote::gen
