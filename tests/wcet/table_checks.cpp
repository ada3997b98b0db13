#include "wcet/table_checks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "emulator/core/instruction.hpp"
#include "emulator/core/interlock.hpp"
#include "emulator/core/operation.hpp"
#include "generator/image/transfer.hpp"
#include "wcet/documents.hpp"

namespace finemote::test {
namespace {

using namespace gen::wcet;
using emulator::Opcode;
using emulator::Operation;

constexpr std::uint16_t kFirstWide = 0xE800;

bool is_it(std::uint16_t op) { return (op & 0xFF00U) == 0xBF00U && (op & 0xFU) != 0; }

std::string bytes_of(const std::vector<Encoding>& codes) {
  std::string bytes;
  const auto put = [&](std::uint16_t half) {
    bytes.push_back(static_cast<char>(half & 0xFFU));
    bytes.push_back(static_cast<char>(half >> 8U));
  };
  for (const Encoding& code : codes) {
    put(code.first);
    if (code.first >= kFirstWide) put(code.second);
  }
  return bytes;
}

std::vector<Encoding> encodings() {
  std::vector<Encoding> codes;
  for (unsigned first = 0; first < kFirstWide; ++first) {
    if (!is_it(static_cast<std::uint16_t>(first))) codes.push_back({static_cast<std::uint16_t>(first), 0});
  }
  // Second halfwords: every operation field of the wide encodings, with registers that differ.
  std::vector<std::uint16_t> seconds;
  for (unsigned high = 0; high < 16; ++high) {
    for (const unsigned low : {0x123U, 0x0F0U, 0xA40U, 0xA61U, 0xAC2U, 0xA10U, 0xB04U, 0xD01U})
      seconds.push_back(static_cast<std::uint16_t>(high << 12U | low));
  }
  for (unsigned first = kFirstWide; first <= 0xFFFF; first += 3) {  // 3: no divisor of the fields' sizes
    for (const std::uint16_t second : seconds) codes.push_back({static_cast<std::uint16_t>(first), second});
  }
  return codes;
}

std::uint32_t emulated(const Operation& o) { return o.info.cycles; }

/// What the next instruction may wait for, and what may wait for the one before.
const std::vector<Operation>& neighbours() {
  static const std::vector<Operation> all = [] {
    std::vector<Operation> list;
    for (unsigned reg = 0; reg < 8; ++reg) {
      list.push_back(emulator::take_apart(static_cast<std::uint16_t>(0x3001U | reg << 8U), 0));  // adds
      list.push_back(emulator::take_apart(static_cast<std::uint16_t>(0x6800U | reg << 3U), 0));  // ldr r0, [reg]
    }
    list.push_back(emulator::take_apart(0xEE30, 0x0A20));  // vadd.f32 s0, s0, s1
    list.push_back(emulator::take_apart(0xEE31, 0x1A01));  // vadd.f32 s2, s2, s2
    list.push_back(emulator::take_apart(0xEEB4, 0x0A60));  // vcmp.f32 s0, s1
    list.push_back(emulator::take_apart(0xEEF1, 0xFA10));  // vmrs
    return list;
  }();
  return all;
}

const std::vector<gen::Instruction>& decoded_neighbours() {
  static const std::vector<gen::Instruction> all = [] {
    std::vector<Encoding> codes;
    for (unsigned reg = 0; reg < 8; ++reg) {
      codes.push_back({static_cast<std::uint16_t>(0x3001U | reg << 8U), 0});
      codes.push_back({static_cast<std::uint16_t>(0x6800U | reg << 3U), 0});
    }
    codes.push_back({0xEE30, 0x0A20});
    codes.push_back({0xEE31, 0x1A01});
    codes.push_back({0xEEB4, 0x0A60});
    codes.push_back({0xEEF1, 0xFA10});
    return gen::decode(0, bytes_of(codes));
  }();
  return all;
}

/// The refill is the way's, not the instruction's.
bool goes_elsewhere(const gen::Instruction& i) {
  const auto kind = gen::transfer_of(i).kind;
  return kind != gen::Transfer::Kind::next && kind != gen::Transfer::Kind::stop;
}

class Comparison {
 public:
  explicit Comparison(const CostTable& table) : table_(table) {
    for (const gen::Instruction& i : decoded_neighbours())
      neighbour_times_.push_back(longest_time(i, table).value_or(0));
  }

  void compare(const Decoded& decoded) {
    const auto longest = longest_time(decoded.instruction, table_);
    const Operation o = emulator::take_apart(decoded.code.first, decoded.code.second);
    if (!longest || o.kind == Opcode::undefined) return;
    ++excess_.compared;
    // Of both the way elsewhere costs a refill.
    const Cycles more = goes_elsewhere(decoded.instruction) ? table_.taken : 0;
    const Cycles refill = goes_elsewhere(decoded.instruction) ? emulator::kRefillCycles : 0;
    check(decoded, emulated(o) + refill, *longest + more);
    for (std::size_t i = 0; i < neighbours().size(); ++i) {
      const Operation& other = neighbours()[i];
      const Cycles both = *longest + neighbour_times_[i];
      check(decoded, emulated(o) + emulated(other) + emulator::interlock(o, other), both);
      check(decoded, emulated(other) + emulated(o) + emulator::interlock(other, o), both);
    }
  }

  Excess result() { return std::move(excess_); }

 private:
  void check(const Decoded& decoded, Cycles emulated, Cycles longest) {
    if (emulated <= longest) return;
    if (++excess_.count <= 10)
      excess_.found.push_back(fmt::format("'{}' ({:04x} {:04x}): {} emulated, {} at most", decoded.instruction.text,
                                          decoded.code.first, decoded.code.second, emulated, longest));
  }

  const CostTable& table_;
  std::vector<Cycles> neighbour_times_;
  Excess excess_;
};

}  // namespace

std::vector<Decoded> decoded_grid() {
  const std::vector<Encoding> codes = encodings();
  const std::vector<gen::Instruction> all = gen::decode(0, bytes_of(codes));
  std::vector<Decoded> known;
  for (std::size_t i = 0; i < codes.size() && i < all.size(); ++i) {
    if (all[i].is_known()) known.push_back({codes[i], all[i]});
  }
  return known;
}

std::vector<Decoded> documented_instructions() {
  std::vector<Decoded> known;
  for (const ManualRow& row : manual_rows()) {
    const Encoding code{row.code[0], row.code.size() > 1 ? row.code[1] : std::uint16_t{0}};
    for (const gen::Instruction& i : gen::decode(0, bytes_of({code}))) known.push_back({code, i});
  }
  return known;
}

std::vector<std::string> differences_from_documents(const CostTable& table) {
  std::vector<std::string> differences;
  std::set<unsigned> held;
  for (const ManualRow& row : manual_rows()) {
    const Encoding code{row.code[0], row.code.size() > 1 ? row.code[1] : std::uint16_t{0}};
    const auto decoded = gen::decode(0, bytes_of({code}));
    const auto longest = decoded.size() == 1 ? longest_time(decoded[0], table) : std::nullopt;
    if (!longest || *longest != row.cycles + row.more)
      differences.push_back(fmt::format("{}: {} by table {}, {} in the cost table", row.text, row.cycles + row.more,
                                        row.table, longest.value_or(-1)));
    if (decoded.size() == 1) held.insert(decoded[0].id);
  }
  for (const OtherRow& row : other_rows()) {
    if (row.of(table) != row.cycles)
      differences.push_back(
          fmt::format("{}: {} by {}, {} in the cost table", row.name, row.cycles, row.source, row.of(table)));
  }
  for (const CostTable::Row& row : table.fixed) {
    if (held.count(row.id) == 0)
      differences.push_back(fmt::format("instruction {} is in no row of documents.hpp", row.id));
  }
  return differences;
}

Excess excess_over(const CostTable& table, const std::vector<Decoded>& grid) {
  Comparison comparison(table);
  for (const Decoded& decoded : grid) comparison.compare(decoded);
  return comparison.result();
}

}  // namespace finemote::test
