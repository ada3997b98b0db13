#include "wcet/recording.hpp"

#include <algorithm>
#include <cstring>
#include <functional>
#include <memory>
#include <unordered_set>

#include "emulator/board.hpp"
#include "emulator/program/job.hpp"

namespace finemote::test {
namespace {

using emulator::Board;
using emulator::ExecutionEvent;
using Kind = Passage::Kind;

constexpr unsigned kFirstLine = 16;

class Recorder {
 public:
  Recorder(Board& board, const Watched& watched, Recording& into)
      : board_(board), watched_(watched), borders_(watched.borders.begin(), watched.borders.end()), into_(into) {
    levels_.push_back({});
  }

  /// Before every instruction outside of IT blocks, and before the first of one.
  void probe(std::uint32_t pc) {
    take_events();
    if (levels_.size() == 1) return;
    Level& level = levels_.back();
    const std::uint64_t done = board_.cpu().instructions();
    const bool is_again = level.begun && level.pc == pc && (level.is_pending || level.done == done);
    level.is_pending = false;
    level.done = done;
    if (is_again) return;
    if (!level.begun) {
      look_at_words();
      into_.cycle = board_.world().system().clock().period();
      add({board_.cpu().now(), pc, Kind::first});
    } else if (pc != level.next || borders_.count(pc) != 0) {
      add({board_.cpu().now(), pc, Kind::block, false, is_high(level.exception)});
    }
    level.begun = true;
    level.pc = pc;
    level.next = pc + size_at(pc);
  }

  void take_events() {
    const auto& log = board_.log();
    for (; seen_ < log.size(); ++seen_) take(log[seen_]);
  }

 private:
  struct Level {
    std::uint32_t exception = 0;
    bool begun = false;
    bool is_pending = false;         ///< the instruction probed last may not have run
    std::uint32_t pc = 0, next = 0;  ///< of the instruction probed last, and after it
    std::uint64_t done = 0;          ///< instructions of the board when it was probed
  };

  void add(Passage passage) { into_.passages.push_back(passage); }

  /// Of the instruction there, with all of its IT block: inside of one nothing is probed.
  std::uint32_t size_at(std::uint32_t pc) {
    std::uint32_t size = bytes_at(pc);
    const std::uint16_t op = half(pc);
    const bool is_it = (op & 0xFF00U) == 0xBF00U && (op & 0xFU) != 0;
    if (!is_it) return size;
    const unsigned covered = 4 - static_cast<unsigned>(__builtin_ctz(op & 0xFU));
    for (unsigned i = 0; i < covered; ++i) size += bytes_at(pc + size);
    return size;
  }
  std::uint16_t half(std::uint32_t address) {
    std::uint16_t op = 0;
    if (const std::uint8_t* bytes = board_.cpu().memory(address, 2)) std::memcpy(&op, bytes, 2);
    return op;
  }
  std::uint32_t bytes_at(std::uint32_t address) { return half(address) >= 0xE800 ? 4 : 2; }

  void begin(const ExecutionEvent& event, bool is_tail) {
    has_started_ |= event.number == watched_.words_from;
    Passage passage{event.at, event.number, Kind::begin};
    passage.is_tail = is_tail;
    passage.is_high = is_high(event.number);
    add(passage);
    levels_.push_back({event.number});
  }

  /// The peripheral holds the line of this exception up.
  [[nodiscard]] bool is_high(std::uint32_t exception) {
    return exception >= kFirstLine && board_.world().system().nvic().is_high(static_cast<int>(exception - kFirstLine));
  }

  void take(const ExecutionEvent& event) {
    switch (event.kind) {
      case ExecutionEvent::Kind::enter:
        // One more may come before the instruction is probed again.
        levels_.back().is_pending |= levels_.back().begun && levels_.back().done == board_.cpu().instructions();
        return begin(event, false);
      case ExecutionEvent::Kind::tail:
        levels_.pop_back();
        return begin(event, true);
      case ExecutionEvent::Kind::leave:
        return add({event.at, event.number, Kind::leave});
      case ExecutionEvent::Kind::resume:
        if (levels_.size() > 1) levels_.pop_back();
        return add({event.at, event.number, Kind::resume});
      case ExecutionEvent::Kind::mark:
        if (levels_.size() > 1) add({event.at, event.number, Kind::mark});
        return;
      default:
        return;
    }
  }

  void look_at_words() {
    if (!has_started_) return;
    for (const auto& [address, value] : watched_.words) {
      std::uint32_t held = 0;
      if (const std::uint8_t* bytes = board_.cpu().memory(address, 4)) std::memcpy(&held, bytes, 4);
      if (held != value && into_.changed.size() < 10)
        into_.changed.push_back(std::to_string(address) + " holds " + std::to_string(held) + " and not " +
                                std::to_string(value));
    }
  }

  Board& board_;
  const Watched& watched_;
  const std::unordered_set<std::uint32_t> borders_;
  Recording& into_;
  std::vector<Level> levels_;
  std::size_t seen_ = 0;
  bool has_started_ = false;
};

}  // namespace

Recording record_job(const nlohmann::ordered_json& job, const Watched& watched) {
  Recording recording;
  std::unique_ptr<Recorder> recorder;
  recording.record = emulator::run_job(job, [&](Board& board) {
    recorder = std::make_unique<Recorder>(board, watched, recording);
    board.cpu().set_probe([&recorder](std::uint32_t pc) { recorder->probe(pc); });
  });
  const auto& record = recording.record;
  if (record.contains("ready_ns")) {
    const auto ready = record.at("first_release_ns").get<std::int64_t>() + record.at("ready_ns").get<std::int64_t>();
    recording.ready_at = emulator::from_ns(static_cast<std::uint64_t>(ready));
  }
  return recording;
}

}  // namespace finemote::test
