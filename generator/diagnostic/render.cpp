#include "generator/diagnostic/render.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "generator/diagnostic/place.hpp"
#include "generator/diagnostic/printable.hpp"
#include "generator/diagnostic/repeats.hpp"

namespace finemote::gen {
namespace {

/// ANSI sequences, or nothing.
struct Palette {
  const char* bold = "";
  const char* red = "";
  const char* yellow = "";
  const char* cyan = "";
  const char* reset = "";
};

constexpr Palette kPlain;
constexpr Palette kColor{"\033[1m", "\033[1;31m", "\033[1;33m", "\033[36m", "\033[0m"};

bool continues_a_letter(char c) { return (static_cast<unsigned char>(c) & 0xC0) == 0x80; }

/// Lines of files, asked for mostly in rising order: each file is walked through once, not once for every finding.
class Lines {
 public:
  std::string_view at(const SourceFile& file, std::uint32_t line) {
    if (&file != file_ || line < line_) file_ = &file, line_ = 1, offset_ = 0;
    const std::string_view text = file.text;
    for (; line_ < line; ++line_) {
      const std::size_t end = text.find('\n', offset_);
      if (end == std::string_view::npos) return {};
      offset_ = end + 1;
    }
    std::string_view found = text.substr(offset_, text.find('\n', offset_) - offset_);
    if (!found.empty() && found.back() == '\r') found.remove_suffix(1);
    return found;
  }

 private:
  const SourceFile* file_ = nullptr;
  std::uint32_t line_ = 1;
  std::size_t offset_ = 0;
};

/// Of a long line, what stands around a column (from 1), which moves with it.
std::string_view window(std::string_view line, std::size_t& column) {
  constexpr std::size_t kWidest = 200, kBefore = 70, kShown = 150;
  if (line.size() <= kWidest || column > line.size() + 1) return line.substr(0, kWidest);
  std::size_t begin = column > kBefore ? column - 1 - kBefore : 0;
  while (begin > 0 && continues_a_letter(line[begin])) --begin;
  std::size_t end = std::min(begin + kShown, line.size());
  while (end < line.size() && continues_a_letter(line[end])) ++end;
  column -= std::min(column, begin);
  return line.substr(begin, end - begin);
}

/// The source line (of a long one, a part) and a caret line below it; nothing when the place has no line.
std::string excerpt(const Diagnostic& finding, Lines& lines, const Palette& paint) {
  Position at = finding.at;
  if (at.file == nullptr || at.line == 0) return {};
  std::size_t column = at.column;
  const std::string line = printable(window(lines.at(*at.file, at.line), column));
  at.column = static_cast<std::uint32_t>(column);
  if (line.empty()) return {};

  const std::string margin = fmt::format("{:>5} | ", at.line);
  std::string text = margin + line + "\n";
  if (at.column == 0 || at.column > line.size() + 1) return text;

  std::string blanks(margin.size() - 2, ' ');
  blanks += "| ";
  for (std::size_t i = 0; i + 1 < at.column; ++i) {
    if (!continues_a_letter(line[i])) blanks += line[i] == '\t' ? '\t' : ' ';
  }
  const std::string marked = line.substr(std::min<std::size_t>(line.size(), at.column - 1), finding.length);
  const auto letters = static_cast<std::size_t>(
      std::count_if(marked.begin(), marked.end(), [](char c) { return !continues_a_letter(c); }));
  const std::size_t tail = std::max<std::size_t>(letters, 1) - 1;
  return text + blanks + paint.red + "^" + std::string(tail, '~') + paint.reset + "\n";
}

std::string describe(const Expansion& step) {
  const char* verb = step.kind == Expansion::Kind::macro ? "expanded from macro" : "included as";
  return fmt::format("{} '{}' at {}", verb, step.name, place_text(step.at));
}

/// The steps from the text outwards; of a deep recursion only the innermost ones and the outermost one.
std::string render_way(const Expansion* innermost, const Palette& paint) {
  constexpr std::size_t most = 12;
  std::vector<const Expansion*> steps;
  for (const Expansion* step = innermost; step != nullptr; step = step->at.via) steps.push_back(step);
  std::string text;
  for (std::size_t i = 0; i < steps.size(); ++i) {
    const bool is_shown = steps.size() <= most || i + 2 < most || i + 1 == steps.size();
    if (is_shown) text += fmt::format("  {}note:{} {}\n", paint.cyan, paint.reset, printable(describe(*steps[i])));
    if (!is_shown && i + 2 == most) {
      text += fmt::format("  {}note:{} {} more steps\n", paint.cyan, paint.reset, steps.size() - most + 1);
    }
  }
  return text;
}

const char* color_of(Severity severity, const Palette& paint) {
  switch (severity) {
    case Severity::error:
      return paint.red;
    case Severity::warning:
      return paint.yellow;
    case Severity::note:
      break;
  }
  return paint.cyan;
}

std::string render_one(const Message& message, Lines& lines, const Palette& paint) {
  const Diagnostic& finding = message.finding;
  std::string text = fmt::format("{}{}:{} {}{}[{}]{}: {}\n", paint.bold, printable(place_text(finding.at)), paint.reset,
                                 color_of(finding.severity, paint), severity_name(finding.severity),
                                 code_name(finding.code), paint.reset, printable_lines(finding.message));
  text += excerpt(finding, lines, paint);
  text += render_way(finding.at.via, paint);
  if (!message.repeats.empty())
    text += fmt::format("  {}note:{} {}\n", paint.cyan, paint.reset, printable(repeats_text(message)));
  for (const Note& note : finding.notes) {
    const std::string where = note.at.file ? fmt::format(" ({})", place_text(note.at)) : "";
    text += fmt::format("  {}note:{} {}{}\n", paint.cyan, paint.reset, printable_lines(note.message), printable(where));
  }
  for (const std::string& hint : finding.hints) {
    text += fmt::format("  {}hint:{} {}\n", paint.cyan, paint.reset, printable_lines(hint));
  }
  return text;
}

}  // namespace

const char* severity_name(Severity severity) {
  switch (severity) {
    case Severity::error:
      return "error";
    case Severity::warning:
      return "warning";
    case Severity::note:
      break;
  }
  return "note";
}

std::string code_name(Code code) { return fmt::format("FM{:04}", code.number); }

std::string render_text(const Diagnostics& diagnostics, bool color) {
  std::string text;
  Lines lines;
  for (const Message& message : messages_of(diagnostics)) text += render_one(message, lines, color ? kColor : kPlain);
  return text;
}

namespace {

using Json = nlohmann::ordered_json;

void put_place(const Position& at, Json& json) {
  json["file"] = at.file ? Json(at.file->name) : Json(nullptr);
  json["line"] = at.line > 0 ? Json(at.line) : Json(nullptr);
  json["column"] = at.column > 0 ? Json(at.column) : Json(nullptr);
}

Json json_of(const Message& message) {
  const Diagnostic& finding = message.finding;
  Json json{
      {"severity", severity_name(finding.severity)}, {"code", code_name(finding.code)}, {"message", finding.message}};
  put_place(finding.at, json);
  Json notes = Json::array();
  for (const Expansion* step = finding.at.via; step != nullptr; step = step->at.via) notes.push_back(describe(*step));
  for (const Note& note : finding.notes) notes.push_back(note.message);
  json["notes"] = std::move(notes);
  json["hints"] = finding.hints;
  for (const Diagnostic& repeat : message.repeats) {
    Json other{{"message", repeat.message}};
    put_place(outermost(repeat.at), other);
    json["repeats"].push_back(std::move(other));
  }
  return json;
}

}  // namespace

nlohmann::ordered_json render_json(const Diagnostics& diagnostics) {
  Json list = Json::array();
  for (const Message& message : messages_of(diagnostics)) list.push_back(json_of(message));
  return list;
}

}  // namespace finemote::gen
