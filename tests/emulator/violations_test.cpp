// What happens on the board where an assumption of docs/timing.md does not hold: it is counted, or nobody notices.
#include "catch.hpp"
#include "tests/cli/program.hpp"

using namespace finemote::test;
using Json = nlohmann::json;

namespace {

/// A run of an example in which something happens 20 ms after the first release.
Json run_with(const std::string& robot, const Json& event) {
  const TemporaryFolder folder;
  Json happening = event;
  happening["t_ns"] = 20'000'000;
  const Json scenario = {{"schema", "finemote.scenario/1"}, {"events", Json::array({happening})}};
  write_file(folder.path("scenario.json"), scenario.dump());
  return finemote_json({"run", source_path("examples/" + robot + ".urdf"), "--duration", "200ms", "--scenario",
                        folder.path("scenario.json")});
}

const Json& bus_of(const Json& document, const std::string& name) {
  for (const Json& bus : document["buses"]) {
    if (bus["name"] == name) return bus;
  }
  FAIL("no bus " << name);
  return document;
}

bool counts(const Json& document, const std::string& module, int code) {
  for (const Json& fault : document["fault_counts"]) {
    if (fault["module"] == module && fault["code"] == code) return true;
  }
  return false;
}

}  // namespace

TEST_CASE("declared-nodes: frames of a node that nobody declared fill the bus, and nothing counts them") {
  const Json quiet = finemote_json({"run", source_path("examples/infantry.urdf"), "--duration", "200ms"});
  const Json loud = run_with(
      "infantry", {{"port", "can1"}, {"do", "flood"}, {"identifier", 16}, {"frames", 400}, {"every_ns", 250'000}});
  INFO(loud["fault_counts"].dump());
  CHECK(loud["fault_counts"] == quiet["fault_counts"]);
  REQUIRE(!quiet["buses"].empty());
  for (const Json& bus : quiet["buses"]) {
    const Json& other = bus_of(loud, bus["name"]);
    CHECK(other["errors"] == bus["errors"]);
  }
  CHECK(loud["overruns"] == 0);
}

TEST_CASE("declared-traffic: bytes that nobody declared are counted where the ring cannot keep them") {
  const Json document = run_with("finsrov", {{"port", "usart1"}, {"do", "flood"}, {"bytes", 4000}});
  INFO(document["fault_counts"].dump());
  CHECK(counts(document, "uart", 2));
}

TEST_CASE("bus-errors: frames that are destroyed on the wire are counted") {
  const Json document = run_with("infantry", {{"port", "can1"}, {"do", "disturb"}, {"frames", 3}});
  std::int64_t errors = 0;
  for (const Json& bus : document["buses"]) errors += bus["errors"].get<std::int64_t>();
  CHECK(errors > 0);
}
