// The methods of str: searching, cutting, padding, joining. A method is its function and a row of the table at the end.
#include <fmt/format.h>

#include <algorithm>

#include "generator/expression/cost.hpp"
#include "generator/expression/format.hpp"
#include "generator/expression/iterate.hpp"
#include "generator/expression/letters.hpp"
#include "generator/expression/parameters.hpp"
#include "generator/expression/runtime.hpp"
#include "generator/expression/str_methods.hpp"
#include "generator/expression/utf8.hpp"

namespace finemote::gen::expression {
namespace {

using Characters = std::vector<std::string_view>;

// ---- stripping ----

/// The text without the given characters (white space when none are given) at one or both ends.
Value strip_ends(Runtime& runtime, const Value& self, const Parameters& p, bool left, bool right) {
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

Value strip(Runtime& r, const Value& self, const Parameters& p) { return strip_ends(r, self, p, true, true); }
Value lstrip(Runtime& r, const Value& self, const Parameters& p) { return strip_ends(r, self, p, true, false); }
Value rstrip(Runtime& r, const Value& self, const Parameters& p) { return strip_ends(r, self, p, false, true); }

Value removeprefix(Runtime& /*r*/, const Value& self, const Parameters& p) {
  return text_of(self).starts_with(p.text(0)) ? text_of(self).substr(p.text(0).size()) : text_of(self);
}

Value removesuffix(Runtime& /*r*/, const Value& self, const Parameters& p) {
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

Value padded(Runtime& runtime, const Value& self, const Parameters& p, int side) {
  const std::string fill = p[1] != nullptr ? p.text(1) : " ";
  if (count_characters(fill) != 1) fail_eval("The fill character must be exactly one character long");
  const std::size_t missing = padding(runtime, p, text_of(self));
  // Python puts the odd blank of center() to the left when both the width and the gap are odd.
  const auto width = static_cast<std::size_t>(std::max<std::int64_t>(p.integer(0, 0), 0));
  const std::size_t half = missing / 2 + (missing & width & 1);
  const std::size_t left = side < 0 ? 0 : side > 0 ? missing : half;
  return repeated(fill, left) + text_of(self) + repeated(fill, missing - left);
}

Value ljust(Runtime& r, const Value& self, const Parameters& p) { return padded(r, self, p, -1); }
Value rjust(Runtime& r, const Value& self, const Parameters& p) { return padded(r, self, p, 1); }
Value center(Runtime& r, const Value& self, const Parameters& p) { return padded(r, self, p, 0); }

Value zfill(Runtime& runtime, const Value& self, const Parameters& p) {
  const std::string& text = text_of(self);
  const std::size_t sign = text.starts_with('-') || text.starts_with('+') ? 1 : 0;
  return text.substr(0, sign) + std::string(padding(runtime, p, text), '0') + text.substr(sign);
}

Value expandtabs(Runtime& runtime, const Value& self, const Parameters& p) {
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
  bool is_valid = true;  ///< false when it starts after the end
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
std::int64_t search(Runtime& runtime, const Value& self, const Parameters& p, bool last) {
  const std::string& wanted = p.text(0);
  const Window w = window(p, 1, text_of(self));
  if (!w.is_valid) return -1;
  runtime.budget.spend(cost_of_search(text_of(self), wanted));
  const auto at = last ? w.text.rfind(wanted) : w.text.find(wanted);
  if (at == std::string_view::npos) return -1;
  return static_cast<std::int64_t>(w.first_character + count_characters(w.text.substr(0, at)));
}

Value find(Runtime& r, const Value& self, const Parameters& p) { return search(r, self, p, false); }
Value rfind(Runtime& r, const Value& self, const Parameters& p) { return search(r, self, p, true); }

Value found(std::int64_t at) {
  if (at < 0) fail_eval("substring not found");
  return at;
}

Value index(Runtime& r, const Value& self, const Parameters& p) { return found(search(r, self, p, false)); }
Value rindex(Runtime& r, const Value& self, const Parameters& p) { return found(search(r, self, p, true)); }

Value count(Runtime& runtime, const Value& self, const Parameters& p) {
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
Value matches_end(Runtime& runtime, const Value& self, const Parameters& p, bool at_start) {
  const Window w = window(p, 1, text_of(self));
  const auto matches = [&](const Value& value) {
    if (value.text() == nullptr) {
      fail_eval(fmt::format("{} first arg must be str or a tuple of str, not {}", p.function(), type_name(value)));
    }
    return w.is_valid && (at_start ? w.text.starts_with(*value.text()) : w.text.ends_with(*value.text()));
  };
  if (p.at(0).object<const Tuple>() == nullptr) return matches(p.at(0));
  const Values any = items_of(runtime, p.at(0));
  return std::any_of(any.begin(), any.end(), matches);
}

Value startswith(Runtime& r, const Value& self, const Parameters& p) { return matches_end(r, self, p, true); }
Value endswith(Runtime& r, const Value& self, const Parameters& p) { return matches_end(r, self, p, false); }

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

Value cut(Runtime& runtime, const Value& self, const Parameters& p, bool from_right) {
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

Value split(Runtime& r, const Value& self, const Parameters& p) { return cut(r, self, p, false); }
Value rsplit(Runtime& r, const Value& self, const Parameters& p) { return cut(r, self, p, true); }

Value splitlines(Runtime& runtime, const Value& self, const Parameters& p) {
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

Value partition_at(Runtime& runtime, const Value& self, const Parameters& p, bool last) {
  const std::string& separator = p.text(0);
  const std::string& text = text_of(self);
  if (separator.empty()) fail_eval("empty separator");
  runtime.budget.spend(cost_of_search(text, separator));
  const auto at = last ? text.rfind(separator) : text.find(separator);
  if (at != std::string::npos) return make_tuple({text.substr(0, at), separator, text.substr(at + separator.size())});
  return last ? make_tuple({"", "", text}) : make_tuple({text, "", ""});
}

Value partition(Runtime& r, const Value& self, const Parameters& p) { return partition_at(r, self, p, false); }
Value rpartition(Runtime& r, const Value& self, const Parameters& p) { return partition_at(r, self, p, true); }

Value join(Runtime& runtime, const Value& self, const Parameters& p) {
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

Value replace(Runtime& runtime, const Value& self, const Parameters& p) {
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

Value format(Runtime& runtime, const Value& self, const Parameters& p) {
  return format_braces(runtime, text_of(self), p.all());
}

constexpr Method kStrMethods[] = {{"center", {{"width", "fillchar"}, 1}, center},
                                  {"count", {{"sub", "start", "end"}, 1}, count},
                                  {"endswith", {{"prefix", "start", "end"}, 1}, endswith},
                                  {"expandtabs", {{"tabsize"}, 0}, expandtabs},
                                  {"find", {{"sub", "start", "end"}, 1}, find},
                                  {"format", Signature::free(), format},
                                  {"index", {{"sub", "start", "end"}, 1}, index},
                                  {"join", {{"iterable"}, 1}, join},
                                  {"ljust", {{"width", "fillchar"}, 1}, ljust},
                                  {"lstrip", {{"chars"}, 0}, lstrip},
                                  {"partition", {{"sep"}, 1}, partition},
                                  {"removeprefix", {{"prefix"}, 1}, removeprefix},
                                  {"removesuffix", {{"suffix"}, 1}, removesuffix},
                                  {"replace", {{"old", "new", "count"}, 2}, replace},
                                  {"rfind", {{"sub", "start", "end"}, 1}, rfind},
                                  {"rindex", {{"sub", "start", "end"}, 1}, rindex},
                                  {"rjust", {{"width", "fillchar"}, 1}, rjust},
                                  {"rpartition", {{"sep"}, 1}, rpartition},
                                  {"rsplit", {{"sep", "maxsplit"}, 0}, rsplit},
                                  {"rstrip", {{"chars"}, 0}, rstrip},
                                  {"split", {{"sep", "maxsplit"}, 0}, split},
                                  {"splitlines", {{"keepends"}, 0}, splitlines},
                                  {"startswith", {{"prefix", "start", "end"}, 1}, startswith},
                                  {"strip", {{"chars"}, 0}, strip},
                                  {"zfill", {{"width"}, 1}, zfill}};

}  // namespace

const Method* find_str_method(std::string_view name) {
  const Method* found = find_method(kStrMethods, name);
  return found != nullptr ? found : find_case_method(name);
}

}  // namespace finemote::gen::expression
