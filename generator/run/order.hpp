// Whether the stages of every job ran in the order of the plan: updates from leaf to root, then handles back.
#pragma once

#include <optional>
#include <string>

#include "generator/run/record.hpp"
#include "generator/schedule/schedule.hpp"

namespace finemote::gen {

struct OrderVerdict {
  bool is_judged = false;              ///< some job ran
  std::optional<std::string> mistake;  ///< the first stage that was not the next one, in words; none: all were
};

/// After a reset a bucket may begin anew with its first stage.
OrderVerdict judge_order(const Robot& robot, const Schedule& schedule, const RunRecord& record);

}  // namespace finemote::gen
