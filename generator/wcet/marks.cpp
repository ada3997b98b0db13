#include "generator/wcet/marks.hpp"

#include <capstone/capstone.h>

#include <set>
#include <string_view>

namespace finemote::gen::wcet {
namespace {

using namespace records;

constexpr std::size_t kRecord = 8;  // address, number
constexpr std::uint32_t kPassesMask = (1U << kRetriedByShift) - 1;

std::uint32_t word_at(std::string_view bytes, std::size_t at) {
  std::uint32_t value = 0;
  for (std::size_t i = 4; i-- > 0;) value = value << 8U | static_cast<std::uint8_t>(bytes[at + i]);
  return value;
}

/// Of the name that the assembler knows a register by, as the four bytes of a record.
int register_named(std::uint32_t name) {
  constexpr struct {
    const char* name;
    int reg;
  } kOthers[] = {{"sl", ARM_REG_R10},  {"fp", ARM_REG_R11},  {"ip", ARM_REG_R12}, {"lr", ARM_REG_LR},
                 {"r10", ARM_REG_R10}, {"r11", ARM_REG_R11}, {"r12", ARM_REG_R12}};
  const char text[] = {static_cast<char>(name), static_cast<char>(name >> 8U), static_cast<char>(name >> 16U), 0};
  for (const auto& other : kOthers) {
    if (std::string_view(text) == other.name) return other.reg;
  }
  const bool is_low = text[0] == 'r' && text[1] >= '0' && text[1] <= '9' && text[2] == 0;
  return is_low ? ARM_REG_R0 + (text[1] - '0') : static_cast<int>(ARM_REG_INVALID);
}

template <class Take>
void read_section(const Image& image, std::string_view name, Take take) {
  for (const ImageSection& section : image.sections) {
    if (section.name != name) continue;
    for (std::size_t at = 0; at + kRecord <= section.bytes.size(); at += kRecord) {
      const std::uint32_t address = word_at(section.bytes, at) & ~1U;
      if (address != 0) take(address, word_at(section.bytes, at + 4));
    }
  }
}

}  // namespace

std::vector<std::uint32_t> Marks::addresses() const {
  std::set<std::uint32_t> all;
  for (const auto& [address, number] : brackets) all.insert(address);
  for (const auto& [address, bound] : loop_bounds) all.insert(address);
  for (const auto& [address, reg] : waits) all.insert(address);
  for (const auto& [address, id] : begins) all.insert(address);
  all.insert(faults.begin(), faults.end());
  for (const auto& [address, causes] : raised) all.insert(address);
  for (const auto& [address, cause] : once_for_each) all.insert(address);
  return {all.begin(), all.end()};
}

Marks read_marks(const Image& image) {
  Marks marks;
  read_section(image, ".debug_finemote",
               [&](std::uint32_t address, std::uint32_t number) { marks.brackets.emplace(address, number); });
  read_section(image, ".debug_finemote_loops", [&](std::uint32_t address, std::uint32_t word) {
    const std::uint32_t bound = word & kPassesMask;
    const std::uint32_t by = (word & ~kUnlessInterrupted) >> kRetriedByShift;
    if ((word & kUnlessInterrupted) != 0 && by < kKindsOfRetry) marks.retries[address] = static_cast<RetriedBy>(by);
    marks.loop_bounds.emplace(address, bound);
  });
  read_section(image, ".debug_finemote_mark_ids", [&](std::uint32_t address, std::uint32_t word) {
    if ((word & kBegins) != 0)
      marks.begins.emplace(address, word & ~kBegins);
    else
      marks.ids[address].insert(word);
  });
  read_section(image, ".debug_finemote_waits",
               [&](std::uint32_t address, std::uint32_t name) { marks.waits.emplace(address, register_named(name)); });
  read_section(image, ".debug_finemote_faults",
               [&](std::uint32_t address, std::uint32_t) { marks.faults.insert(address); });
  read_section(image, ".debug_finemote_raised", [&](std::uint32_t address, std::uint32_t causes) {
    if ((causes & kOnceForEach) != 0) {
      marks.once_for_each[address] = causes & ~kOnceForEach;
      return;
    }
    const auto [known, is_new] = marks.raised.try_emplace(address, causes);
    if (!is_new) known->second &= causes;  // both are true
  });
  return marks;
}

}  // namespace finemote::gen::wcet
