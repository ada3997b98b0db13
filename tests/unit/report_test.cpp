// What a report is made of: results with their keys, ways of data, frames behind stages.
#include "catch.hpp"
#include "generator/report/base64.hpp"
#include "generator/report/changes.hpp"
#include "generator/report/data_block.hpp"
#include "generator/report/frames.hpp"
#include "generator/report/over_time.hpp"
#include "generator/report/path.hpp"
#include "generator/report/plot.hpp"
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
  CHECK(shown(Json(14409034), Unit::time) == "14.41 ms");
  CHECK(shown(Json(14409934), Unit::room) == "14.409 ms");
  CHECK(shown(Json(999), Unit::room) == "999 ns");
  CHECK(shown(Json(-1000001), Unit::room) == "-1.001 ms");
  CHECK_FALSE(shown(Json(std::numeric_limits<std::int64_t>::min()), Unit::room).empty());
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
  using Look = Verdict::Look;
  CHECK(verdict(R"({"schedulable":true,"requirements":[]})").text == "r meets every deadline");
  CHECK(verdict(R"({"schedulable":true,"requirements":[{"ok":true}]})").look == Look::good);
  CHECK(verdict(R"({"schedulable":true,"requirements":[{"ok":true},{"ok":false}]})").text ==
        "r meets every deadline, but fails 1 of 2 requirements");
  CHECK(verdict(R"({"schedulable":false,"profile":"tight","tight":{"buckets":[{"period_ns":1000000,"ok":true},)"
                R"({"period_ns":2000000,"ok":false}]}})")
            .text == "r can miss a deadline: devices every 2 ms");
  const char* good = R"({"schedulable":true,"requirements":[]})";
  const char* bad_runs[] = {
      R"({"chains":[{"wire":{"judged":"broken"}}]})",
      R"({"claims":[{"judged":"broken"}]})",
      R"({"overruns":1})",
      R"({"resets":1})",
      R"({"order":{"mistake":"imu.update came first"}})",
      R"({"stages":[{"device":"imu","stage":"update","own_max_ns":11,"wcet_ns":10}]})",
      R"({"unexplained_faults":[{"module":"can","code":3,"count":1}]})",
      R"({"monitor":[{"response_violations":0,"age_violations":1}]})",
      R"({"expectations":[{"ok":true},{"ok":false}]})",
      R"({"chains":[{"decide":{"judged":"no-sample"}}]})",
  };
  for (const char* run : bad_runs) {
    INFO(run);
    CHECK(verdict(good, run).look == Look::bad);
  }
  CHECK(verdict(good, bad_runs[5]).text == "r took longer in the run than its analysis was told: imu's update()");
  CHECK(verdict(good, R"({"overruns":0,"chains":5,"responses":[3]})").look == Look::good);
  CHECK(verdict(good, R"({"faults":true,"chains":[{"wire":{"judged":"broken","assumption":"bus-errors"}}]})").look ==
        Look::good);
  const Verdict open = verdict(R"({"schedulable":true,"chains":[{"unbounded":[{"part":"acquire"}]},{}]})");
  CHECK(open.look == Look::open);
  CHECK(open.text == "r meets every deadline, but nothing bounds the age of commands in 1 of 2 chains");
}

TEST_CASE("a report says what kind of execution times it rests on") {
  Documents documents;
  documents.timing = Json::parse(R"({"wcet_labels":[{"label":"static"},{"label":"assumed"},{"label":"static"}]})");
  CHECK(rests_on(documents) == "Execution times: static for 2 devices, assumed for 1.");
  documents.timing = Json::parse("{}");
  CHECK(rests_on(documents).empty());
}

TEST_CASE("ages are compared where the oldest command comes from elsewhere now") {
  const auto chains = [](const char* text) {
    return Json::parse(std::string(R"({"schedulable":true,"chains":[)") + text + "]}");
  };
  Documents documents;
  documents.against = chains(R"({"from":"a","to":"m","end_to_end_ns":1000,"decide_ns":1},)"
                             R"({"from":"imu","to":"m","end_to_end_ns":500,"decide_ns":1},)"
                             R"({"from":"a","to":"n","end_to_end_ns":3000,"decide_ns":1})");
  documents.timing = chains(R"({"from":"b","to":"m","end_to_end_ns":2000,"decide_ns":1},)"
                            R"({"from":"imu","to":"m","end_to_end_ns":500,"decide_ns":1},)"
                            R"({"from":"c","to":"n","end_to_end_ns":null,"decide_ns":1})");
  const std::string text = changes_of(documents);
  CHECK(text.find("<p>2 worse.</p>") != std::string::npos);
  CHECK(text.find("b → m, before a") != std::string::npos);
  CHECK(text.find("c → n, before a") != std::string::npos);
  CHECK(text.find("against#/chains/0/end_to_end_ns") != std::string::npos);
  CHECK(text.find("timing#/chains/0/end_to_end_ns") != std::string::npos);
  CHECK(text.find("imu") == std::string::npos);
}

TEST_CASE("a plot has no text that would not fit") {
  Plot plot{"age", ""};
  plot.is_time = true;
  plot.points = {{2e8, 1e6}, {7e8, 3e6}};
  const std::string picture = drawn(plot);
  CHECK(picture.find("600 ms") != std::string::npos);
  CHECK(picture.find("700 ms") == std::string::npos);
}

TEST_CASE("what is left of a sum that is 0 is shown as 0") {
  CHECK(shown(Json(-3.58129e-19), Unit::number) == "0");
  CHECK(shown(Json(-0.25), Unit::number) == "-0.25");
}

TEST_CASE("a plot lies within its axes, and marks where a value is wanted") {
  Plot plot{"depth & <b>", " data-key=\"k\""};
  for (int i = 0; i <= 10; ++i) plot.points.push_back({i * 1e8, i < 5 ? 0.0 : 1.5});
  plot.bands = {{5e8, 9e8, 1, 2}, {2e9, 3e9, 0, 1}};  // the second one comes later than what is drawn
  const std::string text = drawn(plot);
  CHECK(text.find("aria-label=\"depth &amp; &lt;b&gt;\"") != std::string::npos);
  CHECK(text.find("<path class=\"line\" data-key=\"k\" d=\"M54.0 119.") != std::string::npos);
  CHECK(text.find(">1000 µs<") == std::string::npos);
  CHECK(text.find(">400 ms<") != std::string::npos);
  CHECK(text.find(">0.5</text>") != std::string::npos);
  CHECK(text.find("class=\"wanted\"") == text.rfind("class=\"wanted\""));
  CHECK(text.find("class=\"limit\"") == std::string::npos);
  plot.limit = 3;
  CHECK(drawn(plot).find("class=\"limit\"") != std::string::npos);
}

TEST_CASE("what cannot be drawn is not") {
  Plot plot{"x"};
  CHECK(plot.is_constant());
  CHECK(drawn(plot).empty());
  plot.points = {{0, 1e308}, {1, -1e308}};
  CHECK_FALSE(plot.is_constant());
  CHECK(drawn(plot).empty());
  plot.points = {{5, 2}};
  CHECK_FALSE(drawn(plot).empty());
}

TEST_CASE("of a run over time, counters and what stays are in the table alone") {
  Documents documents;
  documents.timing = Json::parse(R"({"model":{"devices":[{"name":"motor"}]}})");
  CHECK(over_time(documents).empty());
  documents.run = Json::parse(R"({"values":[
    {"part":"motor","value":"frames","unit":"","from_ns":0,"every_ns":1000000,"values":[0,1,2]},
    {"part":"motor","value":"angle","unit":"rad","from_ns":0,"every_ns":1000000,"values":[0,1,2]},
    {"part":"motor","value":"current","unit":"A","from_ns":0,"every_ns":1000000,"values":[1,1,1]},
    {"part":"hull","value":"x","unit":"m","from_ns":0,"every_ns":1000000,"values":[0,null,2]}]})");
  const std::string text = over_time(documents);
  CHECK(text.find("run#/values/0/values\"") == std::string::npos);
  CHECK(text.find("run#/values/2/values\"") == std::string::npos);
  const auto angle = text.find("data-key=\"run#/values/1/values\" data-value=\"[0,1,2]\"");
  const auto hull = text.find("data-key=\"run#/values/3/values\" data-value=\"[0,null,2]\"");
  REQUIRE(angle != std::string::npos);
  CHECK(hull < angle);  // bodies come before what moves them
  CHECK(text.find("How old commands were") == std::string::npos);
}
