#include "cli/order.hpp"

#include <map>

namespace finemote::test {
namespace {

using nlohmann::json;

std::string stage_name(const json& event) {
  return (event["stage"] == "update" ? "+" : "-") + event["device"].get<std::string>();
}

/// Device name -> index of its bucket.
std::map<std::string, std::size_t> bucket_of(const json& tree) {
  std::map<std::string, std::size_t> buckets;
  for (std::size_t i = 0; i < tree["buckets"].size(); ++i) {
    for (const json& device : tree["buckets"][i]["update"]) buckets[device] = i;
  }
  return buckets;
}

}  // namespace

Job prescribed_job(const json& bucket) {
  Job job;
  for (const json& device : bucket["update"]) job.push_back("+" + device.get<std::string>());
  for (const json& device : bucket["handle"]) job.push_back("-" + device.get<std::string>());
  return job;
}

std::string order_mistake(const json& tree, const json& run) {
  const auto buckets = bucket_of(tree);
  std::vector<Job> prescribed;
  for (const json& bucket : tree["buckets"]) prescribed.push_back(prescribed_job(bucket));
  std::vector<std::size_t> next(prescribed.size(), 0);  // the stage each bucket has to begin next
  std::vector<std::size_t> running;                     // buckets with a stage under way, innermost last
  for (const json& event : run["events"]) {
    const std::size_t bucket = buckets.at(event["device"]);
    const std::string stage = stage_name(event);
    const std::string where = " at " + std::to_string(event["t_ns"].get<std::int64_t>()) + " ns";
    if (event["edge"] == "begin") {
      if (prescribed[bucket][next[bucket]] != stage) {
        return "began " + stage + " where " + prescribed[bucket][next[bucket]] + " was due" + where;
      }
      if (!running.empty() && running.back() <= bucket)
        return stage + " began inside a bucket as urgent or more" + where;
      for (std::size_t faster = 0; faster < bucket; ++faster) {
        if (next[faster] != 0) return stage + " began between stages of a faster bucket" + where;
      }
      running.push_back(bucket);
    } else {
      if (running.empty() || running.back() != bucket || prescribed[bucket][next[bucket]] != stage) {
        return "ended " + stage + " which was not under way" + where;
      }
      running.pop_back();
      next[bucket] = (next[bucket] + 1) % prescribed[bucket].size();
    }
  }
  return {};
}

std::size_t count_jobs(const json& tree, const json& run) {
  std::size_t jobs = 0;
  for (const json& bucket : tree["buckets"]) {
    const std::string last = prescribed_job(bucket).back();
    for (const json& event : run["events"]) jobs += event["edge"] == "end" && stage_name(event) == last ? 1 : 0;
  }
  return jobs;
}

bool shows_preemption(const json& run) {
  int depth = 0;
  for (const json& event : run["events"]) {
    depth += event["edge"] == "begin" ? 1 : -1;
    if (depth > 1) return true;
  }
  return false;
}

}  // namespace finemote::test
