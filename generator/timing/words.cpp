#include "generator/timing/words.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "generator/timing/model_words.hpp"
#include "generator/units/units.hpp"

namespace finemote::gen::timing {
namespace {

constexpr Word<ChainPart> kPartWords[] = {
    {ChainPart::acquire, "acquire"}, {ChainPart::decide, "decide"}, {ChainPart::wire, "wire"}};

}  // namespace

std::string_view label_of(WcetSource source) {
  switch (source) {
    case WcetSource::unknown:
      return "given";
    case WcetSource::assumed:
      return "assumed";
    case WcetSource::declared:
      return "declared";
    case WcetSource::measured:
      return "measured";
    case WcetSource::computed:
      return "static";
  }
  return "";
}

std::string_view part_name(ChainPart part) { return word_of(part, kPartWords); }

double ratio(Duration part, Duration whole) {
  return static_cast<double>(part.ns()) / static_cast<double>(std::max(whole, nanoseconds(1)).ns());
}

std::string percent(double fraction) { return fmt::format("{:.1f} %", fraction * 100); }

std::string whole_percent(double fraction) { return fmt::format("{:.0f} %", fraction * 100); }

std::string quoted(const std::string& name) { return "'" + name + "'"; }

std::string quoted_names(const Model& model, const std::vector<Rank>& devices, std::size_t most) {
  std::string text;
  for (std::size_t i = 0; i < devices.size() && i < most; ++i) {
    text += (i > 0 ? ", " : "") + quoted(model.devices[devices[i]].name);
  }
  return devices.size() > most ? fmt::format("{} and {} more", text, devices.size() - most) : text;
}

std::string bucket_text(Duration period) {
  return fmt::format("the devices with period {}", units::format_duration(period));
}

}  // namespace finemote::gen::timing
