// The order of stages the schedule prescribes, made from the description alone, beside the order a run showed.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace finemote::test {

/// The stages of one job: `+name` for update, `-name` for handle.
using Job = std::vector<std::string>;

/// What `tree` says one job of the bucket runs.
Job prescribed_job(const nlohmann::json& bucket);

/// Takes the events of a run apart into jobs of each bucket and compares every complete job with the prescription; and
/// that no stage of a slower bucket begins while a job of a faster one is under way. Returns what is wrong, or nothing.
std::string order_mistake(const nlohmann::json& tree, const nlohmann::json& run);

/// How many jobs of all buckets a run contains.
std::size_t count_jobs(const nlohmann::json& tree, const nlohmann::json& run);

/// True when some stage was preempted by a stage of another bucket.
bool shows_preemption(const nlohmann::json& run);

}  // namespace finemote::test
