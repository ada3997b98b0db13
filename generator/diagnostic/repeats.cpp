#include "generator/diagnostic/repeats.hpp"

#include <fmt/format.h>

#include <cctype>
#include <map>
#include <tuple>

#include "generator/diagnostic/place.hpp"

namespace finemote::gen {
namespace {

/// The words of a message, without what stands in quotes and without numbers.
std::string words_of(const std::string& message) {
  std::string words;
  bool is_quoted = false;
  for (const char c : message) {
    if (c == '\'') is_quoted = !is_quoted;
    if (!is_quoted && std::isdigit(static_cast<unsigned char>(c)) == 0) words += c;
  }
  return words;
}

/// What repeats have in common; `turn` tells findings of one expansion apart.
using Key = std::tuple<std::uint16_t, Severity, const SourceFile*, std::uint32_t, std::uint32_t, std::string, int>;

Key key_of(const Diagnostic& finding) {
  const Position& at = finding.at;
  return {finding.code.number, finding.severity, at.file, at.line, at.column, words_of(finding.message), 0};
}

}  // namespace

std::vector<Message> messages_of(const Diagnostics& diagnostics) {
  std::vector<Message> messages;
  std::map<Key, std::size_t> message_of;
  std::map<std::pair<Key, const Expansion*>, int> turns;
  for (const Diagnostic& finding : diagnostics.in_file_order()) {
    if (finding.at.via != nullptr) {
      Key key = key_of(finding);
      std::get<int>(key) = turns[{key, finding.at.via}]++;
      const auto [message, is_new] = message_of.emplace(std::move(key), messages.size());
      if (!is_new) {
        messages[message->second].repeats.push_back(finding);
        continue;
      }
    }
    messages.push_back({finding, {}});
  }
  return messages;
}

std::vector<RepeatPlace> repeat_places(const Message& message) {
  std::vector<RepeatPlace> places;
  for (const Diagnostic& repeat : message.repeats) {
    const Position at = outermost(repeat.at);
    const bool is_last = !places.empty() && places.back().at.file == at.file && places.back().at.line == at.line &&
                         places.back().at.column == at.column;
    if (!is_last) places.push_back({at, 0});
    ++places.back().count;
  }
  return places;
}

std::string repeats_text(const Message& message) {
  constexpr std::size_t kMost = 12;
  const std::size_t count = message.repeats.size();
  if (count == 0) return {};
  const auto places = repeat_places(message);
  std::string text;
  for (std::size_t i = 0; i < places.size() && i < kMost; ++i) {
    text += (i == 0 ? "" : ", ") + place_text(places[i].at);
    if (places[i].count > 1) text += fmt::format(" ({} times)", places[i].count);
  }
  if (places.size() > kMost) text += fmt::format(" and {} more places", places.size() - kMost);
  return fmt::format("the same for {} more expansion{}, at {}", count, count == 1 ? "" : "s", text);
}

}  // namespace finemote::gen
