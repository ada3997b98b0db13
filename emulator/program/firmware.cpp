#include "emulator/program/firmware.hpp"

#include <stdexcept>

namespace finemote::emulator {
namespace {

using Json = nlohmann::ordered_json;

/// finemote::bucket_states<N>, as many as the robot has buckets, and what one is made of:
/// runtime/chips/cortex_m4/release.cpp asserts it.
constexpr const char* kBucketStates = "_ZN8finemote13bucket_statesILj";
constexpr std::uint32_t kStateBytes = 20, kOverrunsAt = 12;

}  // namespace

std::vector<std::uint32_t> overruns_of(Board& board, const Image& image) {
  std::vector<std::uint32_t> all;
  const auto states = image.symbols.lower_bound(kBucketStates);
  const bool has_states = states != image.symbols.end() && states->first.rfind(kBucketStates, 0) == 0;
  if (!has_states && image.symbol("finemote_schedule")) throw std::runtime_error("the firmware keeps no overruns");
  for (std::uint32_t at = 0; has_states && at + kStateBytes <= states->second.size; at += kStateBytes)
    all.push_back(board.word(states->first, at + kOverrunsAt));
  return all;
}

Json faults_of(Board& board, const Image& image) {
  constexpr const char* kRecords = "_ZN8finemote12_GLOBAL__N_17recordsE";
  constexpr const char* kLost = "_ZN8finemote12_GLOBAL__N_14lostE";  // of kinds that found no record
  Json all = Json::array();
  const auto records = image.symbol(kRecords);
  for (std::uint32_t offset = 0; records && offset + 4 <= records->size; offset += 4) {
    const std::uint32_t word = board.word(kRecords, offset);
    if (word != 0) all.push_back(Json::array({word >> 24, word >> 16 & 0xFF, word & 0xFFFF}));
  }
  const std::uint32_t lost = image.symbol(kLost) ? board.word(kLost, 0) : 0;
  if (lost != 0) all.push_back(Json::array({0, 0, lost}));
  return all;
}

Json monitor_of(Board& board, const Image& image) {
  constexpr const char* kRecords = "finemote_monitor_records";
  constexpr std::uint32_t kBytes = 24;
  Json all = Json::array();
  const auto records = image.symbol(kRecords);
  for (std::uint32_t i = 0; records && (i + 1) * kBytes <= records->size; ++i) {
    const auto word = [&](std::uint32_t offset) { return std::int64_t{board.word(kRecords, i * kBytes + offset)}; };
    const auto time = [&](std::uint32_t offset) { return word(offset) | word(offset + 4) << 32; };
    all.push_back(Json::array({time(0), time(8), word(16), word(20)}));
  }
  return all;
}

}  // namespace finemote::emulator
