#include "generator/json/parse.hpp"

#include <fmt/format.h>

#include <set>

#include "generator/json/scan.hpp"

namespace finemote::gen::json {
namespace {

/// Builds the tree by recursive descent. Every function that returns false has reported why.
class Parser {
 public:
  Parser(const SourceFile& file, Diagnostics& diagnostics) : scan_(file, diagnostics), diagnostics_(diagnostics) {}

  std::optional<Value> document() {
    scan_.skip_blanks();
    Value root;
    if (!value(root, 0)) return std::nullopt;
    scan_.skip_blanks();
    if (!scan_.at_end()) return scan_.fail("unexpected text after the end of the document"), std::nullopt;
    return root;
  }

 private:
  bool value(Value& out, int depth) {
    out.at = scan_.here();
    const std::size_t begin = scan_.offset();
    const bool good = value_body(out, depth);
    const bool nested = out.is(Value::Kind::array) || out.is(Value::Kind::object);
    out.length = nested ? 1 : scan_.offset() - begin;
    return good;
  }

  bool value_body(Value& out, int depth) {
    const char first = scan_.peek();
    if (first == '{') return deeper(depth) && object(out, depth + 1);
    if (first == '[') return deeper(depth) && array(out, depth + 1);
    if (first == 'n') return scan_.word("null");
    if (first == 't' || first == 'f') {
      out.kind = Value::Kind::boolean;
      out.truth = first == 't';
      return scan_.word(out.truth ? "true" : "false");
    }
    if (first == '"') {
      out.kind = Value::Kind::string;
      return scan_.string(out.text);
    }
    if (first == '-' || (first >= '0' && first <= '9')) {
      out.kind = Value::Kind::number;
      return scan_.number(out.text);
    }
    return scan_.fail_expected("a value");
  }

  bool deeper(int depth) {
    return depth < kMaxDepth || scan_.fail(fmt::format("arrays and objects are nested deeper than {}", kMaxDepth));
  }

  /// What stands between brackets, separated by commas: `entry` takes one and returns whether it is good.
  template <typename Entry>
  bool entries(char close, std::string_view expected, Entry entry) {
    scan_.take(scan_.peek());
    scan_.skip_blanks();
    if (scan_.take(close)) return true;
    for (;;) {
      if (!entry()) return false;
      scan_.skip_blanks();
      if (scan_.take(close)) return true;
      if (!scan_.take(',')) return scan_.fail_expected(expected);
      scan_.skip_blanks();
    }
  }

  bool array(Value& out, int depth) {
    out.kind = Value::Kind::array;
    return entries(']', "',' or ']'", [&] { return value(out.items.emplace_back(), depth); });
  }

  bool object(Value& out, int depth) {
    out.kind = Value::Kind::object;
    std::set<std::string> keys;
    return entries('}', "',' or '}'", [&] { return member(out, keys, depth); });
  }

  bool member(Value& out, std::set<std::string>& keys, int depth) {
    Member m;
    m.at = scan_.here();
    if (scan_.peek() != '"') return scan_.fail_expected("a member name");
    const std::size_t begin = scan_.offset();
    if (!scan_.string(m.key)) return false;
    const std::size_t length = scan_.offset() - begin;
    scan_.skip_blanks();
    if (!scan_.take(':')) return scan_.fail_expected("':'");
    scan_.skip_blanks();
    if (!value(m.value, depth)) return false;
    if (keys.insert(m.key).second) {
      out.members.push_back(std::move(m));
    } else {
      diagnostics_.error(code::json_repeated_key, m.at, fmt::format("member '{}' is repeated", m.key))
          .underline(length);
    }
    return true;
  }

  Scanner scan_;
  Diagnostics& diagnostics_;
};

}  // namespace

std::string_view describe(Value::Kind kind) {
  switch (kind) {
    case Value::Kind::null:
      return "null";
    case Value::Kind::boolean:
      return "true or false";
    case Value::Kind::number:
      return "a number";
    case Value::Kind::string:
      return "a string";
    case Value::Kind::array:
      return "an array";
    case Value::Kind::object:
      return "an object";
  }
  return "a value";
}

std::optional<Value> parse(const SourceFile& file, Diagnostics& diagnostics) {
  return Parser(file, diagnostics).document();
}

}  // namespace finemote::gen::json
