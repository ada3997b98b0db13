// The methods of str that go by kinds of characters: upper and lower case, letters, digits, blanks.
#include <algorithm>

#include "generator/expression/function.hpp"
#include "generator/expression/letters.hpp"
#include "generator/expression/str_methods.hpp"
#include "generator/expression/token.hpp"
#include "generator/expression/utf8.hpp"

namespace finemote::gen::expression {
namespace {

template <typename Change>
std::string changed(const std::string& text, Change change) {
  std::string out;
  for (const std::string_view c : split_characters(text)) out += encode(change(code_point(c)));
  return out;
}

std::string uppercase(const std::string& text) {
  std::string out;
  for (const std::string_view c : split_characters(text)) out += c == "ß" ? "SS" : encode(to_upper(code_point(c)));
  return out;
}

std::string lowercase(const std::string& text) { return changed(text, to_lower); }

Value upper(Runtime& /*r*/, const Value& self, const Parameters& /*none*/) { return uppercase(text_of(self)); }

Value lower(Runtime& /*r*/, const Value& self, const Parameters& /*none*/) { return lowercase(text_of(self)); }

Value swapcase(Runtime& /*r*/, const Value& self, const Parameters& /*none*/) {
  return changed(text_of(self), [](char32_t c) { return is_upper(c) ? to_lower(c) : to_upper(c); });
}

Value capitalize(Runtime& /*r*/, const Value& self, const Parameters& /*none*/) {
  bool first = true;
  return changed(text_of(self), [&](char32_t c) {
    c = first ? to_upper(c) : to_lower(c);
    first = false;
    return c;
  });
}

Value title(Runtime& /*r*/, const Value& self, const Parameters& /*none*/) {
  bool in_word = false;
  return changed(text_of(self), [&](char32_t c) {
    const char32_t out = in_word ? to_lower(c) : to_upper(c);
    in_word = is_letter(c);
    return out;
  });
}

// ---- what a text consists of ----

/// True when the text is not empty and `Test` holds for every character.
template <bool (*Test)(char32_t)>
Value all_characters(Runtime& /*r*/, const Value& self, const Parameters& /*none*/) {
  const auto characters = split_characters(text_of(self));
  return !characters.empty() &&
         std::all_of(characters.begin(), characters.end(), [&](std::string_view c) { return Test(code_point(c)); });
}

bool is_letter_or_decimal(char32_t c) { return is_letter(c) || is_decimal(c); }

Value isascii(Runtime& /*r*/, const Value& self, const Parameters& /*none*/) { return is_ascii(text_of(self)); }
Value isidentifier(Runtime& /*r*/, const Value& self, const Parameters& /*none*/) {
  return is_identifier(text_of(self)) || is_keyword(text_of(self));
}

/// All cased characters have the one case, and there is at least one.
template <bool (*Wanted)(char32_t), bool (*Unwanted)(char32_t)>
Value one_case(Runtime& /*r*/, const Value& self, const Parameters& /*none*/) {
  const auto characters = split_characters(text_of(self));
  const auto any = [&](bool (*test)(char32_t)) {
    return std::any_of(characters.begin(), characters.end(), [&](std::string_view c) { return test(code_point(c)); });
  };
  return any(Wanted) && !any(Unwanted);
}

constexpr Signature kNothing;
/// Other names of one method, which its messages call by its first one.
constexpr Signature kLower({}, 0, "lower");
constexpr Signature kIsDigit({}, 0, "isdigit");

constexpr Method kCaseMethods[] = {{"capitalize", kNothing, capitalize},
                                   {"casefold", kLower, lower},
                                   {"isalnum", kNothing, all_characters<is_letter_or_decimal>},
                                   {"isalpha", kNothing, all_characters<is_letter>},
                                   {"isascii", kNothing, isascii},
                                   {"isdecimal", kIsDigit, all_characters<is_decimal>},
                                   {"isdigit", kNothing, all_characters<is_decimal>},
                                   {"isidentifier", kNothing, isidentifier},
                                   {"islower", kNothing, one_case<is_lower, is_upper>},
                                   {"isnumeric", kIsDigit, all_characters<is_decimal>},
                                   {"isspace", kNothing, all_characters<is_space>},
                                   {"isupper", kNothing, one_case<is_upper, is_lower>},
                                   {"lower", kNothing, lower},
                                   {"swapcase", kNothing, swapcase},
                                   {"title", kNothing, title},
                                   {"upper", kNothing, upper}};

}  // namespace

const Method* find_case_method(std::string_view name) { return find_method(kCaseMethods, name); }

}  // namespace finemote::gen::expression
