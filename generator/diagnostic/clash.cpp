#include "generator/diagnostic/clash.hpp"

#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <optional>

#include "generator/diagnostic/code_output.hpp"
#include "generator/file/inside.hpp"
#include "generator/file/replace_file.hpp"

namespace finemote::gen {
namespace {

namespace fs = std::filesystem;

std::string identity_of(const struct stat& status) { return fmt::format("{}:{}", status.st_dev, status.st_ino); }

/// What two names of one regular file have in common; none for anything else.
std::optional<std::string> identity_of(int stream) {
  struct stat status {};
  if (::fstat(stream, &status) != 0 || !S_ISREG(status.st_mode)) return std::nullopt;
  return identity_of(status);
}

/// The same of a path. A file that is not there yet is its folder and its name.
std::optional<std::string> identity_of(const std::string& path) {
  struct stat status {};
  if (::stat(path.c_str(), &status) == 0) {
    if (!S_ISREG(status.st_mode)) return std::nullopt;
    return identity_of(status);
  }
  std::error_code failed;
  const fs::path whole = fs::weakly_canonical(fs::absolute(behind_links(path), failed), failed);
  return failed ? std::nullopt : std::optional(whole.generic_string());
}

using Identities = std::map<std::string, std::string>;  ///< of files, to the name that the user knows

Identities inputs_of(const Sources& sources, const std::vector<std::string>& others) {
  Identities inputs;
  const auto add = [&](const std::optional<std::string>& identity, const std::string& name) {
    if (identity) inputs.emplace(*identity, name);
  };
  for (const SourceFile& file : sources.files())
    add(file.path.empty() ? identity_of(STDIN_FILENO) : identity_of(file.path), file.name);
  for (const std::string& path : others) add(identity_of(path), path);
  return inputs;
}

void report_input(const PlannedFile& output, const std::string& input, Sources& sources, Diagnostics& diagnostics) {
  auto& finding =
      diagnostics.error(code::output_is_input, {sources.add({output.path, output.path, {}})},
                        fmt::format("{} would overwrite '{}', which is an input", output.option, output.path));
  if (input != output.path) finding.note(fmt::format("it was read as '{}'", input));
  finding.hint(fmt::format("give {} another name", output.option));
}

void report_twice(const PlannedFile& output, const std::string& other, Sources& sources, Diagnostics& diagnostics) {
  diagnostics
      .error(code::output_twice, {sources.add({output.path, output.path, {}})},
             fmt::format("{} would overwrite '{}', which {} writes as well", output.option, output.path, other))
      .hint(fmt::format("give {} another name", output.option));
}

/// Whether a file lies below a folder, neither of which need be there.
bool is_below(const std::string& path, const std::string& folder) {
  if (folder.empty()) return false;
  std::error_code failed;
  const fs::path whole = fs::weakly_canonical(fs::absolute(behind_links(path), failed), failed);
  const fs::path above = fs::weakly_canonical(fs::absolute(folder, failed), failed);
  return !failed && inside(whole, above);
}

/// Whether the folder of a file is made together with the folder `made`, above which it lies.
bool is_made_with(const std::string& path, const std::string& made) {
  const fs::path folder = behind_links(path).parent_path();
  std::error_code unknown;
  return !folder.empty() && !fs::exists(folder, unknown) && is_below(made, folder.generic_string());
}

void report_unwritable(const PlannedFile& file, const std::string& reason, Diagnostics& diagnostics) {
  const fs::path folder = behind_links(file.path).parent_path();
  std::error_code unknown;
  const bool is_missing = !folder.empty() && fs::status(folder, unknown).type() == fs::file_type::not_found;
  diagnostics.error(code::output_not_writable, {}, fmt::format("cannot write '{}': {}", file.path, reason))
      .hint(is_missing ? fmt::format("make the folder '{}', or name another file with {}", folder.generic_string(),
                                     file.option)
                       : fmt::format("name another file with {}", file.option));
}

}  // namespace

bool check_outputs(const std::vector<PlannedFile>& outputs, Sources& sources, Diagnostics& diagnostics,
                   const std::vector<std::string>& others) {
  const Identities inputs = inputs_of(sources, others);
  Identities written;
  if (const auto identity = identity_of(STDOUT_FILENO)) written.emplace(*identity, "standard output");
  bool is_fine = true;
  for (const PlannedFile& output : outputs) {
    const auto identity = is_special(output.path) ? std::nullopt : identity_of(output.path);
    if (!identity) continue;
    const auto input = inputs.find(*identity);
    const auto [other, is_new] = written.emplace(*identity, output.option);
    if (input != inputs.end()) {
      report_input(output, input->second, sources, diagnostics);
    } else if (!is_new) {
      report_twice(output, other->second, sources, diagnostics);
    }
    is_fine &= input == inputs.end() && is_new;
  }
  return is_fine;
}

bool check_results(std::vector<PlannedFile> results, Sources& sources, Diagnostics& diagnostics,
                   const std::vector<std::string>& others, const std::string& made) {
  results.erase(
      std::remove_if(results.begin(), results.end(), [](const PlannedFile& file) { return file.path.empty(); }),
      results.end());
  bool is_fine = check_outputs(results, sources, diagnostics, others);
  for (const PlannedFile& file : results) {
    const bool comes = is_below(file.path, made) || (!made.empty() && is_made_with(file.path, made));
    const auto reason = comes ? std::nullopt : why_not_replaced(file.path);
    if (reason) report_unwritable(file, *reason, diagnostics);
    is_fine &= !reason;
  }
  return is_fine;
}

}  // namespace finemote::gen
