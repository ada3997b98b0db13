// The documents whose results a report shows, and which of them belong together.
#pragma once

#include <map>
#include <string>
#include <utility>

#include "generator/report/place.hpp"

namespace finemote::gen::report {

/// As `analyze`, `simulate` and `run` print them with `--format json`.
struct Documents {
  Json timing;      ///< finemote.timing/1
  Json simulation;  ///< finemote.simulation/1, of the same chains in the same order
  Json run;         ///< finemote.run/1; null: there is none
  Json against;     ///< finemote.timing/1 of what the robot was before; null: there is none

  [[nodiscard]] Place of_timing() const { return {timing, "timing"}; }
  [[nodiscard]] Place of_simulation() const { return {simulation, "simulation"}; }
  [[nodiscard]] Place of_run() const { return {run, "run"}; }
  [[nodiscard]] Place of_against() const { return {against, "against"}; }
  [[nodiscard]] bool has_run() const { return !run.is_null(); }

  /// The profile whose verdict counts, in timing.
  [[nodiscard]] Place of_verdict() const;
};

/// Where a run holds what belongs to a device or chain of the analysis.
class Measurements {
 public:
  explicit Measurements(const Documents& documents);

  [[nodiscard]] Place chain(const std::string& from, const std::string& to) const;
  [[nodiscard]] Place response(const std::string& device) const;
  [[nodiscard]] Place stage(const std::string& device, const std::string& stage) const;

 private:
  using Key = std::pair<std::string, std::string>;
  using Places = std::map<Key, std::size_t>;
  [[nodiscard]] static Places places_of(const Place& list, const char* first, const char* second);
  [[nodiscard]] Place found(const Place& list, const Places& places, const Key& key) const;

  Place chains_, responses_, stages_, nothing_;
  Places chain_at_, response_at_, stage_at_;
};

}  // namespace finemote::gen::report
