// Robots nobody would write, but that are robots: devices copied, moved, renamed, read, given other periods and values.
#pragma once

#include <functional>
#include <random>
#include <string>
#include <vector>

#include "generator/descriptor/device_type.hpp"
#include "generator/xml/node.hpp"

namespace finemote::gen {

/// Changes one robot in a few places at once. Most changes keep what the model asks for (unique names, free channels,
/// params in their range), so that a good part is accepted; one in four does not care.
class StructureMutator {
 public:
  /// The descriptor of a type, or null.
  using FindType = std::function<const DeviceType*(std::string_view)>;

  /// `document` and `find_type` have to live as long as the mutator.
  StructureMutator(const xml::Document& document, const FindType& find_type)
      : document_(document), find_type_(find_type) {}

  /// One mutant as text; its robot's name ends in `_<number>` unless a change hit it. The same `random`, the same text.
  std::string operator()(std::mt19937& random, unsigned number) const;

 private:
  const xml::Document& document_;
  const FindType& find_type_;
};

}  // namespace finemote::gen
