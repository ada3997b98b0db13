#include "emulator/silicon/choice.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <set>
#include <sstream>

#include "emulator/silicon/strictness.hpp"
#include "generator/diagnostic/suggest.hpp"

namespace finemote::emulator {
namespace {

constexpr const char* kStrict = "strict";

std::vector<std::string> all_names() {
  std::vector<std::string> names;
  for (const StrictnessInfo& info : strictnesses()) names.emplace_back(info.name);
  return names;
}

}  // namespace

std::optional<std::vector<std::string>> parse_silicon(const std::string& text, gen::Diagnostics& diagnostics) {
  const std::vector<std::string> known = all_names();
  if (text.empty()) return std::vector<std::string>();
  if (text == kStrict) return known;
  const std::string prefix = std::string(kStrict) + ":";
  if (text.rfind(prefix, 0) != 0 || text == prefix) {
    diagnostics.error(gen::code::usage, {}, fmt::format("there is no silicon '{}'", text))
        .hint("write 'strict', or 'strict:' and names, for example --silicon strict:dma_store,spi_busy");
    return std::nullopt;
  }
  std::set<std::string> asked;
  std::istringstream words(text.substr(prefix.size()));
  for (std::string word; std::getline(words, word, ',');) {
    asked.insert(word);
    if (std::find(known.begin(), known.end(), word) != known.end()) continue;
    diagnostics.error(gen::code::usage, {}, fmt::format("no chip is '{}'", word)).hint(gen::did_you_mean(word, known));
  }
  if (diagnostics.has_errors()) return std::nullopt;
  std::vector<std::string> names;
  std::copy_if(known.begin(), known.end(), std::back_inserter(names),
               [&](const std::string& name) { return asked.count(name) != 0; });
  return names;
}

}  // namespace finemote::emulator
