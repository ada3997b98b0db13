#include "generator/expression/print.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

#include "generator/expression/compare.hpp"
#include "generator/expression/cost.hpp"
#include "generator/expression/function.hpp"
#include "generator/expression/runtime.hpp"

namespace finemote::gen::expression {
namespace {

/// The quote Python would choose: single, unless only single ones are inside.
char quote_for(std::string_view text) {
  const bool has_single = text.find('\'') != std::string_view::npos;
  return has_single && text.find('"') == std::string_view::npos ? '"' : '\'';
}

void append_quoted(std::string& out, std::string_view text) {
  const char quote = quote_for(text);
  out += quote;
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (c == quote || c == '\\') {
      out += '\\';
      out += c;
    } else if (c == '\n') {
      out += "\\n";
    } else if (c == '\r') {
      out += "\\r";
    } else if (c == '\t') {
      out += "\\t";
    } else if (byte < 0x20 || byte == 0x7f) {
      out += fmt::format("\\x{:02x}", byte);
    } else {
      out += c;
    }
  }
  out += quote;
}

class Printer {
 public:
  Printer(Runtime& runtime, std::string& out) : runtime_(runtime), out_(out) {}

  void source(const Value& value) {
    runtime_.budget.spend(1 + cost_of_printing(value));
    if (out_.size() > kMaxText) fail_limit("the text is too long");
    const Level level(runtime_.depth, kMaxEvalDepth,
                      "maximum recursion depth exceeded while getting the repr of an object");
    if (!container(value)) plain(value);
  }

 private:
  /// Prints a value that holds others; false for one that holds none.
  bool container(const Value& value) {
    switch (value.type()) {
      case Type::list:
        return sequence('[', *value.object<List>()->items, "]"), true;
      case Type::tuple:
        return tuple(value.object<const Tuple>()->items), true;
      case Type::dict:
        return dict(*value.object<Dict>()->table), true;
      case Type::set:
      case Type::frozen_set:
        return set(*value.object<Set>()), true;
      case Type::slice:
        return slice(*value.object<const Slice>()->bounds), true;
      case Type::dict_keys:
      case Type::dict_values:
      case Type::dict_items:
        return view(*value.object<const DictView>()), true;
      default:
        return false;
    }
  }

  void plain(const Value& value) {
    switch (value.type()) {
      case Type::none:
        out_ += "None";
        break;
      case Type::boolean:
        out_ += *value.as<bool>() ? "True" : "False";
        break;
      case Type::integer:
        out_ += value.as<Integer>()->to_string();
        break;
      case Type::real:
        out_ += real_to_text(*value.as<double>());
        break;
      case Type::text:
        append_quoted(out_, *value.text());
        break;
      case Type::range:
        range(*value.object<const Range>());
        break;
      case Type::type:
        out_ += fmt::format("<class '{}'>", type_name(*value.as<Type>()));
        break;
      case Type::builtin:
        out_ += fmt::format("<built-in function {}>", (*value.as<const Builtin*>())->name);
        break;
      case Type::function:
        out_ += "<function <lambda>>";
        break;
      case Type::method:
        method(*value.object<const BoundMethod>());
        break;
      case Type::name_space:
        out_ += "<namespace>";
        break;
      default:
        out_ += fmt::format("<{} object>", type_name(value));
        break;
    }
  }

  void items(const Values& values) {
    for (std::size_t i = 0; i < values.size(); ++i) {
      if (i > 0) out_ += ", ";
      source(values[i]);
    }
  }

  void sequence(char open, const Values& values, const char* close) {
    out_ += open;
    items(values);
    out_ += close;
  }

  void tuple(const Values& values) { sequence('(', values, values.size() == 1 ? ",)" : ")"); }

  void dict(const Table& table) {
    out_ += '{';
    const char* separator = "";
    for (const auto& [key, value] : table.entries()) {
      out_ += separator;
      source(key);
      out_ += ": ";
      source(value);
      separator = ", ";
    }
    out_ += '}';
  }

  /// Sets of integers print in ascending order, as small ones do in Python; others in order of insertion.
  void set(const Set& set) {
    Values values;
    for (const auto& entry : set.table.entries()) values.push_back(entry.first);
    const bool all_integers =
        std::all_of(values.begin(), values.end(), [](const Value& v) { return v.type() == Type::integer; });
    if (all_integers) sort_values(runtime_, values, false);
    const char* name = set.is_frozen ? "frozenset" : "set";
    if (values.empty()) {
      out_ += fmt::format("{}()", name);
      return;
    }
    if (set.is_frozen) out_ += "frozenset(";
    sequence('{', values, "}");
    if (set.is_frozen) out_ += ')';
  }

  void range(const Range& r) {
    out_ += fmt::format("range({}, {}", r.start, r.stop);
    if (r.step != 1) out_ += fmt::format(", {}", r.step);
    out_ += ')';
  }

  void slice(const Values& bounds) {
    out_ += "slice";
    sequence('(', bounds, ")");
  }

  void view(const DictView& v) {
    out_ += type_name(v.type);
    out_ += "([";
    const char* separator = "";
    for (const auto& [key, value] : v.dict->table->entries()) {
      out_ += separator;
      separator = ", ";
      if (v.type == Type::dict_items) tuple({key, value});
      if (v.type == Type::dict_keys) source(key);
      if (v.type == Type::dict_values) source(value);
    }
    out_ += "])";
  }

  void method(const BoundMethod& m) {
    out_ += fmt::format("<built-in method {} of {} object>", m.method->name, type_name(*m.self));
  }

  Runtime& runtime_;
  std::string& out_;
};

}  // namespace

std::string real_to_text(double value) {
  if (std::isnan(value)) return "nan";
  if (std::isinf(value)) return value < 0 ? "-inf" : "inf";
  char buffer[32];
  const auto end = std::to_chars(buffer, buffer + sizeof buffer, value, std::chars_format::scientific).ptr;
  const std::string_view shortest(buffer, static_cast<std::size_t>(end - buffer));
  const auto mark = shortest.find('e');
  const std::string_view written = shortest.substr(0, mark);
  const std::size_t sign_size = shortest[mark + 1] == '+' ? 1 : 0;  // from_chars reads no '+'
  int exponent = 0;
  std::from_chars(buffer + mark + 1 + sign_size, end, exponent);
  if (exponent < -4 || exponent >= 16) {
    return fmt::format("{}e{}{:02}", written, exponent < 0 ? '-' : '+', std::abs(exponent));
  }

  std::string digits;
  for (const char c : written) {
    if (c != '-' && c != '.') digits += c;
  }
  const std::string sign = written[0] == '-' ? "-" : "";
  if (exponent < 0) return sign + "0." + std::string(static_cast<std::size_t>(-exponent - 1), '0') + digits;
  const auto whole = static_cast<std::size_t>(exponent) + 1;
  if (digits.size() <= whole) return sign + digits + std::string(whole - digits.size(), '0') + ".0";
  return sign + digits.substr(0, whole) + "." + digits.substr(whole);
}

std::string to_text(Runtime& runtime, const Value& value) {
  if (value.text() != nullptr) {
    runtime.budget.spend(cost_of_block(bytes_of(value)));
    return *value.text();
  }
  return to_source(runtime, value);
}

std::string to_source(Runtime& runtime, const Value& value) {
  std::string out;
  Printer(runtime, out).source(value);
  return out;
}

}  // namespace finemote::gen::expression
