// Attributes and texts of tags to values, with the mistake shown under the value.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "generator/diagnostic/diagnostics.hpp"
#include "generator/diagnostic/suggest.hpp"
#include "generator/units/duration.hpp"
#include "generator/units/units.hpp"
#include "generator/xml/node.hpp"

namespace finemote::gen {

/// Without white space at both ends.
std::string_view trim(std::string_view text);

/// A text and where it begins.
struct TextAt {
  std::string text;
  Position at;
};

/// The text of a text node without surrounding white space.
TextAt trimmed_text(const xml::Node& text);

/// All text of an element together, without surrounding white space; of an empty element, its tag.
TextAt element_text(const xml::Node& element);

/// An error under the value of an attribute.
Diagnostic& at_value(Diagnostics& diagnostics, Code code, const xml::Attribute& attribute, std::string message);

/// An error under `<name` of a tag.
Diagnostic& at_tag(Diagnostics& diagnostics, Code code, const xml::Node& node, std::string message);

/// The attribute's value as a quantity; none when it is absent, and when it is wrong, which is reported.
/// `parse` is one of the functions of generator/units.
template <typename T>
std::optional<T> read_quantity(const xml::Node& node, std::string_view name,
                               units::Result<T> (*parse)(std::string_view), Diagnostics& diagnostics) {
  const xml::Attribute* attribute = node.attribute(name);
  if (attribute == nullptr) return {};
  const units::Result<T> result = parse(attribute->value);
  if (result) return *result;
  const units::Fault& fault = result.fault();
  Diagnostic& finding = at_value(diagnostics, fault.code, *attribute, std::string(name) + ": " + fault.message);
  if (!fault.hint.empty()) finding.hint(fault.hint);
  return {};
}

/// A duration whose number without unit is more likely one of `unit` than of ms.
std::optional<Duration> read_duration_in(const xml::Node& node, std::string_view name, std::string_view unit,
                                         Diagnostics& diagnostics);

/// The attribute's value when it is one of `choices`; else FM3011.
std::optional<std::string> read_choice(const xml::Node& node, std::string_view name,
                                       const std::vector<std::string>& choices, Diagnostics& diagnostics);

/// The value of an attribute, empty when it is absent.
std::string_view value_of(const xml::Node& node, std::string_view name);

}  // namespace finemote::gen
