// What an image of the kit printed, held against what its plan expects.
#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "generator/bench_kit/plan.hpp"

namespace finemote::gen {

inline constexpr const char* kBenchFormat = "finemote.bench/1";

/// A document finemote.bench/1, as an image prints it.
struct BenchRecord {
  struct Entry {
    std::string name;
    std::optional<std::int64_t> value;  ///< none: the test could not be done
    nlohmann::ordered_json expected;    ///< as the image printed it
    bool was_ok = false;                ///< as the image judged it
    std::string why;                    ///< there is no value
  };
  std::string board, robot, plan;
  std::vector<Entry> tests;
  std::vector<std::pair<std::string, std::string>> not_done;  ///< name, and what it lacks
};

/// The last whole record in a text: of a file that holds nothing else, or of what a terminal or the emulator wrote.
/// @return nothing: there is none
std::optional<BenchRecord> find_bench_record(const std::string& text);

/// One test, as recorded and as expected here.
struct BenchVerdict {
  std::string name;
  std::optional<std::int64_t> value;
  nlohmann::ordered_json expected;
  bool is_ok = false;
  std::string ground, source;  ///< of the expectation
  std::string why;             ///< it is not ok; empty: the value is another one
};

struct BenchJudgement {
  std::vector<BenchVerdict> tests;
  std::vector<std::pair<std::string, std::string>> not_done;  ///< that need what is not there
  [[nodiscard]] bool is_good() const;
};

/// Every test of the plan, in its order, and then those the record has besides. Expectations are those of the plan; the
/// record's own count where the plan does not know the test.
BenchJudgement judge_bench(const BenchRecord& record, const BenchPlan& plan);

/// A number, or `{"min", "max"}`; null where nothing is claimed.
nlohmann::ordered_json expectation_of(const BenchTest& test);

}  // namespace finemote::gen
