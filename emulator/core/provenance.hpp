// Which sample of a sensor's part an update took, and which run of a handle an output carries: found by following bytes
// through the machine, whatever the firmware says of them.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <vector>

#include "emulator/core/interrupted.hpp"
#include "emulator/core/tag.hpp"
#include "emulator/time.hpp"

namespace finemote::emulator {

/// What tagged bytes come from.
struct Origin {
  enum class Kind : std::uint8_t {
    sample,  ///< of a source: a quantity of a part
    job,     ///< a run of the handle of a stage
  };
  Kind kind = Kind::sample;
  std::uint32_t source = 0;  ///< number of the source, or of the stage
  std::uint32_t n = 0;       ///< counts samples of the source, or runs of the stage since power-on, from 0
  Time from = 0;             ///< when the quantity was sampled, or the run began
  Time readable = 0;         ///< when the last bit of the sample could be read
};

/// When the data of a state were taken, as the firmware says: its time [ns]; none where the state is not valid, it is
/// unknown where it lies, or the firmware has begun to count anew.
using Claim = std::optional<std::int64_t>;

/// An update ended, and its state is made of this sample of a source.
struct Use {
  Time at = 0;
  std::uint32_t stage = 0;
  Tag sample = Tag::none;
  Claim claimed;
};

/// Knows where bytes can come from, and what the stages of a schedule do with them. Stages are known by their marks:
/// runtime/include/finemote/mark.hpp.
class Provenance {
 public:
  /// A new source of samples.
  std::uint32_t add_source();
  /// The next sample of a source.
  Tag sample(std::uint32_t source, Time from, Time readable);
  /// What a tag means; not of `none`.
  [[nodiscard]] const Origin& origin(Tag tag) const { return origins_[static_cast<std::size_t>(tag)]; }
  /// The same of a job's bytes; null of others.
  [[nodiscard]] const Origin* job(Tag tag) const;

  /// Runs of handles that gave a driver something to send, in that order.
  [[nodiscard]] const std::vector<Tag>& handed_over() const { return handed_over_; }

  /// At the end of every update what its state is made of, in the order of time.
  [[nodiscard]] const std::vector<Use>& uses() const { return uses_; }

  // What the processor does; `frame` is where the registers of what is interrupted lie.
  /// @param claim  of the device whose update ends here
  void pass_mark(std::uint32_t number, Time at, Claim claim);
  void enter(std::uint32_t frame);
  void tail() { level_ = {}; }
  void resume(std::uint32_t frame) { level_ = interrupted_.come_back(frame); }
  /// Nothing of what was computed is left; what is counted goes on.
  void reset();

  /// What every byte that is stored now comes from, whatever it was made of; none outside of a handle.
  [[nodiscard]] Tag writes_as() const { return level_.job; }
  /// An update is running: what is loaded counts.
  [[nodiscard]] bool looks() const { return level_.looks; }
  void loaded(Tag tag, Time now);

 private:
  using Samples = std::map<std::uint32_t, Tag>;  ///< by source
  /// What runs at one level of preemption, or in one thread.
  struct Level {
    std::uint32_t stage = kNoStage;
    Tag job = Tag::none;
    bool looks = false;
    bool has_sent = false;
    Samples loaded = {};  ///< newest of each source
  };
  static constexpr std::uint32_t kNoStage = ~0U;

  Tag add(const Origin& origin);
  void begin(Level& level, std::uint32_t stage, Time at);
  void end(Level& level, Time at, Claim claim);
  void hand_over();
  void take_early(Level& level, Time at);
  [[nodiscard]] bool may_have_taken(const Level& level, std::uint32_t source, Time at);

  unsigned starts_ = 0;                          ///< of the processor
  std::vector<Origin> origins_{Origin{}};        ///< by tag
  std::vector<std::uint32_t> sample_counts_;     ///< by source
  std::map<std::uint32_t, std::uint32_t> runs_;  ///< of handles, by stage
  std::map<std::uint32_t, Samples> made_of_;     ///< by stage of an update
  std::map<std::uint32_t, Samples> early_;       ///< the same: loaded, but not readable yet
  Level level_;                                  ///< what runs now
  Interrupted<Level> interrupted_;
  std::vector<Use> uses_;
  std::vector<Tag> handed_over_;
};

}  // namespace finemote::emulator
