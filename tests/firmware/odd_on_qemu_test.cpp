// Releases that are planned one by one, over more than one wrap of the release timer: order and times as on the host.
#include <cstdlib>

#include "catch.hpp"
#include "finemote/host.hpp"
#include "firmware/qemu.hpp"

TEST_CASE("a schedule without a short hyperperiod runs on QEMU as on the host") {
  finemote::host::reset();
  REQUIRE(finemote::host::run(2 * finemote::kSecond));
  const auto& host = finemote::host::events();
  const auto run = finemote::test::run_on_qemu("odd");
  REQUIRE(run.status == 0);
  CHECK(run.text.find("\nO 0 0\nO 1 0\nO 2 0\nO 3 0\n") != std::string::npos);
  // Jobs under way at the end may end on one side only.
  REQUIRE(run.events.size() + 4 > host.size());
  REQUIRE(host.size() + 4 > run.events.size());
  for (std::size_t i = 0; i + 4 < host.size(); ++i) {
    INFO("event " << i << " at " << host[i].at << " ns on the host, " << run.events[i].ns << " ns on QEMU");
    REQUIRE(run.events[i].stage == host[i].stage);
    REQUIRE(run.events[i].end == host[i].end);
    REQUIRE(std::abs(run.events[i].ns - host[i].at) < 32 * finemote::kMicrosecond);
  }
}
