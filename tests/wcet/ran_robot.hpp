// A robot that `finemote run` has compiled and started: its image, and the job of the emulated board.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "catch.hpp"
#include "cli/program.hpp"

namespace finemote::test {

class RanRobot {
 public:
  /// @param words  of the command line after `run`
  explicit RanRobot(std::vector<std::string> words) {
    words.insert(words.begin(), "run");
    words.insert(words.end(), {"--keep", folder_.path()});
    const auto result = run_finemote(words);
    const std::string end = ".job.json";
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder_.path())) {
      const std::string path = entry.path().string();
      if (path.size() <= end.size() || path.compare(path.size() - end.size(), end.size(), end) != 0) continue;
      auto found = nlohmann::ordered_json::parse(read_file(path));
      if (found.contains("image")) job_ = std::move(found);
    }
    CAPTURE(result.output);
    REQUIRE(job_.contains("image"));
  }

  [[nodiscard]] std::string image() const { return job_.at("image"); }
  [[nodiscard]] const nlohmann::ordered_json& job() const { return job_; }

 private:
  TemporaryFolder folder_;
  nlohmann::ordered_json job_;
};

}  // namespace finemote::test
