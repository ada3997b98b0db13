#include "generator/run/timing_inputs.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>

#include "generator/output/sha256.hpp"
#include "generator/run/process.hpp"

namespace finemote::gen {
namespace {

namespace fs = std::filesystem;

/// Folders of the data that the instructions of an image come from.
constexpr const char* kFolders[] = {"runtime", "cmake"};

std::string text_of(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

/// Without the lines that name what the file was made from.
std::string without_sources(const std::string& text) {
  std::istringstream lines(text);
  std::string kept;
  for (std::string line; std::getline(lines, line);) {
    if (line.rfind("// Source:", 0) != 0) kept += line + "\n";
  }
  return kept;
}

/// Name and digest of every file below a folder, in the order of their names.
void add_folder(const fs::path& folder, std::string& all) {
  std::vector<fs::path> files;
  std::error_code ignored;
  for (auto entry = fs::recursive_directory_iterator(folder, ignored); entry != fs::recursive_directory_iterator();
       entry.increment(ignored)) {
    if (entry->is_regular_file(ignored)) files.push_back(entry->path());
  }
  std::sort(files.begin(), files.end());
  for (const fs::path& file : files)
    all += file.lexically_relative(folder).generic_string() + " " + sha256(text_of(file)) + "\n";
}

}  // namespace

std::string timing_hash(const std::vector<OutputFile>& generated, const FirmwareRequest& request) {
  std::string all = request.board + "\n";
  for (const OutputFile& file : generated) all += file.name + " " + sha256(without_sources(file.text)) + "\n";
  for (const char* folder : kFolders) add_folder(fs::path(request.data_dir) / folder, all);
  for (const std::string& dir : request.include_dirs) add_folder(dir, all);
  return sha256(all);
}

std::string compiler_for_board() {
  const ProcessResult result = run_process({"arm-none-eabi-g++", "--version"}, std::chrono::seconds(10));
  return result.started ? result.output.substr(0, result.output.find('\n')) : std::string();
}

}  // namespace finemote::gen
