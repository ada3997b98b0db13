#include "generator/schedule/name_clash.hpp"

#include <fmt/format.h>

namespace finemote::gen {

void report_name_clash(const std::string& name, const Device& device, const std::vector<const Device*>& holders,
                       Diagnostics& diagnostics) {
  Diagnostic& finding = diagnostics.error(
      code::generated_name_clash, device.at,
      fmt::format("the generated name '{}' for device '{}' is already taken", name, device.name.text));
  finding.underline(7);
  for (const Device* other : holders) finding.note(fmt::format("device '{}' has it", other->name.text), other->at);
  finding.hint("rename one of the devices that share it");
}

}  // namespace finemote::gen
