#include "emulator/core/tag_flow.hpp"

#include <algorithm>

#include "emulator/core/address_map.hpp"
#include "emulator/core/memories.hpp"

namespace finemote::emulator {

void TagFlow::turn_on() {
  ram_.assign(Memories::kRamBytes, Tag::none);
  core_ram_.assign(Memories::kCoreRamBytes, Tag::none);
}

/// Empty where memory is not followed: flash, and what is no memory.
std::span<Tag> TagFlow::find(std::uint32_t address, unsigned bytes) {
  if (const std::uint32_t at = address - Memories::kRamBase; at < ram_.size() && ram_.size() - at >= bytes)
    return {&ram_[at], bytes};
  const std::uint32_t at = address - Memories::kCoreRamBase;
  if (at < core_ram_.size() && core_ram_.size() - at >= bytes) return {&core_ram_[at], bytes};
  return {};
}

WordTags TagFlow::in_memory(std::uint32_t address, unsigned bytes) {
  WordTags tags{};
  const std::span<Tag> from = find(address, bytes);
  if (from.size() == tags.size()) {
    std::copy_n(from.begin(), tags.size(), tags.begin());  // at once: words are what is loaded most
  } else {
    std::ranges::copy(from, tags.begin());
  }
  return tags;
}

void TagFlow::put_in_memory(std::uint32_t address, unsigned bytes, const WordTags& tags) {
  const std::span<Tag> to = find(address, bytes);
  std::copy_n(tags.begin(), to.size(), to.begin());
}

void TagFlow::enter(std::uint32_t frame) { interrupted_.leave(file_, frame); }

void TagFlow::resume(std::uint32_t frame) { file_ = interrupted_.come_back(frame); }

void TagFlow::reset() {
  file_ = {};
  interrupted_.clear();
}

void TagFlow::set(WordTags& to, const WordTags& tags) { to = may_leave_ ? newer(to, tags) : tags; }

void TagFlow::load(std::uint32_t address, Width width, WordTags& to) {
  if (!is_peripheral(address)) return arrive(width, to, in_memory(address, width.bytes));
  if (planned_ < crossings_.size()) crossings_[planned_++] = {width, {}, &to};
}

void TagFlow::arrive(Width width, WordTags& to, WordTags tags) {
  if (!is_spill_ && provenance_.looks() && !is_untagged(tags)) {
    for (const Tag tag : tags) provenance_.loaded(tag, now_);
  }
  for (unsigned i = width.bytes; width.is_signed && i < 4; ++i) tags[i] = tags[width.bytes - 1];
  set(to, tags);
}

void TagFlow::store(std::uint32_t address, unsigned bytes, const WordTags& tags) {
  const Tag job = is_spill_ ? Tag::none : provenance_.writes_as();
  const WordTags stored = job == Tag::none ? tags : all_of(job);
  if (!is_peripheral(address)) return put_in_memory(address, bytes, stored);
  if (planned_ < crossings_.size()) crossings_[planned_++] = {{bytes, false}, stored, nullptr};
}

void TagFlow::take_answer(unsigned bytes, Time now) {
  if (!is_on() || crossed_ >= planned_) return;
  now_ = now;
  const Crossing& expected = crossings_[crossed_++];
  WordTags tags{};
  std::copy_n(crossing.begin(), bytes, tags.begin());
  if (expected.to != nullptr) arrive(expected.width, *expected.to, tags);
}

void TagFlow::give_stored() { crossing = is_on() && crossed_ < planned_ ? crossings_[crossed_++].tags : WordTags{}; }

/// In the order of Interpreter::Access: ldr ldrb ldrh ldrsb ldrsh str strb strh.
void TagFlow::access(unsigned which, std::uint32_t address, unsigned t) {
  constexpr Width kWidths[] = {{4, false}, {1, false}, {2, false}, {1, true},
                               {2, true},  {4, false}, {1, false}, {2, false}};
  if (which < 5) return load(address, kWidths[which], r_[t]);
  store(address, kWidths[which].bytes, r_[t]);
}

}  // namespace finemote::emulator
