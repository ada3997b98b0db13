#include "generator/document/markdown.hpp"

#include <cctype>

#include "generator/units/units.hpp"

namespace finemote::gen {
namespace {

constexpr const char* kBegin = "<!-- made by ./dev docs: begin -->\n";
constexpr const char* kEnd = "<!-- made by ./dev docs: end -->\n";

}  // namespace

std::string row(const std::vector<std::string>& cells) {
  std::string text = "|";
  for (const std::string& cell : cells) text += (cell.empty() ? "" : " " + cell) + " |";
  return text + "\n";
}

std::string table(const std::vector<std::string>& titles) {
  std::string rule = "|";
  for (std::size_t i = 0; i < titles.size(); ++i) rule += "---|";
  return row(titles) + rule + "\n";
}

std::string joined(const std::vector<std::string>& words, const std::string& separator, const std::string& none) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : separator) + word;
  return text.empty() ? none : text;
}

std::string time_text(Duration time) { return time == Duration::zero() ? "0 ns" : units::spaced_duration(time); }

std::string sentence(std::string text) {
  if (!text.empty()) text[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(text[0])));
  return text + ".";
}

std::string as_made(const std::string& made) { return kBegin + made + kEnd; }

bool has_made_part(const std::string& page) {
  const std::size_t begin = page.find(kBegin);
  return begin != std::string::npos && page.find(kEnd, begin) != std::string::npos;
}

std::string with_made_part(const std::optional<std::string>& page, const std::string& title, const std::string& made) {
  const std::string part = as_made(made);
  if (!page || !has_made_part(*page)) return title + "\n\n" + part;
  const std::size_t begin = page->find(kBegin);
  return page->substr(0, begin) + part + page->substr(page->find(kEnd, begin) + std::string(kEnd).size());
}

}  // namespace finemote::gen
