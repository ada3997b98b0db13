#include "emulator/core/provenance.hpp"

namespace finemote::emulator {
namespace {
// runtime/include/finemote/mark.hpp
constexpr std::uint32_t kFirstWorkMark = 0x40000;  // stages are below
constexpr std::uint32_t kHandOverMark = kFirstWorkMark + 2 * 8;
}  // namespace

std::uint32_t Provenance::add_source() {
  sample_counts_.push_back(0);
  return static_cast<std::uint32_t>(sample_counts_.size() - 1);
}

Tag Provenance::sample(std::uint32_t source, Time from, Time readable) {
  return add({Origin::Kind::sample, source, sample_counts_[source]++, from, readable});
}

Tag Provenance::add(const Origin& origin) {
  origins_.push_back(origin);
  return static_cast<Tag>(origins_.size() - 1);
}

const Origin* Provenance::job(Tag tag) const {
  return tag != Tag::none && origin(tag).kind == Origin::Kind::job ? &origin(tag) : nullptr;
}

void Provenance::enter(std::uint32_t frame) {
  interrupted_.leave(std::move(level_), frame);
  level_ = {};
}

void Provenance::reset() {
  ++starts_;
  level_ = {};
  interrupted_.clear();
  made_of_.clear();
  early_.clear();
}

/// Only the first start and the first end count: a jump may come back to the instruction at a mark.
void Provenance::pass_mark(std::uint32_t number, Time at, Claim claim) {
  if (number == kHandOverMark) hand_over();
  if (number >= kFirstWorkMark) return;
  Level& level = level_;
  const std::uint32_t stage = number / 2;
  if (number % 2 == 0 && level.stage != stage) begin(level, stage, at);
  if (number % 2 != 0 && level.stage == stage) end(level, at, claim);
}

void Provenance::begin(Level& level, std::uint32_t stage, Time at) {
  const bool updates = stage % 2 == 0;
  level = {stage, Tag::none, updates};
  if (updates) take_early(level, at);
  if (!updates) level.job = add({Origin::Kind::job, stage, runs_[stage]++, at, at});
}

/// What is no handle sends for none.
void Provenance::hand_over() {
  if (level_.job == Tag::none || level_.has_sent) return;
  level_.has_sent = true;
  handed_over_.push_back(level_.job);
}

/// A parser looked at the whole sample before its end was known by the silence after it: now it is.
void Provenance::take_early(Level& level, Time at) {
  Samples& early = early_[level.stage];
  for (auto it = early.begin(); it != early.end();) {
    const bool is_readable = origin(it->second).readable <= at;
    if (is_readable) level.loaded.insert(*it);
    it = is_readable ? early.erase(it) : std::next(it);
  }
}

/// It looked at a sample whose end came while it ran: whether it saw that is unknown.
bool Provenance::may_have_taken(const Level& level, std::uint32_t source, Time at) {
  const Samples& early = early_[level.stage];
  const auto sample = early.find(source);
  return sample != early.end() && origin(sample->second).readable <= at;
}

/// Where it took nothing new from a source, its state is still made of what it took before. What it loads of older
/// samples is what others made of them.
void Provenance::end(Level& level, Time at, Claim claim) {
  if (level.looks) {
    Samples& state = made_of_[level.stage];
    for (const auto& [source, tag] : level.loaded) state[source] = newest(state[source], tag);
    for (const auto& [source, tag] : state) {
      if (!may_have_taken(level, source, at))
        uses_.push_back({at, level.stage, tag, starts_ > 1 ? std::nullopt : claim});
    }
  }
  level = {};
}

/// Of a sample that is still arriving a parser may look at what there is: that takes nothing before it has arrived.
void Provenance::loaded(Tag tag, Time now) {
  if (tag == Tag::none || origin(tag).kind != Origin::Kind::sample) return;
  const bool is_readable = origin(tag).readable <= now;
  Tag& seen = (is_readable ? level_.loaded : early_[level_.stage])[origin(tag).source];
  seen = newest(seen, tag);
}

}  // namespace finemote::emulator
