// The image check on real images: what holds, and each broken promise.
#include <fstream>
#include <iterator>
#include <numeric>

#include "catch.hpp"
#include "generator/diagnostic/render.hpp"
#include "generator/image/check.hpp"
#include "generator/image/sizes.hpp"

namespace {

using namespace finemote::gen;

struct Checked {
  ImageSizes sizes;
  StackBound stack;
  std::string findings;
};

Checked check(const std::string& name) {
  Diagnostics diagnostics;
  const auto image = read_image(FINEMOTE_IMAGES "/" + name + ".elf", diagnostics);
  REQUIRE(image);
  Checked checked{measure_image(*image), worst_case_stack(*image, diagnostics), {}};
  check_image(*image, checked.stack, {}, diagnostics);
  checked.findings = render_text(diagnostics, false);
  return checked;
}

std::string findings_of(const std::string& name) { return check(name).findings; }

}  // namespace

TEST_CASE("a constant-initialised robot keeps every promise: no code before main, no heap, a bounded stack") {
  const Checked sample = check("sample");
  CHECK(sample.findings.empty());
  CHECK(sample.stack.known);
  CHECK(sample.sizes.flash > 3000);
  CHECK(sample.sizes.flash < 12 * 1024);
  CHECK(sample.sizes.stack_reserved == 4096);
  // Thread, two buckets, release: no bus interrupts.
  REQUIRE(sample.stack.levels.size() == 4);
  CHECK(sample.stack.levels[0].name == "thread");
  CHECK(sample.stack.levels[0].path.front() == "finemote_reset");
  CHECK(sample.stack.levels[1].name == "bucket on line 49");
  CHECK(sample.stack.levels[2].name == "bucket on line 48");
  CHECK(sample.stack.levels[3].name == "release");
  std::uint32_t sum = 0;
  for (const StackLevel& level : sample.stack.levels) sum += level.bytes + level.frame;
  CHECK(sample.stack.bytes == sum);
  CHECK(sample.stack.bytes > 3 * kExceptionFrame);
  CHECK(sample.stack.bytes < 1500);
}

TEST_CASE("every broken promise is found and named") {
  using Catch::Matchers::Contains;
  CHECK_THAT(findings_of("broken_heap"), Contains("FM6102") && Contains("malloc") && Contains("_sbrk"));
  CHECK_THAT(findings_of("broken_recursion"),
             Contains("error[FM6104]: '(anonymous namespace)::even(int)' calls itself"));
  CHECK_THAT(findings_of("broken_pointer"), Contains("error[FM6105]: 'finemote_line_48' calls through a pointer"));
  CHECK_THAT(findings_of("broken_array"),
             Contains("error[FM6106]: in") && Contains("changes the stack by an unknown amount"));
  CHECK_THAT(findings_of("broken_constructor"), Contains("error[FM6103]: 1 constructors run before main"));
  CHECK_THAT(findings_of("broken_stack"), Contains("error[FM6107]: the stack needs") && Contains("4096 are reserved"));
}

TEST_CASE("a file that is no image is an error, however it is cut") {
  std::ifstream stream(FINEMOTE_IMAGES "/sample.elf", std::ios::binary);
  const std::string whole((std::istreambuf_iterator<char>(stream)), std::istreambuf_iterator<char>());
  REQUIRE(whole.size() > 10'000);
  const std::string cut = FINEMOTE_IMAGES "/cut.elf";
  for (std::size_t size : {0U, 3U, 51U, 52U, 1000U, 10'000U}) {
    std::ofstream(cut, std::ios::binary | std::ios::trunc).write(whole.data(), static_cast<std::streamsize>(size));
    Diagnostics diagnostics;
    CHECK_FALSE(read_image(cut, diagnostics));
    CHECK(diagnostics.has_errors());
  }
  Diagnostics diagnostics;
  CHECK_FALSE(read_image(FINEMOTE_IMAGES "/there is no such file", diagnostics));
  CHECK(diagnostics.has_errors());
}

TEST_CASE("an image with disturbed bytes is read without harm") {
  std::ifstream stream(FINEMOTE_IMAGES "/sample.elf", std::ios::binary);
  const std::string whole((std::istreambuf_iterator<char>(stream)), std::istreambuf_iterator<char>());
  const std::string path = FINEMOTE_IMAGES "/disturbed.elf";
  std::uint32_t random = 1;
  const auto next = [&random] { return random = random * 1664525U + 1013904223U; };
  for (int round = 0; round < 60; ++round) {
    std::string bytes = whole;
    // Half of the iterations disturb the headers at both ends, half anything.
    for (int i = 0; i < 40; ++i) {
      const std::size_t place = round % 2 == 0 ? bytes.size() - 1 - next() % 1500 : next() % bytes.size();
      bytes[place] = static_cast<char>(next() >> 24);
    }
    std::ofstream(path, std::ios::binary | std::ios::trunc)
        .write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    Diagnostics diagnostics;
    const auto image = read_image(path, diagnostics);
    if (!image) continue;
    const StackBound stack = worst_case_stack(*image, diagnostics);
    check_image(*image, stack, {}, diagnostics);
  }
  SUCCEED("no crash, no endless loop");
}
