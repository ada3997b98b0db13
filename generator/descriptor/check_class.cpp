#include "generator/descriptor/check_class.hpp"

#include <fmt/format.h>

#include "generator/descriptor/cpp_words.hpp"

namespace finemote::gen {

void check_class(const std::string& qualified, const Contradictions& found) {
  for (std::size_t begin = 0; begin < qualified.size();) {
    const std::size_t end = std::min(qualified.find("::", begin), qualified.size());
    const std::string name = qualified.substr(begin, end - begin);
    if (const auto fault = invalid_name(name)) {
      found.add({"class"}, fmt::format("'{}' {}, so no class can have it in its name", name, *fault));
      return;
    }
    begin = end + 2;
  }
}

}  // namespace finemote::gen
