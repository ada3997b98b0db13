#include "generator/scaffold/fill_folder.hpp"

#include <algorithm>
#include <filesystem>
#include <stdexcept>

#include "generator/file/installed_file.hpp"

namespace finemote::gen {
namespace {

namespace fs = std::filesystem;

/// `dot_github/workflows` to `.github/workflows`.
std::string with_dots(const fs::path& name) {
  constexpr std::string_view mark = "dot_";
  fs::path result;
  for (const fs::path& part : name) {
    const std::string text = part.string();
    result /= text.rfind(mark, 0) == 0 ? "." + text.substr(mark.size()) : text;
  }
  return result.generic_string();
}

bool is_key(std::string_view text) {
  const auto fits = [](char c) { return (c >= 'a' && c <= 'z') || c == '_'; };
  return !text.empty() && std::all_of(text.begin(), text.end(), fits);
}

}  // namespace

std::string fill_keys(const std::string& text, const Keys& keys) {
  std::string result;
  std::size_t at = 0;
  while (true) {
    const std::size_t begin = text.find('@', at);
    const std::size_t end = begin == std::string::npos ? begin : text.find('@', begin + 1);
    if (end == std::string::npos) return result + text.substr(at);
    const std::string key = text.substr(begin + 1, end - begin - 1);
    if (!is_key(key)) {
      result += text.substr(at, end - at);
      at = end;
      continue;
    }
    const auto value = keys.find(key);
    if (value == keys.end()) throw std::logic_error("a template of scaffolded files names '" + key + "'");
    result += text.substr(at, begin - at) + value->second;
    at = end + 1;
  }
}

std::vector<OutputFile> fill_folder(const std::string& folder, const Keys& keys) {
  std::vector<OutputFile> files;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    if (!entry.is_regular_file()) continue;
    const std::string name = with_dots(entry.path().lexically_relative(folder));
    files.push_back({fill_keys(name, keys), fill_keys(read_installed(entry.path().generic_string()), keys)});
  }
  std::sort(files.begin(), files.end(), [](const OutputFile& a, const OutputFile& b) { return a.name < b.name; });
  return files;
}

}  // namespace finemote::gen
