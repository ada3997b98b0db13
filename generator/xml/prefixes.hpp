// The namespace prefixes in force at an element: finds a prefix that nobody declared.
#pragma once

#include <string>
#include <string_view>
#include <unordered_set>
#include <vector>

#include "generator/xml/node.hpp"

namespace finemote::gen::xml {

class Prefixes {
 public:
  /// Enters an element. Returns what is wrong with its names, in expat's words, or an empty text.
  std::string_view enter(const Node& element);
  void leave();

 private:
  [[nodiscard]] bool is_declared(std::string_view prefix) const;
  [[nodiscard]] std::string_view check_name(std::string_view name) const;

  std::vector<std::string> declared_;              // innermost last
  std::unordered_multiset<std::string> in_force_;  // the same
  std::vector<std::size_t> open_sizes_;            // declared_.size() before each open element
};

}  // namespace finemote::gen::xml
