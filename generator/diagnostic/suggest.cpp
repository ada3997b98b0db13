#include "generator/diagnostic/suggest.hpp"

#include <algorithm>
#include <cctype>

#include "generator/diagnostic/diagnostics.hpp"

namespace finemote::gen {
namespace {

constexpr std::size_t kStep = 2;  // cost of one edit; a change of letter case costs half

char lower(char c) { return static_cast<char>(std::tolower(static_cast<unsigned char>(c))); }

std::string in_lower_case(std::string_view text) {
  std::string lowered(text);
  std::transform(lowered.begin(), lowered.end(), lowered.begin(), lower);
  return lowered;
}

bool is_letter(char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0; }

/// Of a token in lower case: whether the word begins with it.
bool starts_with_token(std::string_view word, std::string_view token) {
  return in_lower_case(word.substr(0, token.size())) == token;
}

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

/// `m3508` for `dji_m3508`, `radius` for `wheel_radius`: one word holds the other.
bool holds(std::string_view a, std::string_view b) {
  constexpr std::size_t kShortest = 3;
  const std::string small = in_lower_case(a.size() < b.size() ? a : b);
  return small.size() >= kShortest && in_lower_case(a.size() < b.size() ? b : a).find(small) != std::string::npos;
}

/// `dm4310` -> `dm`, `4310`; `h30_imu` -> `30`, `imu`: runs of letters or of digits, of at least two, in lower case.
std::vector<std::string> tokens(std::string_view word) {
  std::vector<std::string> found;
  const auto kind = [](char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0 ? 1 : is_letter(c) ? 2 : 0; };
  for (std::size_t begin = 0, end = 0; begin < word.size(); begin = end) {
    while (end < word.size() && kind(word[end]) == kind(word[begin])) ++end;
    if (kind(word[begin]) != 0 && end - begin >= 2) found.push_back(in_lower_case(word.substr(begin, end - begin)));
  }
  return found;
}

/// `rm_imu` for `h30_imu`, `dm4310` for `dm_motor`: a part of one is a part of the other. The names of families are
/// short: two letters count where both words begin with them.
bool share_token(std::string_view a, std::string_view b) {
  constexpr std::size_t kShortest = 3;
  const auto mine = tokens(a), theirs = tokens(b);
  if (!mine.empty() && !theirs.empty() && mine.front() == theirs.front() && starts_with_token(a, mine.front()) &&
      starts_with_token(b, mine.front()))
    return true;
  return std::any_of(mine.begin(), mine.end(), [&](const std::string& token) {
    return token.size() >= kShortest && std::find(theirs.begin(), theirs.end(), token) != theirs.end();
  });
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
  std::vector<std::pair<std::size_t, std::string>> mistyped, related;
  for (const std::string& candidate : candidates) {
    const std::size_t steps = distance(word, candidate);
    if (steps <= allowed && steps < kStep * candidate.size())
      mistyped.emplace_back(steps, candidate);
    else if (begins_alike(word, candidate))
      mistyped.emplace_back(allowed, candidate);
    else if (holds(word, candidate))
      related.emplace_back(0, candidate);
    else if (share_token(word, candidate))
      related.emplace_back(1, candidate);
  }
  auto& near = mistyped.empty() ? related : mistyped;
  std::stable_sort(near.begin(), near.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<std::string> names;
  for (auto& [steps, name] : near) {
    const bool is_known = std::find(names.begin(), names.end(), name) != names.end();
    if (names.size() < 3 && !is_known) names.push_back(std::move(name));
  }
  return names;
}

std::vector<std::string> near_hint(std::string_view word, const std::vector<std::string>& candidates) {
  if (nearest_names(word, candidates).empty()) return {};
  return {did_you_mean(word, candidates)};
}

bool is_mistyped(std::string_view word, std::string_view name) {
  if (word == name) return false;
  constexpr std::size_t kLong = 7, kMost = 2;
  if (word.size() > name.size() + kMost || name.size() > word.size() + kMost) return false;
  std::string mine = in_lower_case(word), other = in_lower_case(name);
  if (distance(mine, other) <= kStep * (name.size() >= kLong ? kMost : 1)) return true;
  std::sort(mine.begin(), mine.end());
  std::sort(other.begin(), other.end());
  return mine == other;
}

std::string did_you_mean(std::string_view word, const std::vector<std::string>& candidates) {
  const auto near = nearest_names(word, candidates);
  if (!near.empty()) return "did you mean " + quoted_list(near, " or ") + "?";
  if (candidates.empty()) return {};
  constexpr std::size_t kMost = 12;
  std::vector<std::string> shown(candidates.begin(), candidates.begin() + std::min(candidates.size(), kMost));
  return "valid here: " + quoted_list(shown, ", ") + (candidates.size() > kMost ? ", ..." : "");
}

void suggest(Diagnostic& finding, std::string_view word, const std::vector<std::string>& candidates) {
  const std::string hint = did_you_mean(word, candidates);
  if (!hint.empty()) finding.hint(hint);
}

}  // namespace finemote::gen
