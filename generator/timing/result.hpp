// The answers of the timing analysis, in the shape of `finemote.timing/1`.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "generator/timing/model.hpp"

namespace finemote::gen::timing {

/// `paper`: the published analysis, corrected. `tight`: true bus separation, release-specific responses, windows.
/// `target`: `tight` with the costs of the processor and the scheduler.
enum class Profile { paper, tight, target };

std::string_view profile_name(Profile profile);

/// The one that knows the robot best: `target` where the model has one, else `tight`.
Profile best_profile(const Model& model);

struct Utilization {
  std::string exact;  ///< reduced fraction `p/q`
  double value = 0;
  bool overload = false;  ///< p > q
};

struct LiuLayland {
  std::size_t n = 0;  ///< buses + buckets
  double bound = 0;   ///< n (2^(1/n) - 1)
  bool ok = false;    ///< decided exactly
};

struct BucketResult {
  Duration period;
  Duration wcet;
  std::vector<Rank> devices;         ///< registration order
  std::optional<Duration> response;  ///< end of the last stage (profile target: of the whole job)
  bool ok = false;
  bool closed_form = false;  ///< the search for the response was given up: it may be too large, and `ok` too strict
};

/// Bounds of one device; null where its bucket is not schedulable.
struct DeviceResult {
  Duration b_plus, b_minus;
  std::optional<Duration> r_plus, r_minus;
  std::optional<Duration> window;  ///< start of update to end of handle; profiles tight and target
  bool closed_form = false;        ///< bounds that may be larger than the exact ones
};

struct PathResult {
  Rank leaf;
  std::optional<Duration> latency;
  std::optional<Duration> release, source_release;  ///< null with `closed_form`
  bool closed_form = false;                         ///< a safe bound instead of the maximum: that is beyond the limits
};

struct TreeResult {
  enum class Class { same_period, harmonic, general };
  Rank root;
  Class kind = Class::general;
  std::optional<Duration> latency;
  std::optional<Rank> worst_leaf;
  std::optional<Duration> worst_release, source_release;
  std::optional<Duration> corollary;      ///< profile paper
  std::optional<Duration> cross_latency;  ///< profile paper
  std::vector<PathResult> paths;          ///< leaves in registration order
  bool closed_form = false;               ///< some latency is a safe bound instead of the maximum
};

/// The interrupt that releases jobs, where its timer keeps one release that waits for it: it has to be through with one
/// before the next one comes.
struct ReleaseResult {
  std::optional<Duration> response;                  ///< from a release on, by the board's clock; none: no bound
  Duration deadline;                                 ///< the shortest time between two releases
  Duration period = nanoseconds(1), other = period;  ///< whose releases come so close
  bool is_in_between = false;                        ///< an interrupt that releases nothing comes as close as that
  bool is_alone = false;                             ///< but for lost releases every job ends in time
  [[nodiscard]] bool ok() const { return response.has_value() && *response <= deadline; }
  /// What keeps the robot from being schedulable is this alone.
  [[nodiscard]] bool is_guilty() const { return !ok() && is_alone; }
};

struct ProfileResult {
  Profile profile = Profile::paper;
  bool schedulable = false;
  std::optional<ReleaseResult> release;  ///< none: no release can be lost
  std::vector<BucketResult> buckets;     ///< ascending period
  Table<Rank, DeviceResult> devices;
  std::vector<TreeResult> trees;  ///< order of their roots
};

}  // namespace finemote::gen::timing
