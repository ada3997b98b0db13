// What `finemote run` says of a robot on the emulated board.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "catch.hpp"
#include "tests/cli/program.hpp"

namespace finemote::test {

struct JudgedRun {
  int exit_status = 0;
  nlohmann::json document;

  /// The entry of a device in one of the document's lists.
  [[nodiscard]] nlohmann::json of(const std::string& list, const std::string& device) const {
    for (const auto& entry : document[list]) {
      if (entry["device"] == device) return entry;
    }
    FAIL("no '" << device << "' in " << list);
    return {};
  }
  [[nodiscard]] bool reports(const std::string& code, const std::string& words = {}) const {
    for (const auto& finding : document["diagnostics"]) {
      if (finding["code"] == code && finding["message"].get<std::string>().find(words) != std::string::npos)
        return true;
    }
    return false;
  }
};

inline JudgedRun run_robot(const std::string& robot, const std::string& duration,
                           const std::vector<std::string>& options = {}) {
  std::vector<std::string> words = {"run", robot, "--duration", duration, "--format", "json"};
  words.insert(words.end(), options.begin(), options.end());
  const auto ran = run_finemote(words);
  INFO(ran.output);
  const auto begin = ran.output.find('{');
  REQUIRE(begin != std::string::npos);
  return {ran.exit_status, nlohmann::json::parse(ran.output.substr(begin))};
}

}  // namespace finemote::test
