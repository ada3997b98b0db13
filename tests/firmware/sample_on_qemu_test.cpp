// The sample robot as Cortex-M4 firmware: the same order of stages as on the host, at nearly the same times.
#include <cstdlib>

#include "catch.hpp"
#include "finemote/host.hpp"
#include "firmware/qemu.hpp"

namespace {

using finemote::test::Run;
using finemote::test::run_on_qemu;

constexpr finemote::Duration kDuration = 100 * finemote::kMillisecond;

}  // namespace

TEST_CASE("firmware on QEMU runs the stages in the order of the host board") {
  finemote::host::reset();
  REQUIRE(finemote::host::run(kDuration));
  const auto& host = finemote::host::events();
  const Run run = run_on_qemu("sample");
  INFO(run.text);
  REQUIRE(run.status == 0);
  REQUIRE(run.events.size() == host.size());
  for (std::size_t i = 0; i < host.size(); ++i) {
    INFO("event " << i);
    REQUIRE(run.events[i].stage == host[i].stage);
    REQUIRE(run.events[i].end == host[i].end);
    // What the host does not model: the cost of releases, entries, the trace itself.
    CHECK(std::abs(run.events[i].ns - host[i].at) < 30 * finemote::kMicrosecond);
  }
  CHECK(run.text.find("\nO 0 0\nO 1 0\n") != std::string::npos);
}

TEST_CASE("releases on QEMU do not drift") {
  const Run run = run_on_qemu("sample");
  REQUIRE(run.status == 0);
  // The first stage of the fast bucket begins at the same distance from every release at which both buckets are due;
  // the first two releases take note of jobs completed for the first time.
  std::int64_t distance = -1;
  unsigned compared = 0;
  for (const auto& event : run.events) {
    if (event.stage != 0 || event.end || event.ns < 15'000'000 || event.ns % 10'000'000 > 4'000'000) continue;
    if (distance < 0) distance = event.ns % 10'000'000;
    CHECK(std::abs(event.ns % 10'000'000 - distance) <= 8);  // one instruction
    ++compared;
  }
  CHECK(compared == 8);
}

TEST_CASE("two runs of an image on QEMU write the same bytes") {
  const Run first = run_on_qemu("sample");
  const Run second = run_on_qemu("sample");
  REQUIRE(first.status == 0);
  CHECK(first.text == second.text);
}
