#include "generator/diagnostic/catalogue.hpp"

#include <algorithm>
#include <charconv>
#include <filesystem>

#include "generator/file/installed_file.hpp"

namespace finemote::gen {
namespace fs = std::filesystem;

std::string title_of(const std::string& page) {
  const std::string first = page.substr(0, page.find('\n'));
  const std::size_t colon = first.find(": ");
  return colon == std::string::npos ? std::string() : first.substr(colon + 2);
}

std::optional<Code> parse_code(std::string_view text) {
  const bool has_prefix = text.size() > 2 && (text[0] == 'F' || text[0] == 'f') && (text[1] == 'M' || text[1] == 'm');
  if (has_prefix) text.remove_prefix(2);
  constexpr std::size_t kLongest = 4;
  Code code;
  const auto [end, problem] = std::from_chars(text.data(), text.data() + text.size(), code.number);
  if (problem != std::errc() || end != text.data() + text.size() || text.size() > kLongest) return {};
  return code;
}

std::vector<CatalogueEntry> list_catalogue(const std::string& folder) {
  std::vector<CatalogueEntry> entries;
  std::error_code problem;
  for (fs::directory_iterator entry(folder, problem), end; !problem && entry != end; entry.increment(problem)) {
    const auto code = entry->path().extension() == ".md" ? parse_code(entry->path().stem().string()) : std::nullopt;
    if (!code) continue;
    entries.push_back({*code, title_of(read_installed(entry->path().string()))});
  }
  std::sort(entries.begin(), entries.end(),
            [](const CatalogueEntry& a, const CatalogueEntry& b) { return a.code.number < b.code.number; });
  return entries;
}

}  // namespace finemote::gen
