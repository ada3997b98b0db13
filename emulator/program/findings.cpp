#include "emulator/program/findings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace finemote::emulator {
namespace {

Json address_of(const Report& report) { return report.address ? Json(*report.address) : Json(); }

std::string words_of(const Report& report) { return std::string(name_of(report.misuse)) + ": " + report.text; }

/// A whole number without a point.
Json number(double value) {
  constexpr double kExact = 1e15;
  if (!std::isfinite(value)) return nullptr;
  if (value == std::floor(value) && std::abs(value) < kExact) return static_cast<std::int64_t>(value);
  return value;
}

/// Of a family that is zero throughout nothing is said.
Json shown(const std::vector<PartValue>& values) {
  Json seen = Json::object();
  for (const PartValue& it : values) {
    if (!it.is_of_family || it.value != 0) seen[it.name] = number(it.value);
  }
  return seen;
}

}  // namespace

const char* Findings::stopped() const {
  if (stop_ == Stop::lockup) return "lockup";
  const auto is_fault = [](int exception) { return exception >= kHardFault && exception <= kUsageFault; };
  const std::vector<int>& active = board_.cpu().active_exceptions();
  return std::any_of(active.begin(), active.end(), is_fault) ? "hardfault" : nullptr;
}

bool Findings::ran_as_expected() const {
  const auto& all = outfit_.expectations();
  return stopped() == nullptr && std::all_of(all.begin(), all.end(), [](const Expectation& e) { return e.holds(); });
}

const char* Findings::how_it_ended() const {
  if (stop_ == Stop::exit) return "the image ended itself";
  if (stop_ == Stop::lockup) return "the core locked up";
  if (stopped() != nullptr) return "the time is over, in the routine of a fault,";
  return stop_ == Stop::dead ? "the core sleeps with nothing left to wake it" : "the time is over";
}

Json Findings::document(const std::string& image) {
  Json reports = Json::array(), parts = Json::array();
  for (const Report& it : board_.reports())
    reports.push_back({{"what", words_of(it)}, {"address", address_of(it)}, {"pc", it.pc}, {"count", it.count}});
  for (const std::string& name : outfit_.names())
    parts.push_back({{"name", name}, {"seen", shown(outfit_.values(name))}});
  return {{"schema", "finemote.emulator/1"},
          {"image", image},
          {"duration_ns", board_.now_ns()},
          {"instructions", board_.cpu().instructions()},
          {"stopped", stopped() == nullptr ? Json() : Json(stopped())},
          {"reports", reports},
          {"parts", parts}};
}

void Findings::write_text(std::ostream& out) {
  const Rcc& rcc = board_.chip().rcc;
  out << "# " << how_it_ended() << " at " << board_.now_ns() << " ns\n"
      << "# core " << rcc.core_hz() << " Hz, APB1 " << rcc.apb1_hz() << " Hz, APB2 " << rcc.apb2_hz() << " Hz, "
      << board_.cpu().instructions() << " instructions, " << board_.resets() << " resets\n";
  for (const auto& it : board_.chip().usarts()) {
    if (it->statistics().bytes == 0) continue;
    out << "# " << it->name() << " " << it->format().baud << " baud, " << it->format().bits() << " bits a byte, "
        << it->statistics().bytes << " bytes\n";
  }
  for (const Report& report : board_.reports()) {
    out << "# " << words_of(report) << " (" << report.count << " times, first at " << report.first_ns << " ns)\n";
  }
  for (const std::string& name : outfit_.names()) {
    const char* between = ": ";
    const Json all = shown(outfit_.values(name));
    out << "# " << name;
    for (const auto& [value, seen] : all.items()) {
      out << between << value << " " << (seen.is_number() ? fmt::format("{:.6g}", seen.get<double>()) : seen.dump());
      between = ", ";
    }
    out << "\n";
  }
  for (const Expectation& e : outfit_.expectations()) {
    out << "# " << e.part << " " << e.value << " " << (e.holds() ? "as expected" : "not as expected") << ": "
        << e.lowest << " to " << e.highest << "\n";
  }
}

}  // namespace finemote::emulator
