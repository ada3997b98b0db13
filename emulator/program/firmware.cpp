#include "emulator/program/firmware.hpp"

namespace finemote::emulator {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kOverruns = "_ZN8finemote6detail12_GLOBAL__N_114overrun_countsE";

}  // namespace

std::vector<std::uint32_t> overruns_of(Board& board, const Image& image) {
  std::vector<std::uint32_t> all;
  const auto counts = image.symbol(kOverruns);
  for (std::uint32_t offset = 0; counts && offset + 4 <= counts->size; offset += 4)
    all.push_back(board.word(kOverruns, offset));
  return all;
}

Json faults_of(Board& board, const Image& image) {
  constexpr const char* kRecords = "_ZN8finemote12_GLOBAL__N_17recordsE";
  Json all = Json::array();
  const auto records = image.symbol(kRecords);
  for (std::uint32_t offset = 0; records && offset + 4 <= records->size; offset += 4) {
    const std::uint32_t word = board.word(kRecords, offset);
    if (word != 0) all.push_back(Json::array({word >> 24, word >> 16 & 0xFF, word & 0xFFFF}));
  }
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
