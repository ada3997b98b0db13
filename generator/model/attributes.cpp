#include "generator/model/attributes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

namespace finemote::gen {
namespace {

constexpr std::string_view kBlanks = " \t\r\n";

Position advance(Position at, std::string_view over) {
  for (const char c : over) {
    if (c == '\n') {
      ++at.line;
      at.column = 1;
    } else {
      ++at.column;
    }
  }
  return at;
}

}  // namespace

std::string_view trim(std::string_view text) {
  const std::size_t begin = text.find_first_not_of(kBlanks);
  if (begin == std::string_view::npos) return {};
  return text.substr(begin, text.find_last_not_of(kBlanks) - begin + 1);
}

TextAt trimmed_text(const xml::Node& text) {
  const std::size_t begin = std::min(text.text.find_first_not_of(kBlanks), text.text.size());
  const std::string_view before = std::string_view(text.text).substr(0, begin);
  return {std::string(trim(text.text)), text.kind == xml::Node::Kind::text ? advance(text.at, before) : text.at};
}

TextAt element_text(const xml::Node& element) {
  TextAt all{{}, element.at};
  bool found = false;
  for (const xml::Node& child : element.children) {
    if (child.kind != xml::Node::Kind::text && child.kind != xml::Node::Kind::cdata) continue;
    if (!found && !trim(child.text).empty()) {
      all.at = trimmed_text(child).at;
      found = true;
    }
    all.text += child.text;
  }
  all.text = std::string(trim(all.text));
  return all;
}

Diagnostic& at_value(Diagnostics& diagnostics, Code code, const xml::Attribute& attribute, std::string message) {
  return diagnostics.error(code, attribute.value_at, std::move(message)).underline(attribute.value.size());
}

Diagnostic& at_tag(Diagnostics& diagnostics, Code code, const xml::Node& node, std::string message) {
  return diagnostics.error(code, node.at, std::move(message)).underline(node.name.size() + 1);
}

std::optional<Duration> read_duration_in(const xml::Node& node, std::string_view name, std::string_view unit,
                                         Diagnostics& diagnostics) {
  const xml::Attribute* attribute = node.attribute(name);
  if (attribute == nullptr) return {};
  const auto result = units::parse_duration(attribute->value);
  if (result) return *result;
  const units::Fault fault = units::with_meant_unit(result.fault(), attribute->value, {unit}, units::parse_duration, 0,
                                                    static_cast<double>(INT64_MAX));
  Diagnostic& finding = at_value(diagnostics, fault.code, *attribute, std::string(name) + ": " + fault.message);
  if (!fault.hint.empty()) finding.hint(fault.hint);
  return {};
}

std::optional<std::string> read_choice(const xml::Node& node, std::string_view name,
                                       const std::vector<std::string>& choices, Diagnostics& diagnostics) {
  const xml::Attribute* attribute = node.attribute(name);
  if (attribute == nullptr) return {};
  if (std::find(choices.begin(), choices.end(), attribute->value) != choices.end()) return attribute->value;
  suggest(at_value(diagnostics, code::bad_choice, *attribute,
                   fmt::format("'{}' is not a valid {} of <{}>", attribute->value, name, node.name)),
          attribute->value, choices);
  // letter case alone: what was meant is clear, and the rest can be judged by it
  const auto meant = std::find_if(choices.begin(), choices.end(), [&](const std::string& choice) {
    return choice.size() == attribute->value.size() &&
           std::equal(choice.begin(), choice.end(), attribute->value.begin(),
                      [](unsigned char a, unsigned char b) { return std::tolower(a) == std::tolower(b); });
  });
  if (meant != choices.end()) return *meant;
  return {};
}

std::string_view value_of(const xml::Node& node, std::string_view name) {
  const xml::Attribute* attribute = node.attribute(name);
  return attribute == nullptr ? std::string_view() : std::string_view(attribute->value);
}

}  // namespace finemote::gen
