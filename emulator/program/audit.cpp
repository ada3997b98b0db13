#include "emulator/program/audit.hpp"

#include <algorithm>
#include <map>
#include <string_view>

#include "emulator/program/firmware.hpp"

namespace finemote::emulator {
namespace {

using Json = nlohmann::ordered_json;

/// Null: marks, which are told as starts and ends, and loops.
const char* name_of(ExecutionEvent::Kind kind) {
  switch (kind) {
    case ExecutionEvent::Kind::enter:
      return "enter";
    case ExecutionEvent::Kind::tail:
      return "tail";
    case ExecutionEvent::Kind::leave:
      return "return";
    case ExecutionEvent::Kind::resume:
      return "resume";
    case ExecutionEvent::Kind::due:
      return "due";
    case ExecutionEvent::Kind::mask:
      return "mask";
    case ExecutionEvent::Kind::unmask:
      return "unmask";
    case ExecutionEvent::Kind::reset:
      return "reset";
    case ExecutionEvent::Kind::mark:
    case ExecutionEvent::Kind::loop:
    case ExecutionEvent::Kind::save:
      return nullptr;
  }
  return nullptr;
}

struct Line {
  std::int64_t at_ps;
  const char* what;
  std::uint32_t number;
};

}  // namespace

Audit::Audit(Board& board, const Image& image, std::vector<std::uint32_t> buckets, std::vector<std::uint32_t> works)
    : board_(board), image_(image), buckets_(std::move(buckets)), works_(std::move(works)) {
  board_.cpu().on_return = [this](int exception) {
    if (exception == kSysTick) look_for_overruns();
  };
}

/// Null: a mark that nobody asked for.
const char* Audit::name_of_work(std::uint32_t mark) const {
  const bool is_asked = std::ranges::find(works_, mark / 2) != works_.end();
  return !is_asked ? nullptr : mark % 2 == 0 ? "work" : "done";
}

Audit::~Audit() { board_.cpu().on_return = nullptr; }

void Audit::look_for_overruns() {
  const std::vector<std::uint32_t> now = overruns_of(board_, image_);
  counted_.resize(now.size());
  for (std::size_t i = 0; i < now.size() && i < buckets_.size(); ++i) {
    if (now[i] > counted_[i]) overruns_.push_back({board_.world().now(), buckets_[i]});
  }
  counted_ = now;
}

Json Audit::events(std::int64_t zero_ns) const {
  const auto since = [&](Time at) { return static_cast<std::int64_t>(to_ps(at)) - zero_ns * 1'000; };
  std::vector<Line> lines;
  for (const ExecutionEvent& event : board_.log()) {
    if (event.kind == ExecutionEvent::Kind::reset && event.at == 0) continue;  // power-on
    const char* const what =
        event.kind == ExecutionEvent::Kind::mark ? name_of_work(event.number) : name_of(event.kind);
    if (what == nullptr) continue;
    const std::uint32_t number = event.kind == ExecutionEvent::Kind::mark ? event.number / 2 : event.number;
    lines.push_back({since(event.at), what, number});
  }
  for (const BracketEvent& event : board_.own_times().events()) {
    if (event.bracket < kFirstWork) lines.push_back({since(event.at), event.is_end ? "end" : "begin", event.bracket});
  }
  for (const Overrun& overrun : overruns_) lines.push_back({since(overrun.at), "overrun", overrun.exception});
  std::stable_sort(lines.begin(), lines.end(), [](const Line& a, const Line& b) { return a.at_ps < b.at_ps; });
  Json names = Json::array();
  std::map<std::string_view, std::uint32_t> known;
  std::vector<std::int64_t> numbers;
  numbers.reserve(3 * lines.size());
  for (const Line& line : lines) {
    const auto [name, is_new] = known.try_emplace(line.what, static_cast<std::uint32_t>(known.size()));
    if (is_new) names.push_back(line.what);
    numbers.insert(numbers.end(), {line.at_ps, name->second, line.number});
  }
  return {{"names", std::move(names)}, {"events", std::move(numbers)}};
}

}  // namespace finemote::emulator
