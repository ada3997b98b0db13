#include "generator/diagnostic/suggest.hpp"

#include <algorithm>
#include <cctype>

namespace finemote::gen {
namespace {

constexpr std::size_t kStep = 2;  // cost of one edit; a change of letter case costs half

char lower(char c) { return static_cast<char>(std::tolower(static_cast<unsigned char>(c))); }

std::size_t replace_cost(char a, char b) {
  if (a == b) return 0;
  return lower(a) == lower(b) ? kStep / 2 : kStep;
}

/// Optimal string alignment distance in half steps; three rows of the table.
std::size_t distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> before_last(b.size() + 1), last(b.size() + 1), row(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) last[j] = j * kStep;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    row[0] = i * kStep;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      row[j] = std::min({last[j] + kStep, row[j - 1] + kStep, last[j - 1] + replace_cost(a[i - 1], b[j - 1])});
      const bool swapped = i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1];
      if (swapped) row[j] = std::min(row[j], before_last[j - 2] + kStep);
    }
    before_last.swap(last);
    last.swap(row);
  }
  return last[b.size()];
}

/// `baudrate` for `baud`, `addr` for `address`: one word begins with the other; `buadrate`: with one mistake in it.
bool begins_alike(std::string_view a, std::string_view b) {
  constexpr std::size_t kShortest = 3, kShortestMistaken = 4;
  const std::string_view shorter = a.size() < b.size() ? a : b;
  const std::string_view longer = a.size() < b.size() ? b : a;
  const std::string_view begin = longer.substr(0, shorter.size());
  return shorter.size() >= kShortest &&
         (begin == shorter || (shorter.size() >= kShortestMistaken && distance(begin, shorter) <= kStep));
}

std::string quoted_list(const std::vector<std::string>& names, std::string_view last_separator) {
  std::string text;
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (i > 0) text += i + 1 == names.size() ? last_separator : std::string_view(", ");
    text += "'" + names[i] + "'";
  }
  return text;
}

}  // namespace

std::vector<std::string> nearest_names(std::string_view word, const std::vector<std::string>& candidates) {
  constexpr std::size_t kLongest = 100;  // longer words are not typing mistakes of these names
  if (word.size() > kLongest) return {};
  const std::size_t allowed = kStep * std::max<std::size_t>(2, word.size() / 3);
  std::vector<std::pair<std::size_t, std::string>> near;
  for (const std::string& candidate : candidates) {
    std::size_t steps = distance(word, candidate);
    if (steps > allowed && begins_alike(word, candidate)) steps = allowed;
    if (steps <= allowed && steps < kStep * candidate.size()) near.emplace_back(steps, candidate);
  }
  std::stable_sort(near.begin(), near.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<std::string> names;
  for (auto& [steps, name] : near) {
    if (names.size() < 3) names.push_back(std::move(name));
  }
  return names;
}

std::vector<std::string> near_hint(std::string_view word, const std::vector<std::string>& candidates) {
  if (nearest_names(word, candidates).empty()) return {};
  return {did_you_mean(word, candidates)};
}

std::string did_you_mean(std::string_view word, const std::vector<std::string>& candidates) {
  const auto near = nearest_names(word, candidates);
  if (!near.empty()) return "did you mean " + quoted_list(near, " or ") + "?";
  if (candidates.empty()) return {};
  constexpr std::size_t kMost = 12;
  std::vector<std::string> shown(candidates.begin(), candidates.begin() + std::min(candidates.size(), kMost));
  return "valid here: " + quoted_list(shown, ", ") + (candidates.size() > kMost ? ", ..." : "");
}

}  // namespace finemote::gen
