#include "emulator/core/intel_hex.hpp"

#include <charconv>
#include <numeric>
#include <sstream>
#include <stdexcept>

namespace finemote::emulator {
namespace {

/// Everything of a line after its colon; none: it is no record, or its sum is wrong.
std::vector<std::uint8_t> bytes_of(const std::string& line) {
  std::vector<std::uint8_t> bytes;
  for (std::size_t i = 1; i + 1 < line.size(); i += 2) {
    std::uint8_t byte = 0;
    const char* end = line.data() + i + 2;
    if (std::from_chars(line.data() + i, end, byte, 16).ptr != end) return {};
    bytes.push_back(byte);
  }
  const bool is_whole = line.size() % 2 == 1 && bytes.size() >= 5 && bytes.size() == bytes[0] + 5U;
  const bool is_right = std::accumulate(bytes.begin(), bytes.end(), 0U) % 256 == 0;
  return is_whole && is_right ? bytes : std::vector<std::uint8_t>{};
}

void append(std::vector<Segment>& segments, std::uint32_t address, const std::uint8_t* begin, const std::uint8_t* end) {
  if (segments.empty() || segments.back().address + segments.back().bytes.size() != address)
    segments.push_back({address, {}});
  segments.back().bytes.insert(segments.back().bytes.end(), begin, end);
}

}  // namespace

std::vector<Segment> parse_intel_hex(const std::string& text) {
  enum Type : unsigned { kData = 0, kEnd = 1, kSegmentBase = 2, kLinearBase = 4 };
  std::vector<Segment> segments;
  std::istringstream lines(text);
  std::uint32_t base = 0;
  unsigned number = 0;
  for (std::string line; std::getline(lines, line);) {
    ++number;
    while (!line.empty() && (line.back() == '\r' || line.back() == ' ')) line.pop_back();
    if (line.empty()) continue;
    const std::vector<std::uint8_t> record = line[0] == ':' ? bytes_of(line) : std::vector<std::uint8_t>{};
    if (record.empty()) throw std::runtime_error("line " + std::to_string(number) + " is no record of Intel HEX");
    const std::uint32_t offset = record[1] * 256U + record[2], type = record[3];
    const std::uint8_t* data = record.data() + 4;
    if (type == kEnd) break;
    if (type == kData) append(segments, base + offset, data, data + record[0]);
    if ((type == kSegmentBase || type == kLinearBase) && record[0] == 2)
      base = (data[0] * 256U + data[1]) << (type == kLinearBase ? 16 : 4);
  }
  return segments;
}

}  // namespace finemote::emulator
