#include "tests/structure/definitions.hpp"

#include <algorithm>
#include <cctype>
#include <initializer_list>
#include <stdexcept>

#include "tests/structure/tokens.hpp"

namespace finemote::test {
namespace {

/// What was read of a declaration; a group in brackets is one token: `()`, `[]` or `{}`, and `<>` after `template`.
using Head = std::vector<Token>;

bool is_one_of(std::string_view text, std::initializer_list<std::string_view> words) {
  return std::find(words.begin(), words.end(), text) != words.end();
}

bool is_word(std::string_view text) { return std::isalpha(static_cast<unsigned char>(text[0])) != 0 || text[0] == '_'; }

bool is_macro(std::string_view text) {
  return is_word(text) && std::none_of(text.begin(), text.end(), [](unsigned char c) { return std::islower(c) != 0; });
}

std::string text_at(const Head& head, std::size_t at) { return at < head.size() ? head[at].text : std::string(); }

bool begins_with(const Head& head, std::string_view word) { return !head.empty() && head[0].text == word; }

/// After the template arguments that begin at `at`; `at` where none do.
std::size_t behind_angles(const Head& head, std::size_t at) {
  if (text_at(head, at) != "<") return at;
  int depth = 0;
  for (; at < head.size(); ++at) {
    if (head[at].text == "<") ++depth;
    if (head[at].text == ">" && --depth == 0) return at + 1;
  }
  return at;
}

std::size_t before_angles(const Head& head, std::size_t end) {
  if (end == 0 || head[end - 1].text != ">") return end;
  int depth = 0;
  for (; end > 0; --end) {
    if (head[end - 1].text == ">") ++depth;
    if (head[end - 1].text == "<" && --depth == 0) return end - 1;
  }
  return end;
}

/// Where `=` gives a variable its value; the size of the head where none does.
std::size_t find_assignment(const Head& head) {
  for (std::size_t i = 0; i < head.size(); ++i) {
    if (head[i].text == "operator") {
      while (i + 1 < head.size() && head[i + 1].text != "()") ++i;
    } else if (head[i].text == "=") {
      return i;
    }
  }
  return head.size();
}

bool is_namespace(const Head& head) {
  return begins_with(head, "namespace") || (begins_with(head, "inline") && text_at(head, 1) == "namespace") ||
         (head.size() == 2 && begins_with(head, "extern") && head[1].text == "\"\"");
}

std::string joined(const Head& head, std::size_t begin, std::size_t end) {
  std::string text;
  for (std::size_t i = begin; i < end; ++i) {
    if (i > begin && is_word(head[i - 1].text) && is_word(head[i].text)) text += ' ';
    text += head[i].text;
  }
  return text;
}

/// The name of the class that the head defines: `Lexer`, `Outer::Inner`, `Trait<int>`.
struct ClassHead {
  bool is_class = false;
  std::string name;
};

ClassHead read_class_head(const Head& head) {
  std::size_t at = 0;
  while (at < head.size() && !is_one_of(head[at].text, {"class", "struct", "union", "enum"})) ++at;
  if (at == head.size() || head[at].text == "enum") return {};
  ++at;
  while (is_one_of(text_at(head, at), {"[]", "alignas", "__attribute__", "()"})) ++at;
  const std::size_t begin = at;
  while (at < head.size() && (is_word(head[at].text) || head[at].text == "::")) {
    if (head[at].text == "final" || (at > begin && is_word(head[at - 1].text) && is_word(head[at].text))) break;
    at = behind_angles(head, at + 1);
  }
  const bool is_class = at == head.size() || is_one_of(head[at].text, {"final", ":"});
  return {is_class, joined(head, begin, at)};
}

/// Whether the head from `at` on is what may stand between the parameters of a function and its body.
bool is_function_tail(const Head& head, std::size_t at) {
  for (; at < head.size(); ++at) {
    const std::string& text = head[at].text;
    if (is_one_of(text, {"->", "requires"})) return true;
    // Of `: a_{1}, b_(2) {`, the brace after a name is one more member's value.
    if (text == ":") return is_one_of(head.back().text, {"()", "{}", "."});
    if (is_one_of(text, {"noexcept", "__attribute__"}) || is_macro(text)) {
      if (text_at(head, at + 1) == "()") ++at;
    } else if (!is_one_of(text, {"const", "volatile", "override", "final", "mutable", "constexpr", "&", "[]", "try"})) {
      return false;
    }
  }
  return true;
}

bool may_hold_parameters(const Head& head, std::size_t at) {
  if (at == 0 || head[at].text != "()") return false;
  const std::string& before = head[at - 1].text;
  if (before == ">" || (at >= 2 && head[at - 2].text == "operator")) return true;
  if (is_word(before)) {
    return !is_one_of(before, {"operator", "alignas", "decltype", "noexcept", "requires", "__attribute__", "explicit"});
  }
  return at >= 3 && head[at - 3].text == "operator";  // `operator==()`
}

/// Where the parameters of the function stand whose body follows; the size of the head where none does.
std::size_t find_parameters(const Head& head) {
  for (std::size_t i = 0; i < head.size(); ++i) {
    if (may_hold_parameters(head, i) && is_function_tail(head, i + 1)) return i;
  }
  return head.size();
}

std::string function_name(const Head& head, std::size_t parameters) {
  const auto end = head.begin() + static_cast<std::ptrdiff_t>(parameters);
  const auto sign = std::find_if(head.begin(), end, [](const Token& token) { return token.text == "operator"; });
  std::size_t begin = sign != end ? static_cast<std::size_t>(sign - head.begin()) : before_angles(head, parameters) - 1;
  if (begin > 0 && head[begin - 1].text == "~") --begin;
  while (begin >= 2 && head[begin - 1].text == "::" && (is_word(head[begin - 2].text) || head[begin - 2].text == ">")) {
    begin = before_angles(head, begin - 1) - 1;
  }
  return joined(head, begin, parameters);
}

std::string variable_name(const Head& head) {
  std::size_t end = find_assignment(head);
  while (end > 0 && !is_word(head[end - 1].text)) --end;
  return end > 0 ? head[end - 1].text : std::string();
}

/// Where the lambda begins whose body follows; the size of the head where none does.
std::size_t find_lambda(const Head& head) {
  for (std::size_t at = head.size(); at-- > 0;) {
    if (head[at].text != "[]") continue;
    if (at > 0 && (is_one_of(head[at - 1].text, {"()", "[]"}) || is_word(head[at - 1].text)) &&
        head[at - 1].text != "return") {
      continue;
    }
    std::size_t tail = behind_angles(head, at + 1);
    if (text_at(head, tail) == "()") ++tail;
    return is_function_tail(head, tail) ? at : head.size();
  }
  return head.size();
}

class Reader {
 public:
  explicit Reader(std::string_view text) : tokens_(tokens_of(text)) {}

  std::vector<Definition> run() {
    read_scope("");
    if (at_ < tokens_.size()) fail(tokens_[at_]);
    return std::move(definitions_);
  }

 private:
  [[noreturn]] static void fail(const Token& token) {
    throw std::runtime_error("line " + std::to_string(token.line) + ": '" + token.text + "' has no match");
  }

  [[nodiscard]] bool sees(std::string_view text) const { return at_ < tokens_.size() && tokens_[at_].text == text; }

  /// Declarations up to the brace that closes them, or to the end of the file.
  void read_scope(const std::string& enclosing) {
    Head head;
    while (at_ < tokens_.size() && !sees("}")) {
      const std::string text = tokens_[at_].text;
      if (text == ";") {
        end_declaration(head);
        ++at_;
      } else if (text == "{") {
        open_brace(head, enclosing);
      } else if (text == "(" || text == "[") {
        read_group(head, enclosing + variable_name(head));
      } else if (text == ":" && head.size() == 1 && is_one_of(head[0].text, {"public", "protected", "private"})) {
        head.clear();
        ++at_;
      } else {
        head.push_back(tokens_[at_++]);
        if (text == "template" && sees("<")) skip_angles(head);
      }
    }
  }

  void open_brace(Head& head, const std::string& enclosing) {
    const ClassHead type = read_class_head(head);
    if (is_namespace(head)) {
      read_block(enclosing);
    } else if (type.is_class) {
      const int first = head.front().line;
      end_declaration(head);
      read_block(enclosing + type.name + "::");
      record(DefinitionKind::type, enclosing + type.name, first);
    } else if (find_assignment(head) == head.size() && find_parameters(head) < head.size()) {
      const int first = head.front().line;
      skip_body();
      lambdas_.clear();  // those of its arguments and members are part of it
      record(DefinitionKind::function, enclosing + function_name(head, find_parameters(head)), first);
    } else {
      return read_braces(head, enclosing + variable_name(head));
    }
    end_declaration(head);
  }

  void end_declaration(Head& head) {
    definitions_.insert(definitions_.end(), lambdas_.begin(), lambdas_.end());
    lambdas_.clear();
    head.clear();
  }

  void read_block(const std::string& enclosing) {
    const Token open = tokens_[at_++];
    read_scope(enclosing);
    if (!sees("}")) fail(open);
    ++at_;
  }

  /// Braces in an expression: the body of a lambda, or values.
  void read_braces(Head& head, const std::string& variable) {
    const std::size_t lambda = find_lambda(head);
    if (lambda == head.size()) return read_group(head, variable);
    const int first = head[lambda].line;
    skip_body();
    lambdas_.push_back({DefinitionKind::function, variable, first, tokens_[at_ - 1].line});
    head.push_back({"{}", first});
  }

  /// A group in brackets, whose lambdas are functions, to one token at the end of the head.
  void read_group(Head& head, const std::string& variable) {
    const Token open = tokens_[at_++];
    const std::string close = open.text == "(" ? ")" : open.text == "[" ? "]" : "}";
    Head inner;
    while (!sees(close)) {
      if (at_ == tokens_.size() || is_one_of(tokens_[at_].text, {")", "]", "}"})) fail(open);
      if (sees("{")) {
        read_braces(inner, variable);
      } else if (sees("(") || sees("[")) {
        read_group(inner, variable);
      } else {
        inner.push_back(tokens_[at_++]);
      }
    }
    ++at_;
    head.push_back({open.text + close, open.line});
  }

  void skip_angles(Head& head) {
    const int line = tokens_[at_].line;
    Head inner;
    int depth = 0;
    do {
      if (at_ == tokens_.size()) fail(head.back());
      if (is_one_of(tokens_[at_].text, {"(", "[", "{"})) {
        read_group(inner, "");
        continue;
      }
      if (sees("<")) ++depth;
      if (sees(">")) --depth;
      ++at_;
    } while (depth > 0);
    head.push_back({"<>", line});
  }

  /// A function's body: only its end matters.
  void skip_body() {
    const Token open = tokens_[at_];
    int depth = 0;
    do {
      if (at_ == tokens_.size()) fail(open);
      if (sees("{")) ++depth;
      if (sees("}")) --depth;
      ++at_;
    } while (depth > 0);
  }

  void record(DefinitionKind kind, std::string name, int first_line) {
    definitions_.push_back({kind, std::move(name), first_line, tokens_[at_ - 1].line});
  }

  std::vector<Token> tokens_;
  std::size_t at_ = 0;
  std::vector<Definition> definitions_;
  std::vector<Definition> lambdas_;  ///< of the declaration that is being read
};

}  // namespace

std::vector<Definition> definitions_in(std::string_view text) { return Reader(text).run(); }

}  // namespace finemote::test
