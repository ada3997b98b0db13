#include "generator/timing_file/directives.hpp"

#include <algorithm>
#include <cctype>
#include <optional>
#include <sstream>
#include <utility>

#include "generator/timing_file/logical_lines.hpp"

namespace finemote::gen {
namespace {

constexpr std::string_view kBlanks = " \t\f\v\r";

void skip_blanks(std::string_view& line) { line.remove_prefix(std::min(line.find_first_not_of(kBlanks), line.size())); }

bool is_of_identifier(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '$' ||
         static_cast<unsigned char>(c) > 127;
}

/// The identifier that `line` begins with, after blanks; empty: none.
std::string_view take_word(std::string_view& line) {
  skip_blanks(line);
  const auto end = std::find_if_not(line.begin(), line.end(), is_of_identifier);
  const std::string_view word = line.substr(0, static_cast<std::size_t>(end - line.begin()));
  line.remove_prefix(word.size());
  return word;
}

/// Takes the name in quotes or brackets that `line` begins with, after blanks.
std::optional<FileName> take_name(std::string_view& line) {
  skip_blanks(line);
  if (line.empty() || (line.front() != '"' && line.front() != '<')) return std::nullopt;
  const bool is_quoted = line.front() == '"';
  const std::size_t end = line.find(is_quoted ? '"' : '>', 1);
  if (end == std::string_view::npos || end == 1) return std::nullopt;
  FileName name{std::string(line.substr(1, end - 1)), is_quoted, false};
  line.remove_prefix(end + 1);
  return name;
}

bool is_blank(std::string_view line) { return line.find_first_not_of(kBlanks) == std::string_view::npos; }

/// What a source has of one logical line after the other.
class DirectiveReader {
 public:
  void read(std::string_view line) {
    skip_blanks(line);
    const std::size_t begin = line.rfind("%:", 0) == 0 ? 2 : 1;
    if (line.empty() || (line.front() != '#' && begin == 1)) return;
    line.remove_prefix(begin);
    const std::string_view word = take_word(line);
    if (word == "define")
      define(line);
    else if (word == "include" || word == "include_next" || word == "import")
      include(line, word == "include_next");
    else if (word == "if" || word == "elif")
      ask(line), found.asks_macro |= calls_macro(line);
  }

  Directives found;

 private:
  void include(std::string_view operand, bool is_next) {
    if (auto name = take_name(operand)) return add(std::move(*name), is_next);
    const std::string_view macro = take_word(operand);
    found.computed.emplace_back(is_blank(operand) ? macro : std::string_view());
  }

  /// Another macro may include what this one says.
  void define(std::string_view line) {
    const std::string macro(take_word(line));
    const bool has_arguments = !line.empty() && line.front() == '(';
    ask(line);
    const auto name = has_arguments ? std::nullopt : take_name(line);
    if (name) found.names.push_back({name->text, true, false});  // the compiler looks beside the line that includes it
    found.macros[macro].insert(name && is_blank(line) ? name->text : std::string());
  }

  /// Which files are there changes the program, too.
  void ask(std::string_view condition) {
    add_quoted(condition);
    constexpr std::string_view kAsks = "__has_include";
    for (std::size_t at = condition.find(kAsks); at != std::string_view::npos; at = condition.find(kAsks, at + 1)) {
      std::string_view rest = condition.substr(at);
      const bool is_next = take_word(rest) == "__has_include_next";
      if (!is_asked_whether_defined(condition.substr(0, at))) ask_for(rest, is_next);
    }
  }

  static bool calls_macro(std::string_view condition) {
    for (std::size_t at = condition.find('('); at != std::string_view::npos; at = condition.find('(', at + 1)) {
      std::string_view before = condition.substr(0, at);
      while (!before.empty() && kBlanks.find(before.back()) != std::string_view::npos) before.remove_suffix(1);
      std::size_t begin = before.size();
      while (begin > 0 && is_of_identifier(before[begin - 1])) --begin;
      const std::string_view word = before.substr(begin);
      if (!word.empty() && word != "defined" && word.rfind("__has_", 0) != 0) return true;
    }
    return false;
  }

  static bool is_asked_whether_defined(std::string_view before) {
    const auto cut = [&](char last) {
      while (!before.empty() && (kBlanks.find(before.back()) != std::string_view::npos || before.back() == last))
        before.remove_suffix(1);
    };
    cut('(');
    constexpr std::string_view kDefined = "defined";
    return before.size() >= kDefined.size() && before.substr(before.size() - kDefined.size()) == kDefined;
  }

  void add(FileName name, bool is_next) {
    name.is_next = is_next;
    found.names.push_back(std::move(name));
  }

  void ask_for(std::string_view operand, bool is_next) {
    skip_blanks(operand);
    if (!operand.empty() && operand.front() == '(') operand.remove_prefix(1);
    if (auto name = take_name(operand))
      add(std::move(*name), is_next);
    else
      found.asks_for_any = true;
  }

  void add_quoted(std::string_view line) {
    for (std::size_t at = line.find('"'); at != std::string_view::npos; at = line.find('"')) {
      line.remove_prefix(at);
      auto name = take_name(line);
      if (!name) return;
      found.names.push_back(std::move(*name));
    }
  }
};

/// Without the quotes between literals that the compiler makes one of.
std::string with_joined_literals(std::string_view text) {
  std::string out;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const std::size_t next = text[i] == '"' ? text.find_first_not_of(" \t\f\v\r\n", i + 1) : std::string_view::npos;
    if (next != std::string_view::npos && text[next] == '"')
      i = next;
    else
      out += text[i];
  }
  return out;
}

/// What stands in quotes, escaped ones of a literal or not, after a directive of the assembler.
void add_assembled(std::string_view text, std::string_view directive, Directives& found) {
  for (std::size_t at = text.find(directive); at != std::string_view::npos; at = text.find(directive, at + 1)) {
    found.is_read_by_assembler = true;
    std::string_view rest = text.substr(at + directive.size());
    skip_blanks(rest);
    if (rest.rfind('\\', 0) == 0) rest.remove_prefix(1);
    if (rest.empty() || rest.front() != '"') continue;
    rest.remove_prefix(1);
    found.names.push_back({std::string(rest.substr(0, rest.find_first_of("\\\"\n"))), true, true});
  }
}

bool has_word(std::string_view text, std::string_view word) {
  for (std::size_t at = text.find(word); at != std::string_view::npos; at = text.find(word, at + 1)) {
    const std::size_t end = at + word.size();
    if ((at == 0 || !is_of_identifier(text[at - 1])) && (end == text.size() || !is_of_identifier(text[end])))
      return true;
  }
  return false;
}

bool has_assembler(std::string_view text) {
  return has_word(text, "asm") || has_word(text, "__asm") || has_word(text, "__asm__");
}

}  // namespace

bool has_pasted_words(std::string_view lines) {
  return lines.find("##") != std::string_view::npos || lines.find("%:%:") != std::string_view::npos;
}

Directives directives_of(std::string_view source) {
  constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
  if (source.rfind(kByteOrderMark, 0) == 0) source.remove_prefix(kByteOrderMark.size());
  const std::string text = logical_lines(source);
  DirectiveReader reader;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) reader.read(line);
  reader.found.has_pasted = has_pasted_words(text);
  const std::string joined = with_joined_literals(text);
  add_assembled(joined, ".incbin", reader.found);
  add_assembled(joined, ".include", reader.found);
  const bool has_part = joined.find("incbin") != std::string::npos || joined.find(".inc") != std::string::npos;
  if (has_part && has_assembler(text)) reader.found.is_read_by_assembler = true;
  return std::move(reader.found);
}

}  // namespace finemote::gen
