#include "generator/wcet/vectors.hpp"

#include "generator/image/exception.hpp"
#include "generator/image/schedule_layout.hpp"

namespace finemote::gen::wcet {

std::vector<Vector> interrupt_vectors(const Image& image) {
  std::vector<Vector> vectors;
  const ImageSymbol* table = image.find("finemote_vectors");
  const ImageSymbol* unexpected = image.find("finemote_unexpected_line");
  if (table == nullptr) return vectors;
  for (std::uint32_t exception = kSysTickException; 4 * exception < table->size; ++exception) {
    const std::uint32_t entry = image.word(table->address + 4 * exception).value_or(0) & ~1U;
    const bool is_own = entry != 0 && (unexpected == nullptr || entry != unexpected->address);
    if (is_own) vectors.push_back({exception, entry});
  }
  return vectors;
}

std::optional<std::uint32_t> start_of_buses(const Image& image) {
  const ImageSymbol* schedule = image.find("finemote_schedule");
  const auto entry =
      schedule == nullptr ? std::nullopt : image.word(schedule->address + schedule_layout::kStartBusesAt);
  return entry ? std::optional(*entry & ~1U) : std::nullopt;
}

}  // namespace finemote::gen::wcet
