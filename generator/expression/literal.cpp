#include "generator/expression/literal.hpp"

#include "generator/expression/number.hpp"

namespace finemote::gen::expression {

Value literal_of(Value value) {
  const std::string* text = value.text();
  if (text == nullptr) return value;
  if (text->size() >= 2 && text->front() == '\'' && text->back() == '\'') return text->substr(1, text->size() - 2);
  if (text->find('_') != std::string::npos) return value;
  const bool may_be_integer = text->size() <= kMaxIntegerDigits;  // longer ones Python refuses to read as int
  const auto i = may_be_integer ? parse_integer(*text) : std::nullopt;
  if (i) return *i;
  if (const auto d = parse_real(*text)) return *d;
  if (*text == "true" || *text == "True") return true;
  if (*text == "false" || *text == "False") return false;
  return value;
}

Value argument_literal(const std::string& text) {
  if (text.find('.') != std::string::npos) {
    if (const auto d = parse_real(text)) return *d;
  } else if (const auto i = parse_integer(text)) {
    return *i;
  }
  std::string lower = text;
  for (char& c : lower) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c;
  if (lower == "true") return true;
  if (lower == "false") return false;
  return text;
}

std::optional<bool> boolean_literal(const Value& value) {
  const std::string* text = value.text();
  if (text == nullptr) return is_true(value);
  if (*text == "true" || *text == "True") return true;
  if (*text == "false" || *text == "False") return false;
  if (const auto i = parse_integer(*text)) return !i->is_zero();
  return std::nullopt;
}

}  // namespace finemote::gen::expression
