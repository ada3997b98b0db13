// Runs the built program the way a user would, and looks at what it left behind.
#pragma once

#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "generator/run/process.hpp"
#include "tests/temporary_folder.hpp"

namespace finemote::test {

/// The program with these words, stdout and stderr together; `environment` as NAME=value.
gen::ProcessResult run_finemote(std::vector<std::string> words, const std::vector<std::string>& environment = {});

/// The JSON document it prints on stdout with --format json; fails the test when there is none.
nlohmann::json finemote_json(std::vector<std::string> words);

/// Every regular file below a folder, by its relative name.
std::map<std::string, std::string> files_below(const std::string& folder);

std::string read_file(const std::string& path);
void write_file(const std::string& path, const std::string& text);

/// `name` in the source tree.
std::string source_path(const std::string& name);

/// All robots in examples/ that run as they are.
std::vector<std::string> example_robots();

}  // namespace finemote::test
