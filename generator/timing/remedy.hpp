// Changes that help, each found by analysing the robot as it would be with them: what a hint promises has been
// computed.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "generator/timing/analyse.hpp"

namespace finemote::gen::timing {

/// Changes as a hint proposes them.
struct Proposal {
  std::vector<Change> changes;
  std::string text;  ///< `period="2ms" for the devices with period 1ms`
};

/// Proposals of one kind, weakest first.
using Family = std::vector<Proposal>;

/// What is to become smaller, and how small is enough.
struct Goal {
  std::function<double(const Timing&)> value;  ///< infinity where there is none
  double enough = 0;                           ///< reached at this value and below
  bool of_chains = false;                      ///< value() looks at chains, or at a latency
};

/// A proposal with what the analysis of the changed robot gave.
struct Remedy {
  Proposal proposal;
  double value = 0;     ///< of the goal
  bool enough = false;  ///< the goal is reached; else the value is only smaller than it is now
  double processor_load = 0;
  bool schedulable = false;
};

/// Looks for remedies of one analysed robot. Nothing is proposed that costs schedulability, a bound or a requirement
/// that holds, or overloads a bus. The number of robots analysed is limited by their size, and the steps of each: large
/// robots get fewer hints, never wrong ones.
class Trials {
 public:
  /// `request` is the one `timing` answers; without Remodel there are no remedies. Both must outlive this.
  Trials(const Timing& timing, const AnalysisRequest& request);

  /// Of every family the first proposal that reaches the goal; where none of any does, of every family the one that
  /// comes nearest, if it is nearer than now. Best first, no more than `most`.
  std::vector<Remedy> find(const std::vector<Family>& families, const Goal& goal, std::size_t most = 3);

  /// The robot with these changes, analysed; none where it would be refused, takes too long, or trials are used up.
  /// `verdict_only`: as in AnalysisRequest, for what needs no more.
  std::optional<Timing> outcome(const std::vector<Change>& changes, bool verdict_only = false);

 private:
  /// Of a robot that misses deadlines no bound of a chain can be lost.
  [[nodiscard]] bool needs_chains(const Goal& goal) const;
  [[nodiscard]] bool does_no_harm(const Timing& after) const;
  std::optional<Remedy> best_of(const Family& family, const Goal& goal);

  const Timing& timing_;
  const Remodel& remodel_;
  AnalysisRequest request_;
  int left_ = 0;
};

/// Longer periods of `devices`, a multiple of what they are each. `who` names them in the text.
Family longer_periods(const Model& model, const std::vector<Rank>& devices, const std::string& who);

/// Shorter periods of `devices`, down to one tick.
Family shorter_periods(const Model& model, const std::vector<Rank>& devices, const std::string& who);

/// Faster rates of a bus that its port and its devices make; slower ones.
Family faster_rates(const Model& model, BusPlace bus);
Family slower_rates(const Model& model, BusPlace bus);

/// The later half of its devices, or fewer, on another bus of its kind.
Family other_bus(const Model& model, BusPlace bus);

/// Nine tenths to half of what update and handle of `devices` take now.
Family less_work(const Model& model, const std::vector<Rank>& devices, const std::string& who);

/// Remedies for a robot that is not schedulable: single ones where they are enough, else several changes together, else
/// those that lower the load of the processor most.
std::vector<Remedy> processor_remedies(const Timing& timing, Trials& trials);

/// Such a remedy as a hint, with the load that results.
std::string processor_hint(const Timing& timing, const Remedy& remedy);

}  // namespace finemote::gen::timing
