#include "generator/run/phase.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <random>
#include <string>

#include "emulator/scenario/grammar.hpp"

namespace finemote::gen {
namespace {

using Json = nlohmann::ordered_json;

/// Of a part: how far its clock is off, of what it may be, and when it begins, of its period.
struct Clock {
  double error = 0;
  double begin = 0;
};

/// Numbers that are the same with every standard library.
class Draw {
 public:
  explicit Draw(const Phase& phase) {
    std::seed_seq seed{phase.seed, phase.seed >> 32, phase.number, phase.number >> 32};
    engine_.seed(seed);
  }
  /// 0 or more, below 1.
  double part_of_one() { return static_cast<double>(engine_() >> 11) * 0x1p-53; }
  /// An extreme half of the time: that is where bounds are met.
  double both_ways(double most) {
    const double where = part_of_one();
    if (where < 0.25) return -most;
    return where < 0.5 ? most : most * (2 * part_of_one() - 1);
  }
  Clock clock() {
    const double error = both_ways(1);
    return {error, part_of_one()};
  }

 private:
  std::mt19937_64 engine_;
};

/// Of a sensor whose registers say how often it samples: the slowest rate there is, 12.5 Hz of the BMI088 (its data
/// sheet, ACC_CONF). All others of it and of the IST8310 are multiples of that: with a phase from all of it, each has
/// any phase.
constexpr double kSlowestSampling = 80e6;

double usual_period(const scenario::Model& model, const Json& part) {
  if (part.contains("period_ns")) return part.at("period_ns").get<double>();
  const scenario::Member* period = scenario::find_member(model.figures, "period_ns");
  return period == nullptr ? kSlowestSampling : Json::parse(period->usual).get<double>();
}

}  // namespace

double shift_clocks(const Phase& phase, double clock_ppm, const std::map<std::string, double>& declared, Json& parts) {
  Draw draw(phase);
  const double board = draw.both_ways(clock_ppm);
  const bool are_together = draw.part_of_one() < 0.5;
  const Clock common = draw.clock();
  for (Json& part : parts) {
    const scenario::Model* model = scenario::find_model(part.at("type").get<std::string>());
    if (model == nullptr || model->clock_tolerance_ppm == 0) continue;
    const Clock own = are_together ? common : draw.clock();
    const auto known = declared.find(part.at("name").get<std::string>());
    const double most = known == declared.end() ? model->clock_tolerance_ppm : known->second;
    const double ppm = own.error * std::min(model->clock_tolerance_ppm, most);
    part["clock_ppm"] = ((1 + ppm * 1e-6) / (1 + board * 1e-6) - 1) * 1e6;
    part["phase_ns"] = static_cast<std::uint64_t>(own.begin * usual_period(*model, part));
  }
  return board;
}

}  // namespace finemote::gen
