// What a report is made of: results with their keys, ways of data, frames behind stages.
#include "catch.hpp"
#include "generator/report/base64.hpp"
#include "generator/report/data_block.hpp"
#include "generator/report/frames.hpp"
#include "generator/report/path.hpp"
#include "generator/report/verdict.hpp"

using namespace finemote::gen;
using namespace finemote::gen::report;

namespace {

timing::Device device(const char* name, std::optional<Rank> parent, Duration period) {
  timing::Device made;
  made.name = name;
  made.parent = parent;
  made.period = period;
  return made;
}

/// leaf 0 below root 1; leaf 2 below root 3, which reads device 0.
timing::Model two_trees() {
  timing::Model model;
  model.devices.push_back(device("leaf", Rank{1}, milliseconds(1)));
  model.devices.push_back(device("root", std::nullopt, milliseconds(1)));
  model.devices.push_back(device("motor", Rank{3}, milliseconds(2)));
  model.devices.push_back(device("arm", std::nullopt, milliseconds(2)));
  model.devices[Rank{3}].reads = {Rank{0}};
  return model;
}

std::vector<std::size_t> numbers(const std::vector<Rank>& ranks) {
  std::vector<std::size_t> all;
  for (const Rank rank : ranks) all.push_back(rank.value());
  return all;
}

timing::Transfer transfer(timing::Transfer::After after, Duration wire) {
  timing::Transfer made;
  made.after = after;
  made.wire = wire;
  return made;
}

}  // namespace

TEST_CASE("a result names its member and holds its exact value") {
  const Json document = Json::parse(R"({"chains":[{"decide_ns":1830001,"wire_ns":null,"load":0.1}]})");
  const Place chain = Place(document, "timing")["chains"][0];
  CHECK(chain["decide_ns"].figure(Unit::time) ==
        R"(<span data-key="timing#/chains/0/decide_ns" data-value="1830001">1.831 ms</span>)");
  CHECK(chain["wire_ns"].cell(Unit::time) == R"(<td data-key="timing#/chains/0/wire_ns" data-value="null">–</td>)");
  CHECK(chain["load"].figure(Unit::share) ==
        R"(<span data-key="timing#/chains/0/load" data-value="0.1">10.0 %</span>)");
  CHECK(chain["none"][3].figure(Unit::time) == "<span>–</span>");
  CHECK(shown(Json(1234567), Unit::count) == "1\u202f234\u202f567");
  CHECK(shown(Json(-1234), Unit::count) == "-1\u202f234");
  CHECK(shown(Json(-123), Unit::count) == "-123");
}

TEST_CASE("data go up to the root, over reads into another tree, and down") {
  const timing::Model model = two_trees();
  const Path own = path_of(model, Rank{0}, Rank{0});
  CHECK(numbers(own.up) == std::vector<std::size_t>{0, 1});
  CHECK(numbers(own.down) == std::vector<std::size_t>{1, 0});
  const Path other = path_of(model, Rank{0}, Rank{2});
  CHECK(numbers(other.up) == std::vector<std::size_t>{0, 3});
  CHECK(numbers(other.down) == std::vector<std::size_t>{3, 2});
  CHECK(path_of(model, Rank{2}, Rank{0}).up.empty());
}

TEST_CASE("frames follow the stages that ask for them, one at a time, shorter periods first") {
  timing::Model model = two_trees();
  model.buses.push_back({});
  using After = timing::Transfer::After;
  model.devices[Rank{0}].transfers = {transfer(After::update, microseconds(50))};
  model.devices[Rank{2}].transfers = {transfer(After::update, microseconds(80))};
  model.devices[Rank{3}].transfers = {transfer(After::autonomous, microseconds(10))};
  Timeline timeline;
  timeline.length = milliseconds(2);
  const auto stage = [&](std::size_t rank, int end) {
    timeline.stages.push_back({Rank{rank}, false, microseconds(end - 5), microseconds(end)});
  };
  stage(2, 100), stage(2, 110), stage(0, 120);
  const auto frames = frames_of(model, timeline);
  REQUIRE(frames.size() == 4);
  const auto is = [&](std::size_t i, std::size_t rank, int begin, int end) {
    return frames[i].device == Rank{rank} && frames[i].begin == microseconds(begin) &&
           frames[i].end == microseconds(end);
  };
  CHECK(is(0, 3, 0, 10));
  CHECK_FALSE(frames[0].is_asked_for);
  CHECK(is(1, 2, 100, 180));
  CHECK(is(2, 0, 180, 230));  // asked for last, of the shortest period
  CHECK(is(3, 2, 230, 310));
}

TEST_CASE("hashes are written as a policy has them") {
  CHECK(base64_of_hex("") == "");
  CHECK(base64_of_hex("66") == "Zg==");
  CHECK(base64_of_hex("666f") == "Zm8=");
  CHECK(base64_of_hex("666f6f") == "Zm9v");
  CHECK(base64_of_hex("fbff") == "+/8=");
}

TEST_CASE("nothing in the data ends the element that holds them") {
  CHECK(script_text(Json("</script><!--")) == "\"\\u003c/script>\\u003c!--\"");
}

TEST_CASE("the verdict is what the documents say") {
  Documents documents;
  const auto verdict = [&](const char* timing, const char* run = "null") {
    documents.timing = Json::parse(timing);
    documents.run = Json::parse(run);
    return verdict_of(documents, "r");
  };
  CHECK(verdict(R"({"schedulable":true,"requirements":[]})").text == "r keeps every deadline");
  CHECK(verdict(R"({"schedulable":true,"requirements":[{"ok":true}]})").is_good);
  CHECK(verdict(R"({"schedulable":true,"requirements":[{"ok":true},{"ok":false}]})").text ==
        "r keeps every deadline, but fails 1 of 2 requirements");
  CHECK(verdict(R"({"schedulable":false,"profile":"tight","tight":{"buckets":[{"period_ns":1000000,"ok":true},)"
                R"({"period_ns":2000000,"ok":false}]}})")
            .text == "r can miss a deadline: devices every 2 ms");
  const char* good = R"({"schedulable":true,"requirements":[]})";
  CHECK_FALSE(verdict(good, R"({"chains":[{"wire":{"judged":"broken"}}]})").is_good);
  CHECK_FALSE(verdict(good, R"({"overruns":1})").is_good);
  CHECK(verdict(good, R"({"overruns":0,"chains":5,"responses":[3]})").is_good);
}
