#include "emulator/chain.hpp"

#include <algorithm>
#include <optional>

namespace finemote::emulator {
namespace {

/// The last run that had ended at `time`.
std::optional<StageRun> last_ended(const std::vector<std::vector<StageRun>>& runs, std::size_t stage,
                                   std::int64_t time) {
  if (stage >= runs.size()) return std::nullopt;
  const auto& list = runs[stage];
  const auto after = std::upper_bound(list.begin(), list.end(), time,
                                      [](std::int64_t t, const StageRun& run) { return t < run.end_ns; });
  return after == list.begin() ? std::nullopt : std::optional<StageRun>(*(after - 1));
}

std::optional<std::int64_t> source_of(const std::vector<std::vector<StageRun>>& runs, const std::vector<unsigned>& up,
                                      const std::vector<unsigned>& down, const StageRun& last) {
  std::int64_t time = last.begin_ns;
  const auto step = [&](std::size_t stage) {
    const auto run = last_ended(runs, stage, time);
    if (run) time = run->begin_ns;
    return run.has_value();
  };
  for (std::size_t i = down.size() - 1; i-- > 0;) {
    if (!step(2 * std::size_t{down[i]} + 1)) return std::nullopt;
  }
  for (std::size_t i = up.size(); i-- > 0;) {
    if (!step(2 * std::size_t{up[i]})) return std::nullopt;
  }
  return time;
}

}  // namespace

std::vector<std::vector<StageRun>> stage_runs(const std::vector<StageEvent>& events) {
  std::vector<std::vector<StageRun>> runs;
  std::vector<std::int64_t> begun;
  for (const StageEvent& event : events) {
    if (event.stage >= runs.size()) {
      runs.resize(event.stage + 1);
      begun.resize(event.stage + 1, -1);
    }
    if (event.begin) {
      begun[event.stage] = event.t_ns;
    } else if (begun[event.stage] >= 0) {
      runs[event.stage].push_back(StageRun{begun[event.stage], event.t_ns});
      begun[event.stage] = -1;
    }
  }
  return runs;
}

std::vector<ChainSample> chain_samples(const std::vector<std::vector<StageRun>>& runs, const std::vector<unsigned>& up,
                                       const std::vector<unsigned>& down) {
  std::vector<ChainSample> samples;
  if (up.empty() || down.empty()) return samples;
  const std::size_t last_stage = 2 * std::size_t{down.back()} + 1;
  if (last_stage >= runs.size()) return samples;
  for (const StageRun& run : runs[last_stage]) {
    if (const auto begin = source_of(runs, up, down, run)) samples.push_back(ChainSample{*begin, run.end_ns});
  }
  return samples;
}

}  // namespace finemote::emulator
