// Times are Durations: no header of the generator has a number whose name has to say that it counts nanoseconds.
#include <algorithm>
#include <filesystem>
#include <iterator>

#include "catch.hpp"
#include "source_dir.hpp"
#include "tests/read.hpp"
#include "tests/structure/tokens.hpp"

namespace fs = std::filesystem;
using namespace finemote::test;

namespace {

/// A name that ends in _ns on purpose.
struct Exception {
  std::string_view file, name, reason;
};
constexpr Exception kExceptions[] = {
    {"run/statistics.hpp", "mean_ns", "a mean has fractions of a nanosecond"},
    {"run/statistics.hpp", "sd_ns", "so has a standard deviation"},
    {"descriptor/param.hpp", "time_ns", "no time but the unit of a param, like frequency_hz"},
};

struct Finding {
  std::string file, name;
  int line;
};

bool counts_nanoseconds(const std::string& name) {
  constexpr std::string_view kSuffix = "_ns";
  return name.size() > kSuffix.size() && name.compare(name.size() - kSuffix.size(), kSuffix.size(), kSuffix) == 0;
}

std::vector<Finding> counts_in_headers() {
  const fs::path generator = fs::path(finemote::test::source_dir()) / "generator";
  std::vector<Finding> findings;
  for (const auto& entry : fs::recursive_directory_iterator(generator)) {
    if (entry.path().extension() != ".hpp") continue;
    const std::string file = entry.path().lexically_relative(generator).generic_string();
    for (const Token& token : tokens_of(read(entry.path()))) {
      if (counts_nanoseconds(token.text)) findings.push_back({file, token.text, token.line});
    }
  }
  return findings;
}

bool excepts(const Exception& entry, const Finding& finding) {
  return entry.file == finding.file && entry.name == finding.name;
}

}  // namespace

TEST_CASE("the headers of the generator keep times in Duration, which says the unit") {
  const std::vector<Finding> findings = counts_in_headers();
  for (const Finding& finding : findings) {
    const auto holds = [&](const Exception& entry) { return excepts(entry, finding); };
    if (std::any_of(std::begin(kExceptions), std::end(kExceptions), holds)) continue;
    FAIL_CHECK("generator/" << finding.file << ":" << finding.line << ": '" << finding.name
                            << "': make it a Duration (generator/units/duration.hpp), which is .ns() where it leaves "
                               "the program");
  }
  for (const Exception& entry : kExceptions) {
    const auto is_it = [&](const Finding& finding) { return excepts(entry, finding); };
    if (std::none_of(findings.begin(), findings.end(), is_it)) FAIL_CHECK(entry.name << " needs no exception any more");
  }
}
