#include "generator/descriptor/json_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "generator/json/parse.hpp"

namespace finemote::gen {
namespace {

/// Walks over a text that is known to be JSON.
class Scanner {
 public:
  explicit Scanner(std::string_view text) : text_(text) { skip_blanks(); }

  [[nodiscard]] std::size_t offset() const { return at_; }
  [[nodiscard]] char peek() const { return at_ < text_.size() ? text_[at_] : '\0'; }

  void skip_blanks() {
    while (at_ < text_.size() && (text_[at_] == ' ' || text_[at_] == '\t' || text_[at_] == '\n' || text_[at_] == '\r'))
      ++at_;
  }
  void take(char c) {
    if (peek() == c) ++at_;
    skip_blanks();
  }
  /// Reads a string; returns it decoded.
  std::string take_string() {
    const std::size_t begin = at_;
    skip_string();
    const std::string_view raw = text_.substr(begin, at_ - begin);
    skip_blanks();
    if (raw.size() >= 2 && raw.find('\\') == std::string_view::npos) return std::string(raw.substr(1, raw.size() - 2));
    const Json decoded = Json::parse(raw, nullptr, false);
    return decoded.is_string() ? decoded.get<std::string>() : std::string();
  }
  /// Goes past the value that begins here, without recursion.
  void skip_value() {
    std::size_t depth = 0;
    do {
      const char c = peek();
      if (c == '"') {
        skip_string();
      } else {
        if (c == '{' || c == '[') ++depth;
        if (c == '}' || c == ']') --depth;
        ++at_;
        if (depth == 0 && c != '}' && c != ']') skip_scalar();
      }
    } while (depth > 0 && at_ < text_.size());
    skip_blanks();
  }

 private:
  void skip_string() {
    for (++at_; at_ < text_.size() && text_[at_] != '"'; ++at_) {
      if (text_[at_] == '\\') ++at_;
    }
    at_ = std::min(at_ + 1, text_.size());
  }
  void skip_scalar() {
    while (at_ < text_.size() && std::string_view(",]} \t\r\n").find(text_[at_]) == std::string_view::npos) ++at_;
  }

  std::string_view text_;
  std::size_t at_ = 0;
};

/// Offsets of a member: its key (the value where it has none) and its value.
struct Member {
  std::size_t key = 0;
  std::size_t value = 0;
};

/// The member `token` of the object or array that begins at the scanner; the scanner is left at its value.
std::optional<Member> enter(Scanner& scan, const std::string& token) {
  const bool is_object = scan.peek() == '{';
  if (!is_object && scan.peek() != '[') return {};
  const char close = is_object ? '}' : ']';
  scan.take(scan.peek());
  for (std::size_t index = 0; scan.peek() != close && scan.peek() != '\0'; ++index) {
    const std::size_t key_offset = scan.offset();
    std::string key = std::to_string(index);
    if (is_object) {
      key = scan.take_string();
      scan.take(':');
    }
    if (key == token) return Member{key_offset, scan.offset()};
    scan.skip_value();
    scan.take(',');
  }
  return {};
}

std::size_t value_end(std::string_view text, std::size_t offset) {
  const std::string_view rest = text.substr(offset);
  if (rest.empty() || rest.front() != '"') return offset + std::min(rest.find_first_of(",]} \t\r\n"), rest.size());
  std::size_t end = 1;
  while (end < rest.size() && rest[end] != '"') end += rest[end] == '\\' ? 2 : 1;
  return offset + std::min(end + 1, rest.size());
}

/// A number that nlohmann cannot hold: it is quoted in what it says.
void report_number(const SourceFile& source, std::string_view words, Diagnostics& diagnostics) {
  const std::size_t begin = words.find('\'') + 1;
  const std::string_view number = words.substr(begin, words.rfind('\'') - begin);
  const std::size_t offset = std::min(source.text.find(number), source.text.size());
  diagnostics.error(code::descriptor_malformed, position_at(source, offset), "the number is too large")
      .underline(number.size());
}

/// Notes what nlohmann takes and a descriptor may not have: a key twice in one object, endless nesting, numbers beyond
/// 63 bits and texts without end, which the schema's patterns cannot be held against.
class ShapeCheck {
 public:
  ShapeCheck(const SourceFile& source, Diagnostics& diagnostics) : source_(source), diagnostics_(diagnostics) {}

  void run() {
    Scanner scan(source_.text);
    std::vector<std::set<std::string>> objects;  // keys of the objects around; arrays have an empty set
    std::string open;                            // their brackets
    while (scan.peek() != '\0') {
      const char c = scan.peek();
      if (c == '{' || c == '[') {
        if (open.size() == static_cast<std::size_t>(json::kMaxDepth))
          return report(scan.offset(), fmt::format("arrays and objects are nested deeper than {}", json::kMaxDepth));
        open += c;
        objects.emplace_back();
        scan.take(c);
        expect_key_ = c == '{';
      } else if (c == '}' || c == ']') {
        open.pop_back();
        objects.pop_back();
        scan.take(c);
        expect_key_ = false;
      } else if (c == ',') {
        scan.take(c);
        expect_key_ = !open.empty() && open.back() == '{';
      } else if (expect_key_ && c == '"') {
        take_key(scan, objects.back());
      } else {
        take_scalar(scan);
      }
    }
  }
  [[nodiscard]] bool found() const { return found_; }

 private:
  void take_key(Scanner& scan, std::set<std::string>& keys) {
    const std::size_t offset = scan.offset();
    const std::string key = scan.take_string();
    scan.take(':');
    expect_key_ = false;
    if (keys.insert(key).second) return;
    found_ = true;
    diagnostics_
        .error(code::descriptor_contradiction, position_at(source_, offset), fmt::format("'{}' is given twice", key))
        .underline(key.size() + 2);
  }

  void take_scalar(Scanner& scan) {
    constexpr std::size_t kLongest = 4096;
    const std::size_t offset = scan.offset();
    scan.skip_value();
    constexpr std::size_t kSafeDigits = 18;  // of a whole number that surely fits
    if (scan.offset() - offset <= kSafeDigits) return;
    const std::string_view token =
        std::string_view(source_.text).substr(offset, value_end(source_.text, offset) - offset);
    if (token.size() > kLongest) return report(offset, fmt::format("a text has at most {} bytes", kLongest));
    if (token.front() == '"') return;
    const Json value = Json::parse(token);
    const bool is_large = value.is_number_unsigned() && value.get<std::uint64_t>() > std::uint64_t{INT64_MAX};
    if (is_large) report(offset, "the number is too large");
  }
  void report(std::size_t offset, std::string message) {
    found_ = true;
    diagnostics_.error(code::descriptor_malformed, position_at(source_, offset), std::move(message))
        .underline(
            source_.text[offset] == '[' || source_.text[offset] == '{' ? 1 : value_end(source_.text, offset) - offset);
  }

  const SourceFile& source_;
  Diagnostics& diagnostics_;
  bool expect_key_ = false;
  bool found_ = false;
};

bool holds(const SourceFile& source, const JsonPath& path) {
  Scanner scan(source.text);
  return std::all_of(path.begin(), path.end(), [&](const std::string& token) { return enter(scan, token); });
}

/// The first text that leads as far along `path` as any does.
const SourceFile& nearest_layer(const Origin& origin, JsonPath path) {
  for (;; path.pop_back()) {
    for (const SourceFile* layer : origin.layers()) {
      if (holds(*layer, path)) return *layer;  // every text holds the empty path
    }
  }
}

/// nlohmann reads no further, and says so in the words of its parser: ours say it again, at the same place or nearer.
void report_malformed(const SourceFile& source, std::size_t byte, Diagnostics& diagnostics) {
  Diagnostics findings;
  json::parse(source, findings);
  for (const Diagnostic& finding : findings.in_file_order()) {
    if (finding.code != code::json_malformed) continue;
    diagnostics.error(code::descriptor_malformed, finding.at, "this is not JSON: " + finding.message);
    return;
  }
  const std::size_t offset = byte > 0 ? byte - 1 : 0;
  diagnostics.error(code::descriptor_malformed, position_at(source, std::min(offset, source.text.size())),
                    "this is not JSON");
}

}  // namespace

Position position_at(const SourceFile& source, std::size_t offset) {
  const std::string_view before = std::string_view(source.text).substr(0, offset);
  const auto line = static_cast<std::uint32_t>(std::count(before.begin(), before.end(), '\n')) + 1;
  const std::size_t begin = before.rfind('\n');
  const std::size_t column = begin == std::string_view::npos ? before.size() : before.size() - begin - 1;
  return {&source, line, static_cast<std::uint32_t>(column) + 1, nullptr};
}

std::optional<JsonFile> parse_json(const SourceFile& source, Diagnostics& diagnostics) {
  JsonFile file{source, {}};
  try {
    file.value = Json::parse(source.text);
  } catch (const Json::parse_error& problem) {
    report_malformed(source, problem.byte, diagnostics);
    return {};
  } catch (const Json::out_of_range& problem) {
    report_number(source, problem.what(), diagnostics);
    return {};
  }
  ShapeCheck shape(source, diagnostics);
  shape.run();
  if (shape.found()) return {};
  return file;
}

std::optional<std::string> peek_text(std::string_view text, const char* key) {
  Scanner scan(text);
  if (!enter(scan, key) || scan.peek() != '"') return {};
  return scan.take_string();
}

bool holds_value(const Origin& origin, const JsonPath& path) {
  return std::any_of(origin.layers().begin(), origin.layers().end(),
                     [&](const SourceFile* layer) { return holds(*layer, path); });
}

Extent find_value(const Origin& origin, const JsonPath& path) {
  const SourceFile& source = nearest_layer(origin, path);
  Scanner scan(source.text);
  Member found{scan.offset(), scan.offset()};
  for (const std::string& token : path) {
    const auto member = enter(scan, token);
    if (!member) break;
    found = *member;
  }
  const char first = found.value < source.text.size() ? source.text[found.value] : '\0';
  const bool is_container = first == '{' || first == '[';
  const std::size_t begin = is_container ? found.key : found.value;
  const bool is_bare_container = is_container && begin == found.value;
  return {position_at(source, begin), is_bare_container ? 1 : value_end(source.text, begin) - begin};
}

}  // namespace finemote::gen
