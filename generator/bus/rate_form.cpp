#include "generator/bus/rate_form.hpp"

#include <fmt/format.h>

#include "generator/bus/bus_type.hpp"

namespace finemote::gen {
namespace {

constexpr std::int64_t kUsualBauds[] = {9'600,   19'200,  38'400,    57'600,    115'200,  230'400,
                                        460'800, 921'600, 1'000'000, 2'000'000, 3'000'000};
constexpr std::int64_t kUsualClocks[] = {100'000, 400'000, 1'000'000, 2'000'000, 5'000'000, 10'000'000, 20'000'000};
constexpr std::int64_t kUsualBitrates[] = {125'000, 250'000, 500'000, 1'000'000};

constexpr const RateForm* kForms[] = {&kBaud, &kClock, &kBitrate};

}  // namespace

constinit const RateForm kBaud{.attribute = "baud",
                               .units = {"baud", "kbit/s", "Mbit/s"},
                               .page_unit = "bit/s",
                               .has_multiples = false,
                               .has_tolerance = true,
                               .slowest = 300,
                               .usual = kUsualBauds,
                               .parse = units::parse_bitrate};

constinit const RateForm kClock{.attribute = "clock",
                                .units = {"Hz", "kHz", "MHz"},
                                .page_unit = "Hz",
                                .is_clock = true,
                                .slowest = 1000,
                                .usual = kUsualClocks,
                                .parse = units::parse_frequency};

constinit const RateForm kBitrate{.attribute = "bitrate",
                                  .units = {"bit/s", "kbit/s", "Mbit/s"},
                                  .page_unit = "bit/s",
                                  .slowest = 300,
                                  .usual = kUsualBitrates,
                                  .parse = units::parse_bitrate};

std::span<const RateForm* const> rate_forms() { return kForms; }

std::string_view rate_attribute(BusKind kind) {
  const RateForm* form = bus_type(kind).rate.form;
  return form != nullptr ? form->attribute : std::string_view{};
}

std::string rate_text(BusKind kind, std::int64_t rate) {
  const RateForm& form = *bus_type(kind).rate.form;
  if (form.has_multiples && rate % 1'000'000 == 0) return fmt::format("{}{}", rate / 1'000'000, form.units[2]);
  if (form.has_multiples && rate % 1'000 == 0) return fmt::format("{}{}", rate / 1'000, form.units[1]);
  return fmt::format("{}{}", rate, form.units[0]);
}

}  // namespace finemote::gen
