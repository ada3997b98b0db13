#include "cli/program.hpp"
#include "read.hpp"
#include "source_dir.hpp"

#include <stdlib.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>

namespace finemote::test {

namespace fs = std::filesystem;

gen::ProcessResult run_finemote(std::vector<std::string> words, const std::vector<std::string>& environment) {
  words.insert(words.begin(), FINEMOTE_PROGRAM);
  return gen::run_process(words, std::chrono::seconds(600), environment);
}

nlohmann::json finemote_json(std::vector<std::string> words) {
  words.insert(words.end(), {"--format", "json"});
  const gen::ProcessResult result = run_finemote(words);
  const auto begin = result.output.find('{');
  if (begin == std::string::npos) throw std::runtime_error("no JSON: " + result.output);
  return nlohmann::json::parse(result.output.substr(begin));
}

std::map<std::string, std::string> files_below(const std::string& folder) {
  std::map<std::string, std::string> files;
  if (!fs::exists(folder)) return files;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    if (entry.is_regular_file())
      files[entry.path().lexically_relative(folder).generic_string()] = read_file(entry.path().string());
  }
  return files;
}

std::string read_file(const std::string& path) { return read(path); }

void write_file(const std::string& path, const std::string& text) {
  fs::create_directories(fs::path(path).parent_path());
  std::ofstream(path, std::ios::binary) << text;
}

std::string source_path(const std::string& name) { return finemote::test::source_dir() + "/" + name; }

std::vector<std::string> example_robots() {
  std::vector<std::string> robots;
  for (const auto& entry : fs::directory_iterator(source_path("examples"))) {
    const std::string name = entry.path().filename().string();
    const auto ends_with = [&](const std::string& tail) {
      return name.size() > tail.size() && name.compare(name.size() - tail.size(), tail.size(), tail) == 0;
    };
    if (ends_with(".urdf") || ends_with(".urdf.xacro")) robots.push_back(name);
  }
  std::sort(robots.begin(), robots.end());
  return robots;
}

}  // namespace finemote::test
