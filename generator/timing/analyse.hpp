// Model to timing: every profile, chains, bus loads and requirements in one value.
#pragma once

#include "generator/diagnostic/diagnostics.hpp"
#include "generator/timing/chains.hpp"
#include "generator/timing/change.hpp"
#include "generator/timing/processor.hpp"
#include "generator/timing/utilization.hpp"

namespace finemote::gen::timing {

/// `<require>`, in terms of the model.
struct Requirement {
  enum class Kind { latency_end_to_end, latency_decision, utilization, jitter };
  Kind kind = Kind::latency_end_to_end;
  std::string text;             ///< the operand as written
  std::vector<Rank> from, to;   ///< latency: the maximum over all pairs; jitter: `to` holds one device
  std::optional<BusPlace> bus;  ///< utilization; none: the processor
  Duration max;
  double max_fraction = 0;
  Position at;

  [[nodiscard]] bool is_latency() const { return kind == Kind::latency_end_to_end || kind == Kind::latency_decision; }
};

struct ChainRequest {
  Rank from, to;
};

struct RequirementResult {
  Requirement requirement;
  std::optional<Duration> value;   ///< latency, jitter
  std::optional<double> fraction;  ///< utilization
  bool ok = false;
  std::optional<ChainResult> chain;         ///< latency: the worst one, or one without a bound
  std::optional<Duration> decide;           ///< latency: the worst decision among all pairs
  std::optional<ChainRequest> unconnected;  ///< latency: a pair no data leads along
  bool connected_backwards = false;         ///< data lead along that pair the other way round
};

struct AnalysisRequest {
  std::optional<Profile> profile;    ///< whose verdict counts; none: best_profile of the model
  std::vector<ChainRequest> chains;  ///< beyond the default ones
  std::vector<Requirement> requirements;
  bool chains_alone = false;  ///< requirements add their chains, and are not judged
  bool inputs = false;        ///< fill Timing::inputs and stamped_inputs
  bool every = false;         ///< fill Timing::others
  Remodel remodel;            ///< to look for hints that help; none: messages are without them
  Limits limits;              ///< of each profile and of the chains
  bool verdict_only = false;  ///< deadlines and loads of the asked profile; no latency, chain, path or window
};

/// Why chains have no bound.
struct MissingBound {
  ChainPart part = ChainPart::acquire;
  std::string why;                       ///< for people
  std::vector<std::size_t> chains;       ///< that lack it for this reason, indices into Timing::chains
  std::vector<std::string> restored_by;  ///< changes after which all of them have a bound, each verified by analysis
};

struct Timing {
  Model model;
  UtilizationTests utilization;
  ProfileResult paper, tight;
  std::optional<ProfileResult> target;
  Profile asked = Profile::tight;   ///< of the verdict
  std::vector<ChainResult> chains;  ///< of the best profile
  std::vector<ChainResult> inputs;  ///< on request: the oldest data behind every command (ChainAnalysis::oldest_inputs)
  std::vector<ChainResult> stamped_inputs;  ///< the same by the time stamps of the data, which may be too early
  Table<Rank, std::optional<Duration>> stamped_ages;  ///< of samples when update() begins, by their time stamps
  Table<Rank, std::optional<Duration>> frame_waits;   ///< what frames on CAN are dated by (frame_waits.hpp)
  std::vector<ChainResult> others;  ///< on request: chains that are not among `chains` (ChainAnalysis::every)
  std::vector<RequirementResult> requirements;
  Table<BusPlace, BusLoad> bus_loads;
  std::vector<ProcessorUse> processor;  ///< in the asked profile, largest load first
  std::vector<MissingBound> missing;    ///< of chains without end-to-end bound
  double processor_load = 0;            ///< share of the processor in the long run, in the asked profile
  std::vector<Rank> assumed;            ///< devices whose execution times are assumed
  std::vector<Rank> above_declared;     ///< devices whose computed execution time is above the declared one
  bool schedulable = false;             ///< in the asked profile

  /// Of best_profile: chains and loads are by it.
  [[nodiscard]] const ProfileResult& best() const { return target ? *target : tight; }
  [[nodiscard]] const ProfileResult& verdict() const {
    return asked == Profile::paper ? paper : asked == Profile::target && target ? *target : tight;
  }
  /// Declared execution times are requirements, too: what was computed must not be above them.
  [[nodiscard]] bool requirements_hold() const;
};

/// Analyses a model that read_model accepts. Reports FM4010 (no result), FM4015 (a bucket of the asked
/// profile may overrun), FM4016 (a requirement fails), FM4018 (a chain that leads nowhere; no result), FM4024 (computed
/// above declared), FM4019 (target asked of a plain model; no result), and as warnings FM4017 (closed forms), FM4020
/// (assumed execution times) and FM4021 (an overloaded bus).
std::optional<Timing> analyse(const Model& model, const AnalysisRequest& request, Diagnostics& diagnostics);

/// From the earliest to the latest end of handle() after a release: its worst response less the least time its job
/// needs to get there. None where the response has no bound.
std::optional<Duration> jitter_bound(const Model& model, const ProfileResult& profile, Rank device);

/// Where a finding about the whole model points.
Position at_first_device(const Model& model);

/// Reports FM4010: what was calculated with the times of a model left 64 bits.
void report_overflow(const Position& at, const Overflow& overflow, Diagnostics& diagnostics);

}  // namespace finemote::gen::timing
