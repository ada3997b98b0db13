// A small table of (module, number, count), written from any priority without masking.
#include <atomic>

#include "finemote/fault.hpp"
#include "finemote/loop_bound.hpp"
#include "finemote/only_after_fault.hpp"

namespace finemote {
namespace {

// One word per record: module << 24 | number << 16 | count; 0 is free.
std::atomic<std::uint32_t> records[kFaultRecords];
std::atomic<std::uint32_t> lost{0};

constexpr std::uint32_t kCountMask = 0xFFFF;

constexpr std::uint32_t key_of(Module module, std::uint8_t number) {
  return static_cast<std::uint32_t>(module) << 24 | static_cast<std::uint32_t>(number) << 16;
}

// Bounded: a failed exchange means that a more urgent writer made progress, and there are 16 levels of them.
bool count_in(std::atomic<std::uint32_t>& record, std::uint32_t key) {
  std::uint32_t seen = record.load(std::memory_order_relaxed);
  do {
    retried_if_interrupted<RetriedBy::fault>();
    if (seen != 0 && (seen & ~kCountMask) != key) return false;
    if ((seen & kCountMask) == kCountMask) return true;
  } while (!record.compare_exchange_weak(seen, (seen | key) + 1, std::memory_order_relaxed));
  return true;
}

}  // namespace

void count_fault(Module module, std::uint8_t number) {
  only_after_fault();
  const std::uint32_t key = key_of(module, number);
  for (auto& record : records) {
    if (count_in(record, key)) return;
  }
  lost.fetch_add(1, std::memory_order_relaxed);
}

FaultRecord fault_record(unsigned index) {
  const std::uint32_t word = records[index].load(std::memory_order_relaxed);
  return {static_cast<Module>(word >> 24), static_cast<std::uint8_t>(word >> 16), static_cast<std::uint16_t>(word)};
}

std::uint16_t fault_count(Module module, std::uint8_t number) {
  for (const auto& record : records) {
    const std::uint32_t word = record.load(std::memory_order_relaxed);
    if ((word & ~kCountMask) == key_of(module, number)) return static_cast<std::uint16_t>(word);
  }
  return 0;
}

std::uint32_t faults_lost() { return lost.load(std::memory_order_relaxed); }

}  // namespace finemote
