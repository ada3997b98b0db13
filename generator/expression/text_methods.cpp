// The methods of str.
#include <fmt/format.h>

#include <algorithm>
#include <functional>

#include "generator/expression/attribute.hpp"
#include "generator/expression/cost.hpp"
#include "generator/expression/format.hpp"
#include "generator/expression/iterate.hpp"
#include "generator/expression/letters.hpp"
#include "generator/expression/parameters.hpp"
#include "generator/expression/runtime.hpp"
#include "generator/expression/token.hpp"
#include "generator/expression/utf8.hpp"

namespace finemote::gen::expression {
namespace {

using Characters = std::vector<std::string_view>;

const std::string& text_of(const Value& self) { return *self.text(); }

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

Value upper(Runtime& /*r*/, const Value& self, CallArguments& arguments) {
  const Parameters none(arguments, "upper", {}, 0);
  return uppercase(text_of(self));
}

Value lower(Runtime& /*r*/, const Value& self, CallArguments& arguments) {
  const Parameters none(arguments, "lower", {}, 0);
  return lowercase(text_of(self));
}

Value swapcase(Runtime& /*r*/, const Value& self, CallArguments& arguments) {
  const Parameters none(arguments, "swapcase", {}, 0);
  return changed(text_of(self), [](char32_t c) { return is_upper(c) ? to_lower(c) : to_upper(c); });
}

Value capitalize(Runtime& /*r*/, const Value& self, CallArguments& arguments) {
  const Parameters none(arguments, "capitalize", {}, 0);
  bool first = true;
  return changed(text_of(self), [&](char32_t c) {
    c = first ? to_upper(c) : to_lower(c);
    first = false;
    return c;
  });
}

Value title(Runtime& /*r*/, const Value& self, CallArguments& arguments) {
  const Parameters none(arguments, "title", {}, 0);
  bool in_word = false;
  return changed(text_of(self), [&](char32_t c) {
    const char32_t out = in_word ? to_lower(c) : to_upper(c);
    in_word = is_letter(c);
    return out;
  });
}

// ---- what a text consists of ----

/// True when the text is not empty and `test` holds for every character.
Value all_characters(CallArguments& arguments, const Value& self, std::string_view name, bool (*test)(char32_t)) {
  const Parameters none(arguments, name, {}, 0);
  const auto characters = split_characters(text_of(self));
  return !characters.empty() &&
         std::all_of(characters.begin(), characters.end(), [&](std::string_view c) { return test(code_point(c)); });
}

Value isdigit(Runtime& /*r*/, const Value& self, CallArguments& a) {
  return all_characters(a, self, "isdigit", is_decimal);
}
Value isalpha(Runtime& /*r*/, const Value& self, CallArguments& a) {
  return all_characters(a, self, "isalpha", is_letter);
}
Value isspace(Runtime& /*r*/, const Value& self, CallArguments& a) {
  return all_characters(a, self, "isspace", is_space);
}
Value isalnum(Runtime& /*r*/, const Value& self, CallArguments& a) {
  return all_characters(a, self, "isalnum", [](char32_t c) { return is_letter(c) || is_decimal(c); });
}
Value isascii(Runtime& /*r*/, const Value& self, CallArguments& arguments) {
  const Parameters none(arguments, "isascii", {}, 0);
  return is_ascii(text_of(self));
}
Value isidentifier(Runtime& /*r*/, const Value& self, CallArguments& arguments) {
  const Parameters none(arguments, "isidentifier", {}, 0);
  return is_identifier(text_of(self)) || is_keyword(text_of(self));
}

/// All cased characters have the one case, and there is at least one.
Value one_case(CallArguments& arguments, const Value& self, std::string_view name, bool (*wanted)(char32_t),
               bool (*unwanted)(char32_t)) {
  const Parameters none(arguments, name, {}, 0);
  const auto characters = split_characters(text_of(self));
  const auto any = [&](bool (*test)(char32_t)) {
    return std::any_of(characters.begin(), characters.end(), [&](std::string_view c) { return test(code_point(c)); });
  };
  return any(wanted) && !any(unwanted);
}

Value isupper(Runtime& /*r*/, const Value& self, CallArguments& a) {
  return one_case(a, self, "isupper", is_upper, is_lower);
}
Value islower(Runtime& /*r*/, const Value& self, CallArguments& a) {
  return one_case(a, self, "islower", is_lower, is_upper);
}

// ---- stripping ----

/// The text without the characters `which` (white space when null) at one or both ends.
Value strip_ends(Runtime& runtime, CallArguments& arguments, const Value& self, std::string_view name, bool left,
                 bool right) {
  const Parameters p(arguments, name, {"chars"}, 0);
  const bool given = p[0] != nullptr && !p[0]->is_none();
  const Characters set = given ? split_characters(p.text(0)) : Characters{};
  const auto is_dropped = [&](std::string_view c) {
    runtime.budget.spend(set.size() / 8);
    return given ? std::find(set.begin(), set.end(), c) != set.end() : is_space(code_point(c));
  };
  const auto characters = split_characters(text_of(self));
  auto begin = characters.begin();
  auto end = characters.end();
  while (left && begin != end && is_dropped(*begin)) ++begin;
  while (right && begin != end && is_dropped(*(end - 1))) --end;
  std::string out;
  for (; begin != end; ++begin) out += *begin;
  return out;
}

Value strip(Runtime& r, const Value& self, CallArguments& a) { return strip_ends(r, a, self, "strip", true, true); }
Value lstrip(Runtime& r, const Value& self, CallArguments& a) { return strip_ends(r, a, self, "lstrip", true, false); }
Value rstrip(Runtime& r, const Value& self, CallArguments& a) { return strip_ends(r, a, self, "rstrip", false, true); }

Value removeprefix(Runtime& /*r*/, const Value& self, CallArguments& arguments) {
  const Parameters p(arguments, "removeprefix", {"prefix"}, 1);
  return text_of(self).starts_with(p.text(0)) ? text_of(self).substr(p.text(0).size()) : text_of(self);
}

Value removesuffix(Runtime& /*r*/, const Value& self, CallArguments& arguments) {
  const Parameters p(arguments, "removesuffix", {"suffix"}, 1);
  const std::string& text = text_of(self);
  return text.ends_with(p.text(0)) ? text.substr(0, text.size() - p.text(0).size()) : text;
}

// ---- padding ----

std::size_t padding(Runtime& runtime, const Parameters& p, const std::string& text) {
  const std::int64_t width = p.integer(0, 0);
  if (width > static_cast<std::int64_t>(kMaxText)) fail_limit("the text is too long");
  const auto length = static_cast<std::int64_t>(count_characters(text));
  const std::size_t missing = width > length ? static_cast<std::size_t>(width - length) : 0;
  runtime.budget.spend(missing / 8);
  return missing;
}

std::string repeated(std::string_view unit, std::size_t times) {
  std::string out;
  for (std::size_t i = 0; i < times; ++i) out += unit;
  return out;
}

Value padded(Runtime& runtime, CallArguments& arguments, const Value& self, std::string_view name, int side) {
  const Parameters p(arguments, name, {"width", "fillchar"}, 1);
  const std::string fill = p[1] != nullptr ? p.text(1) : " ";
  if (count_characters(fill) != 1) fail_eval("The fill character must be exactly one character long");
  const std::size_t missing = padding(runtime, p, text_of(self));
  // Python puts the odd blank of center() to the left when both the width and the gap are odd.
  const auto width = static_cast<std::size_t>(std::max<std::int64_t>(p.integer(0, 0), 0));
  const std::size_t half = missing / 2 + (missing & width & 1);
  const std::size_t left = side < 0 ? 0 : side > 0 ? missing : half;
  return repeated(fill, left) + text_of(self) + repeated(fill, missing - left);
}

Value ljust(Runtime& r, const Value& self, CallArguments& a) { return padded(r, a, self, "ljust", -1); }
Value rjust(Runtime& r, const Value& self, CallArguments& a) { return padded(r, a, self, "rjust", 1); }
Value center(Runtime& r, const Value& self, CallArguments& a) { return padded(r, a, self, "center", 0); }

Value zfill(Runtime& runtime, const Value& self, CallArguments& arguments) {
  const Parameters p(arguments, "zfill", {"width"}, 1);
  const std::string& text = text_of(self);
  const std::size_t sign = text.starts_with('-') || text.starts_with('+') ? 1 : 0;
  return text.substr(0, sign) + std::string(padding(runtime, p, text), '0') + text.substr(sign);
}

Value expandtabs(Runtime& runtime, const Value& self, CallArguments& arguments) {
  const Parameters p(arguments, "expandtabs", {"tabsize"}, 0);
  const std::int64_t size = std::clamp<std::int64_t>(p.integer(0, 8), 0, 1000);
  std::string out;
  std::int64_t column = 0;
  for (const std::string_view c : split_characters(text_of(self))) {
    if (c == "\t") {
      const std::int64_t blanks = size == 0 ? 0 : size - column % size;
      runtime.budget.spend(static_cast<std::size_t>(blanks) / 64);
      out.append(static_cast<std::size_t>(blanks), ' ');
      column += blanks;
    } else {
      out += c;
      column = c == "\n" || c == "\r" ? 0 : column + 1;
    }
    if (out.size() > kMaxText) fail_limit("the text is too long");
  }
  return out;
}

// ---- searching ----

/// The part of a text that the optional arguments start and end (in characters) select, and where it begins.
struct Window {
  std::string_view text;
  std::size_t first_character = 0;
  bool is_valid = true;  ///< false when it begins behind the end
};

Window window(const Parameters& p, std::size_t first, const std::string& text) {
  if (p[first] == nullptr && p[first + 1] == nullptr) return {text};
  const auto characters = split_characters(text);
  const auto size = static_cast<std::int64_t>(characters.size());
  const auto place = [&](std::int64_t i) { return std::max<std::int64_t>(i < 0 ? i + size : i, 0); };
  const std::int64_t start = place(p.integer(first, 0));
  const std::int64_t end = std::min(place(p.integer(first + 1, size)), size);
  if (start > end || start > size) return {{}, 0, false};
  const auto offset = [&](std::int64_t i) {
    return i >= size ? text.size()
                     : static_cast<std::size_t>(characters[static_cast<std::size_t>(i)].data() - text.data());
  };
  return {std::string_view(text).substr(offset(start), offset(end) - offset(start)), static_cast<std::size_t>(start)};
}

/// Index of the first or last occurrence in characters, or -1.
std::int64_t search(Runtime& runtime, CallArguments& arguments, const Value& self, std::string_view name, bool last) {
  const Parameters p(arguments, name, {"sub", "start", "end"}, 1);
  const std::string& wanted = p.text(0);
  const Window w = window(p, 1, text_of(self));
  if (!w.is_valid) return -1;
  runtime.budget.spend(cost_of_search(text_of(self), wanted));
  const auto at = last ? w.text.rfind(wanted) : w.text.find(wanted);
  if (at == std::string_view::npos) return -1;
  return static_cast<std::int64_t>(w.first_character + count_characters(w.text.substr(0, at)));
}

Value find(Runtime& r, const Value& self, CallArguments& a) { return search(r, a, self, "find", false); }
Value rfind(Runtime& r, const Value& self, CallArguments& a) { return search(r, a, self, "rfind", true); }

Value found(std::int64_t at) {
  if (at < 0) fail_eval("substring not found");
  return at;
}

Value index(Runtime& r, const Value& self, CallArguments& a) { return found(search(r, a, self, "index", false)); }
Value rindex(Runtime& r, const Value& self, CallArguments& a) { return found(search(r, a, self, "rindex", true)); }

Value count(Runtime& runtime, const Value& self, CallArguments& arguments) {
  const Parameters p(arguments, "count", {"sub", "start", "end"}, 1);
  const std::string& wanted = p.text(0);
  const Window w = window(p, 1, text_of(self));
  if (!w.is_valid) return 0;
  if (wanted.empty()) return static_cast<std::int64_t>(count_characters(w.text)) + 1;
  runtime.budget.spend(cost_of_search(text_of(self), wanted));
  std::int64_t times = 0;
  for (auto at = w.text.find(wanted); at != std::string_view::npos; at = w.text.find(wanted, at + wanted.size()))
    ++times;
  return times;
}

/// startswith() and endswith(): one text or a tuple of them.
Value matches_end(Runtime& runtime, CallArguments& arguments, const Value& self, std::string_view name, bool at_start) {
  const Parameters p(arguments, name, {"prefix", "start", "end"}, 1);
  const Window w = window(p, 1, text_of(self));
  const auto matches = [&](const Value& value) {
    if (value.text() == nullptr) {
      fail_eval(fmt::format("{} first arg must be str or a tuple of str, not {}", name, type_name(value)));
    }
    return w.is_valid && (at_start ? w.text.starts_with(*value.text()) : w.text.ends_with(*value.text()));
  };
  if (p.at(0).object<const Tuple>() == nullptr) return matches(p.at(0));
  const Values any = items_of(runtime, p.at(0));
  return std::any_of(any.begin(), any.end(), matches);
}

Value startswith(Runtime& r, const Value& self, CallArguments& a) {
  return matches_end(r, a, self, "startswith", true);
}
Value endswith(Runtime& r, const Value& self, CallArguments& a) { return matches_end(r, a, self, "endswith", false); }

// ---- cutting and joining ----

constexpr std::int64_t kAll = std::int64_t{1} << 60;

std::int64_t most(const Parameters& p, std::size_t i) {
  const std::int64_t limit = p.integer(i, -1);
  return limit < 0 ? kAll : limit;
}

Values split_at_blanks(const std::string& text, std::int64_t limit) {
  Values parts;
  const auto characters = split_characters(text);
  std::size_t at = 0;
  const auto skip = [&] {
    while (at < characters.size() && is_space(code_point(characters[at]))) ++at;
  };
  for (skip(); at < characters.size(); skip()) {
    std::string part;
    const bool is_last = limit-- <= 0;
    while (at < characters.size() && (is_last || !is_space(code_point(characters[at])))) part += characters[at++];
    if (is_last) {
      while (!part.empty() && is_space(static_cast<unsigned char>(part.back()))) part.pop_back();
    }
    parts.emplace_back(std::move(part));
  }
  return parts;
}

Values split_at(std::string_view text, const std::string& separator, std::int64_t limit) {
  Values parts;
  for (auto at = text.find(separator); at != std::string_view::npos && limit-- > 0; at = text.find(separator)) {
    parts.emplace_back(text.substr(0, at));
    text.remove_prefix(at + separator.size());
  }
  parts.emplace_back(text);
  return parts;
}

Values split_at_from_right(std::string_view text, const std::string& separator, std::int64_t limit) {
  Values parts;
  for (auto at = text.rfind(separator); at != std::string_view::npos && limit-- > 0; at = text.rfind(separator)) {
    parts.emplace_back(text.substr(at + separator.size()));
    text = text.substr(0, at);
  }
  parts.emplace_back(text);
  std::reverse(parts.begin(), parts.end());
  return parts;
}

/// rsplit() at white space: split the reversed text.
Values split_at_blanks_from_right(const std::string& text, std::int64_t limit) {
  const auto reverse = [](const std::string& forward) {
    std::string out;
    const auto characters = split_characters(forward);
    for (auto c = characters.rbegin(); c != characters.rend(); ++c) out += *c;
    return out;
  };
  Values parts = split_at_blanks(reverse(text), limit);
  for (Value& part : parts) part = reverse(*part.text());
  std::reverse(parts.begin(), parts.end());
  return parts;
}

Value cut(Runtime& runtime, CallArguments& arguments, const Value& self, std::string_view name, bool from_right) {
  const Parameters p(arguments, name, {"sep", "maxsplit"}, 0);
  const std::int64_t limit = most(p, 1);
  const std::string& text = text_of(self);
  runtime.budget.spend(text.size());  // each byte may begin a part
  if (p[0] == nullptr || p[0]->is_none()) {
    return make_list(from_right ? split_at_blanks_from_right(text, limit) : split_at_blanks(text, limit));
  }
  if (p.text(0).empty()) fail_eval("empty separator");
  runtime.budget.spend(cost_of_search(text, p.text(0)));
  return make_list(from_right ? split_at_from_right(text, p.text(0), limit) : split_at(text, p.text(0), limit));
}

Value split(Runtime& r, const Value& self, CallArguments& a) { return cut(r, a, self, "split", false); }
Value rsplit(Runtime& r, const Value& self, CallArguments& a) { return cut(r, a, self, "rsplit", true); }

Value splitlines(Runtime& runtime, const Value& self, CallArguments& arguments) {
  const Parameters p(arguments, "splitlines", {"keepends"}, 0);
  const bool keep = p[0] != nullptr && is_true(p.at(0));
  Values lines;
  std::string_view rest = text_of(self);
  runtime.budget.spend(rest.size());
  while (!rest.empty()) {
    const auto end = std::min(rest.find_first_of("\r\n"), rest.size());
    std::size_t mark = end < rest.size() ? 1 : 0;
    if (rest.substr(end, 2) == "\r\n") mark = 2;
    lines.emplace_back(rest.substr(0, keep ? end + mark : end));
    rest.remove_prefix(end + mark);
  }
  return make_list(std::move(lines));
}

Value partition_at(Runtime& runtime, CallArguments& arguments, const Value& self, std::string_view name, bool last) {
  const Parameters p(arguments, name, {"sep"}, 1);
  const std::string& separator = p.text(0);
  const std::string& text = text_of(self);
  if (separator.empty()) fail_eval("empty separator");
  runtime.budget.spend(cost_of_search(text, separator));
  const auto at = last ? text.rfind(separator) : text.find(separator);
  if (at != std::string::npos) return make_tuple({text.substr(0, at), separator, text.substr(at + separator.size())});
  return last ? make_tuple({"", "", text}) : make_tuple({text, "", ""});
}

Value partition(Runtime& r, const Value& self, CallArguments& a) {
  return partition_at(r, a, self, "partition", false);
}
Value rpartition(Runtime& r, const Value& self, CallArguments& a) {
  return partition_at(r, a, self, "rpartition", true);
}

Value join(Runtime& runtime, const Value& self, CallArguments& arguments) {
  const Parameters p(arguments, "join", {"iterable"}, 1);
  std::string out;
  std::size_t i = 0;
  for (const Value& item : items_of(runtime, p.at(0))) {
    if (item.text() == nullptr) {
      fail_eval(fmt::format("sequence item {}: expected str instance, {} found", i, type_name(item)));
    }
    if (i++ > 0) out += text_of(self);
    out += *item.text();
    if (out.size() > kMaxText) fail_limit("the text is too long");
  }
  runtime.budget.spend(cost_of_block(out.size()));
  return out;
}

Value replace(Runtime& runtime, const Value& self, CallArguments& arguments) {
  const Parameters p(arguments, "replace", {"old", "new", "count"}, 2);
  const std::string& from = p.text(0);
  const std::string& to = p.text(1);
  std::int64_t limit = most(p, 2);
  std::string_view rest = text_of(self);
  runtime.budget.spend(rest.size() + cost_of_search(text_of(self), from));
  std::string out;
  const auto check = [&] {
    if (out.size() > kMaxText) fail_limit("the text is too long");
    runtime.budget.spend(cost_of_block(to.size()));
  };
  if (from.empty()) {
    for (const std::string_view c : split_characters(rest)) {
      if (limit-- > 0) out += to;
      out += c;
      check();
    }
    return limit > 0 ? out + to : out;
  }
  for (auto at = rest.find(from); at != std::string_view::npos && limit-- > 0; at = rest.find(from)) {
    out += rest.substr(0, at);
    out += to;
    rest.remove_prefix(at + from.size());
    check();
  }
  return out.append(rest);
}

Value format(Runtime& runtime, const Value& self, CallArguments& arguments) {
  return format_braces(runtime, text_of(self), arguments);
}

constexpr Method kMethods[] = {{"capitalize", capitalize},
                               {"casefold", lower},
                               {"center", center},
                               {"count", count},
                               {"endswith", endswith},
                               {"expandtabs", expandtabs},
                               {"find", find},
                               {"format", format},
                               {"index", index},
                               {"isalnum", isalnum},
                               {"isalpha", isalpha},
                               {"isascii", isascii},
                               {"isdecimal", isdigit},
                               {"isdigit", isdigit},
                               {"isidentifier", isidentifier},
                               {"islower", islower},
                               {"isnumeric", isdigit},
                               {"isspace", isspace},
                               {"isupper", isupper},
                               {"join", join},
                               {"ljust", ljust},
                               {"lower", lower},
                               {"lstrip", lstrip},
                               {"partition", partition},
                               {"removeprefix", removeprefix},
                               {"removesuffix", removesuffix},
                               {"replace", replace},
                               {"rfind", rfind},
                               {"rindex", rindex},
                               {"rjust", rjust},
                               {"rpartition", rpartition},
                               {"rsplit", rsplit},
                               {"rstrip", rstrip},
                               {"split", split},
                               {"splitlines", splitlines},
                               {"startswith", startswith},
                               {"strip", strip},
                               {"swapcase", swapcase},
                               {"title", title},
                               {"upper", upper},
                               {"zfill", zfill}};

}  // namespace

const Method* find_text_method(std::string_view name) {
  const auto* found =
      std::find_if(std::begin(kMethods), std::end(kMethods), [&](const Method& m) { return m.name == name; });
  return found != std::end(kMethods) ? found : nullptr;
}

}  // namespace finemote::gen::expression
