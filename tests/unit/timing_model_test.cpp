// The strict model reader: every mistake found where it stands, all of them at once.
#include <algorithm>

#include "catch.hpp"
#include "generator/diagnostic/render.hpp"
#include "generator/timing/analyse.hpp"
#include "generator/timing/json.hpp"
#include "generator/timing/read_model.hpp"
#include "generator/timing/reorder.hpp"
#include "unit/duration_literals.hpp"

using namespace finemote::gen;
using namespace finemote::gen::timing;

namespace {

/// The messages of reading `text`, one per line; empty when it is a model.
std::string messages(const std::string& text) {
  Sources sources;
  Diagnostics diagnostics;
  const auto model = read_model(*sources.add({"m.json", "", text}), diagnostics);
  CHECK(model.has_value() != diagnostics.has_errors());
  std::string list;
  for (const Diagnostic& d : diagnostics.in_file_order()) {
    list += std::to_string(d.at.line) + ":" + std::to_string(d.at.column) + " " + code_name(d.code) + " " + d.message +
            "\n";
  }
  return list;
}

std::string device(const std::string& members) {
  return R"({"tick_ns":10,"devices":[{"name":"a","period_ns":20,"update_wcet_ns":1,"handle_wcet_ns":1)" + members +
         "}]}";
}

/// What `text` describes, which is a model.
Model model_of(const std::string& text) {
  Sources sources;
  Diagnostics diagnostics;
  auto model = read_model(*sources.add({"m.json", "", text}), diagnostics);
  INFO(render_text(diagnostics, false));
  REQUIRE(model);
  return std::move(*model);
}

}  // namespace

TEST_CASE("a model needs no buses and no parents") {
  CHECK(messages(device("")) == "");
  CHECK(messages("\xEF\xBB\xBF" + device("")) == "");
  CHECK(messages(R"({"name":"x","description":"y","expected":{},"model":)" + device("") + "}") == "");
}

TEST_CASE("what is not JSON is refused at its place") {
  CHECK(messages("") == "1:1 FM4001 unexpected end of file, expected a value\n");
  CHECK(messages("{\n  \"tick_ns\" 1}") == "2:13 FM4001 found '1' where ':' is expected\n");
  CHECK(messages("{} x") == "1:4 FM4001 unexpected text after the end of the document\n");
  CHECK(messages("{\"tick_ns\":01}") == "1:13 FM4001 a number has no leading zero\n");
  CHECK(messages(std::string(100'000, '[')) == "1:65 FM4001 arrays and objects are nested deeper than 64\n");
  CHECK(messages("[1]") == "1:1 FM4005 the root is an array, not an object\n");
}

TEST_CASE("every invalid model of the case format is refused") {
  CHECK(messages(R"({"tick_ns":1,"devices":[]})") == "1:24 FM4013 the model has no device\n");
  CHECK(messages(R"({"tick_ns":1})") == "1:1 FM4004 the model has no 'devices'\n");
  CHECK(messages(device(R"(,"colour":1)")) == "1:91 FM4003 a device has no member 'colour'\n");
  CHECK(messages(device(R"(,"name":"b")")) == "1:91 FM4002 member 'name' is repeated\n");
  CHECK(messages(device(R"(,"parent":"b")")) == "1:100 FM4008 there is no device 'b'\n");
  CHECK(messages(device(R"(,"parent":"a")")) == "1:100 FM4008 device 'a' is its own parent\n");
  CHECK(messages(device(R"(,"parent":1)")) == "1:100 FM4005 'parent' is a number, not a string or null\n");
  CHECK(messages(R"({"tick_ns":0,"devices":[{"name":"","period_ns":15,"update_wcet_ns":-1,"handle_wcet_ns":1.0}]})") ==
        "1:12 FM4006 'tick_ns' is 0, outside 1 to 9223372036854775807\n"
        "1:33 FM4007 'name' of device is empty\n"
        "1:68 FM4006 'update_wcet_ns' is -1, outside 0 to 9223372036854775807\n"
        "1:88 FM4005 'handle_wcet_ns' is 1.0, not an integer\n");
  CHECK(
      messages(
          R"({"tick_ns":1e6,"devices":[{"name":3,"period_ns":9223372036854775808,"update_wcet_ns":"1","handle_wcet_ns":true}]})") ==
      "1:12 FM4005 'tick_ns' is 1e6, not an integer\n"
      "1:35 FM4005 'name' is a number, not a string\n"
      "1:49 FM4006 'period_ns' is 9223372036854775808, outside 1 to 9223372036854775807\n"
      "1:86 FM4005 'update_wcet_ns' is a string, not an integer\n"
      "1:107 FM4005 'handle_wcet_ns' is true or false, not an integer\n");
}

TEST_CASE("order, names, periods and frames are checked") {
  const std::string a = R"({"name":"a","parent":"b","period_ns":20,"update_wcet_ns":1,"handle_wcet_ns":1})";
  const std::string b = R"({"name":"b","period_ns":20,"update_wcet_ns":1,"handle_wcet_ns":1})";
  const auto model = [](const std::string& devices, const std::string& more = "") {
    return R"({"tick_ns":10,)" + more + "\"devices\":[\n" + devices + "]}";
  };
  CHECK(messages(model(a + ",\n" + b)) == "");
  CHECK(messages(model(b + ",\n" + a)) == "3:22 FM4008 parent 'b' of device 'a' is registered before it\n");
  CHECK(messages(model(b + ",\n" + b)) == "3:9 FM4007 device 'b' is named twice\n");
  CHECK(messages(model(R"({"name":"c","period_ns":25,"update_wcet_ns":1,"handle_wcet_ns":1})")) ==
        "2:25 FM4009 the period of device 'c' is not a multiple of the tick of 10 ns\n");
  CHECK(messages(model(b, R"("buses":[{"name":"x","baud_bps":2000000000,"min_frame_bits":1,"wcet_ns":1}],)")) ==
        "1:75 FM4012 the frame time of bus 'x' is below 1 ns\n");
  CHECK(messages(model(b, R"("buses":[{"name":"x","baud_bps":1,"min_frame_bits":9223372037,"wcet_ns":1}],)")) ==
        "1:66 FM4010 the frame time does not fit signed 64 bits\n");
  CHECK(messages(model(R"({"name":"r","period_ns":20,"update_wcet_ns":1,"handle_wcet_ns":1,"reads":["r"]})")) ==
        "2:1 FM4014 device 'r' reads data made from its own\n");
}

TEST_CASE("what does not fit 64 bits is an error, never a number") {
  const auto outcome = [](const std::string& devices) {
    Sources sources;
    Diagnostics diagnostics;
    const auto model =
        read_model(*sources.add({"m.json", "", R"({"tick_ns":1,"devices":[)" + devices + "]}"}), diagnostics);
    REQUIRE(model);
    const auto timing = analyse(*model, {}, diagnostics);
    if (timing) return std::string("analysed");
    return code_name(diagnostics.in_file_order().front().code);
  };
  const auto one = [](const std::string& name, const std::string& period, const std::string& wcet) {
    return R"({"name":")" + name + R"(","period_ns":)" + period + R"(,"update_wcet_ns":)" + wcet +
           R"(,"handle_wcet_ns":1})";
  };
  CHECK(outcome(one("a", "9223372036854775807", "1")) == "analysed");
  CHECK(outcome(one("a", "9223372036854775807", "9223372036854775807")) == "FM4010");
  CHECK(outcome(one("a", "4294967291", "1") + "," + one("b", "4294967279", "1")) == "analysed");
  CHECK(outcome(one("a", "1000003", "1") + "," + one("b", "1000033", "1")) == "analysed");
}

TEST_CASE("a chain between trees that share no data is refused") {
  Sources sources;
  Diagnostics diagnostics;
  const auto model = read_model(
      *sources.add({"m.json", "",
                    R"({"tick_ns":1,"devices":[{"name":"a","period_ns":9,"update_wcet_ns":1,"handle_wcet_ns":1},
          {"name":"b","period_ns":9,"update_wcet_ns":1,"handle_wcet_ns":1}]})"}),
      diagnostics);
  REQUIRE(model);
  AnalysisRequest request;
  request.chains = {{Rank{0}, Rank{1}}};
  CHECK_FALSE(analyse(*model, request, diagnostics));
  REQUIRE(diagnostics.size() == 1);
  CHECK(diagnostics.in_file_order().front().message == "no data leads from 'a' to 'b'");
}

TEST_CASE("a window between two devices of a bucket holds at every release, also where there are too many to look at") {
  // Both periods repeat after a million releases; only some of the slower bucket's jobs are preempted.
  Model model;
  model.devices.resize(3);
  const auto set = [&](Rank d, const char* name, Duration period, Duration wcet) {
    model.devices[d].name = name;
    model.devices[d].period = period;
    model.devices[d].update_wcet = model.devices[d].handle_wcet = wcet;
  };
  set(Rank{0}, "fast", 1'000'003_ns, 1'000_ns);
  set(Rank{1}, "leaf", 1'999'993_ns, 10_ns);
  set(Rank{2}, "root", 1'999'993_ns, 10_ns);
  model.devices[Rank{1}].parent = Rank{2};
  AnalysisRequest request;
  request.chains = {{Rank{1}, Rank{1}}};
  Diagnostics diagnostics;
  const auto timing = analyse(model, request, diagnostics);
  REQUIRE(timing);
  for (const ChainResult& chain : timing->chains) {
    if (chain.to == Rank{1}) CHECK(*chain.decide == 2'040_ns);
  }
  CHECK(*timing->tight.devices[Rank{1}].window == 2'040_ns);
}

TEST_CASE("between jobs that are released together only what is released behind them comes in between") {
  const auto decide_with = [](const std::string& others, const std::string& costs) {
    const std::string text = R"({"tick_ns":1000000,)" + costs + R"("buses":[],"devices":[)" + others + R"(
        {"name":"fast","parent":"slow","period_ns":5000000,"update_wcet_ns":100000,"handle_wcet_ns":20000},
        {"name":"slow","parent":null,"period_ns":10000000,"update_wcet_ns":50000,"handle_wcet_ns":50000}]})";
    const Model model = model_of(text);
    Diagnostics diagnostics;
    const Rank slow(model.devices.size() - 1), fast(model.devices.size() - 2);
    AnalysisRequest request;
    request.chains = {{fast, slow}};
    const Timing timing = analyse(model, request, diagnostics).value();
    const auto chain = std::find_if(timing.chains.begin(), timing.chains.end(),
                                    [&](const ChainResult& c) { return c.from == fast && c.to == slow; });
    REQUIRE(chain != timing.chains.end());
    return chain->decide->ns();
  };
  const std::string target = R"("costs":{},)";
  const std::string urgent =
      R"({"name":"u","parent":null,"period_ns":4000000,"update_wcet_ns":1000000,"handle_wcet_ns":0},)";
  const std::string between =
      R"({"name":"b","parent":null,"period_ns":7000000,"update_wcet_ns":1000000,"handle_wcet_ns":0},)";
  const std::string long_one =
      R"({"name":"u","parent":null,"period_ns":4000000,"update_wcet_ns":3800000,"handle_wcet_ns":0},)";
  const std::int64_t own = 220'000, ms = 1'000'000;
  CHECK(decide_with("", target) == own);
  CHECK(decide_with(urgent, target) == own);   // released with both it is over, and not again until they are
  CHECK(decide_with(urgent, "") == own + ms);  // profile tight says nothing of such windows
  CHECK(decide_with(between, target) == own + ms);
  CHECK(decide_with(urgent + between, target) == own + ms);
  CHECK(decide_with(long_one, target) ==
        own + 3'920'000);  // released again before all is done, and so is the faster one
}

TEST_CASE("a budget may count interrupts that come in one of so many periods") {
  const std::string text = R"({"tick_ns":10,"costs":{"masked_ns":1},"buses":[{"name":"b","baud_bps":1000000000,
      "min_frame_bits":10,"wcet_ns":2,"sources":[{"name":"s","wcet_ns":2,"min_interval_ns":10,"budgets":[
      {"device":"a","count":3},{"device":"a","count":7,"every":50}]}]}],
      "devices":[{"name":"a","period_ns":1000,"update_wcet_ns":100,"handle_wcet_ns":100}]})";
  Sources sources;
  Diagnostics diagnostics;
  const auto model = read_model(*sources.add({"m.json", "", text}), diagnostics);
  REQUIRE(model);
  const auto timing = analyse(*model, {}, diagnostics);
  REQUIRE(timing);
  // In a window of two periods: three in each of them, and the seven once.
  CHECK(*timing->target->devices[Rank{0}].r_minus == nanoseconds(200 + 1 + (2 * 3 + 7) * 2));
  CHECK(
      messages(R"({"tick_ns":10,"buses":[{"name":"b","baud_bps":1,"min_frame_bits":1,"wcet_ns":0,"sources":[{"name":"s",
"wcet_ns":0,"min_interval_ns":1,"budgets":[{"device":"a","count":1,"every":0}]}]}],"devices":[{"name":"a","period_ns":10,
"update_wcet_ns":1,"handle_wcet_ns":1}]})") != "");
}

TEST_CASE("bounds of profile target are true time, of a board as slow as it may be; deadlines are by its own clock") {
  const auto timing_with = [](const std::string& clock) {
    const std::string text = R"({"tick_ns":1000000,)" + clock + R"("buses":[],"devices":[
        {"name":"leaf","parent":"root","period_ns":1000000,"update_wcet_ns":300000,"handle_wcet_ns":200000,
         "acquisition":{"interval_ns":2000000}},
        {"name":"root","parent":null,"period_ns":1000000,"update_wcet_ns":300000,"handle_wcet_ns":200000}]})";
    const Model model = model_of(text);
    Diagnostics diagnostics;
    AnalysisRequest request;
    request.chains = {{Rank{0}, Rank{0}}};
    return analyse(model, request, diagnostics).value();
  };
  const Timing exact = timing_with(R"("costs":{},)"), slow = timing_with(R"("clock_ppm":50,)");
  REQUIRE(slow.target);
  CHECK(slow.schedulable);  // full, and yet in time
  CHECK(*slow.target->devices[Rank{0}].r_minus == nanoseconds(1'000'051));
  CHECK(*slow.target->buckets[0].response == nanoseconds(1'000'051));
  CHECK(*slow.target->devices[Rank{0}].window == nanoseconds(1'000'051));
  CHECK(*slow.target->trees[0].latency == nanoseconds(1'000'051));
  CHECK(*slow.tight.devices[Rank{0}].r_minus == 1_ms);
  REQUIRE(slow.chains.size() == 1);
  CHECK(*slow.chains[0].acquire == nanoseconds(2'000'101));
  CHECK(*slow.chains[0].decide == nanoseconds(1'000'051));
  CHECK(*slow.chains[0].end_to_end == *slow.chains[0].acquire + *slow.chains[0].decide);
  CHECK(*exact.chains[0].acquire == 2_ms);
  CHECK(model_json(slow.model)["clock_ppm"] == 50);
  CHECK_FALSE(model_json(exact.model).contains("clock_ppm"));
}

TEST_CASE("a clock that is off by more than half is none") {
  for (const std::string ppm : {"500001", "-1", "1.5"}) {
    CHECK(messages(R"({"tick_ns":10,"clock_ppm":)" + ppm + R"(,"buses":[],"devices":[{"name":"a","period_ns":10,
"update_wcet_ns":1,"handle_wcet_ns":1}]})") != "");
  }
}

namespace {

/// Three parts that report themselves on a bus that arbitrates, and one frame or two of commands for them.
std::string can_model(bool known, const std::string& commands, int wire) {
  const auto part = [&](int n) {
    const std::string id = known ? R"(,"identifier":)" + std::to_string(0x200 + n) : "";
    return R"({"name":"m)" + std::to_string(n) + R"(","period_ns":1000,"update_wcet_ns":0,"handle_wcet_ns":0,
        "takes_command":true,"acquisition":{"interval_ns":1000},
        "transfers":[{"bus":"can","wire_ns":135,"after":"autonomous","interrupts":0)" +
           id + "}]}";
  };
  return R"({"tick_ns":1000,"buses":[{"name":"can","baud_bps":1000000000,"min_frame_bits":47,"wcet_ns":0,"arbitrated":true,
      "sources":[]}],"flushes":[{"period_ns":1000,"wcet_ns":0,"bus":"can","interrupts":0,"wire_ns":)" +
         std::to_string(wire) + (known ? R"(,"identifiers":)" + commands : "") +
         R"(,"devices":["m1","m3"]}],"devices":[)" + part(1) + "," + part(2) + "," + part(3) + "]}";
}

struct OnCan {
  Duration report, command;
};

/// The chain that begins and ends at a device of a model.
ChainResult chain_of(const std::string& text, Rank device) {
  Sources sources;
  Diagnostics diagnostics;
  const auto model = read_model(*sources.add({"m.json", "", text}), diagnostics);
  INFO(render_text(diagnostics, false));
  REQUIRE(model);
  AnalysisRequest request;
  request.chains = {{device, device}};
  const auto timing = analyse(*model, request, diagnostics);
  REQUIRE(timing);
  const auto found = std::find_if(timing->chains.begin(), timing->chains.end(),
                                  [&](const ChainResult& c) { return c.from == device && c.to == device; });
  REQUIRE(found != timing->chains.end());
  return *found;
}

OnCan on_can(const std::string& text, Rank part) {
  const ChainResult chain = chain_of(text, part);
  REQUIRE(chain.acquire);
  REQUIRE(chain.wire);
  return {*chain.acquire - 1000_ns, *chain.wire};
}

}  // namespace

TEST_CASE("identifiers say which frames go first on a bus that arbitrates") {
  constexpr Duration kBit = 1_ns;  // both frames wait for the same one to begin
  // One frame that has begun, then those with smaller identifiers, then its own.
  const std::string one = can_model(true, "[512]", 135);
  CHECK(on_can(one, Rank{0}).report == 3 * 135_ns + kBit);
  CHECK(on_can(one, Rank{2}).report == 4 * 135_ns + kBit);  // nothing yields to it
  CHECK(on_can(one, Rank{0}).command == 2 * 135_ns);
  // Of two frames of commands the second may wait for the first; both go before every report.
  const std::string two = can_model(true, "[511,512]", 270);
  CHECK(on_can(two, Rank{0}).report == 4 * 135_ns + kBit);
  CHECK(on_can(two, Rank{2}).report == 5 * 135_ns + kBit);
  CHECK(on_can(two, Rank{0}).command == 3 * 135_ns);
  // Unknown ones may all be more urgent.
  const std::string unknown = can_model(false, "", 135);
  CHECK(on_can(unknown, Rank{0}).report == 4 * 135_ns + kBit);
  CHECK(on_can(unknown, Rank{0}).command == 4 * 135_ns);
}

TEST_CASE("a frame is there with its last bit: its routine has run before an update() begins") {
  const auto acquire = [](int routine) {
    const std::string text =
        R"({"tick_ns":1000,"costs":{"masked_ns":7},"buses":[{"name":"can","baud_bps":1000000000,"min_frame_bits":47,"wcet_ns":)" +
        std::to_string(routine) + R"(,"arbitrated":true}],"devices":[{"name":"m","period_ns":1000,"update_wcet_ns":10,
        "handle_wcet_ns":10,"acquisition":{"interval_ns":1000},"transfers":[{"bus":"can","wire_ns":135,
        "after":"autonomous"}]}]})";
    return chain_of(text, Rank{0}).acquire.value();
  };
  CHECK(acquire(1) == 1000_ns + 135_ns + 1_ns + 7_ns);  // a bit; 7: a masked section may hold the routine back
  CHECK(acquire(9) == acquire(1));
}

TEST_CASE("where a frame may still be in its mailbox when the next one comes, no frame of the bus is sure of one") {
  const auto wire = [](int slow_work) {
    const std::string text =
        R"({"tick_ns":1000,"buses":[{"name":"can","baud_bps":1000000000,"min_frame_bits":47,"wcet_ns":0,"arbitrated":true,
        "sources":[]}],"flushes":[
        {"period_ns":1000,"wcet_ns":0,"bus":"can","interrupts":0,"wire_ns":135,"identifiers":[1],"devices":["fast"]},
        {"period_ns":4000,"wcet_ns":0,"bus":"can","interrupts":0,"wire_ns":135,"identifiers":[2],"devices":["slow"]}],
        "devices":[{"name":"fast","period_ns":1000,"update_wcet_ns":0,"handle_wcet_ns":10},
        {"name":"slow","period_ns":4000,"update_wcet_ns":0,"handle_wcet_ns":)" +
        std::to_string(slow_work) + "}]}";
    return chain_of(text, Rank{0}).wire;
  };
  CHECK(wire(100) == 2 * 135_ns);
  CHECK_FALSE(wire(3800).has_value());  // handed over up to 3840 after its release, it may last until the next one is
}

TEST_CASE("a suggested order keeps what is read before its readers") {
  Sources sources;
  Diagnostics diagnostics;
  // By its trees alone the order would not matter; the reader after the remote uses data of the same release.
  auto model = read_model(
      *sources.add(
          {"m.json", "",
           R"({"tick_ns":10,"devices":[{"name":"remote","period_ns":1000,"update_wcet_ns":9,"handle_wcet_ns":1},
          {"name":"wheel","parent":"chassis","period_ns":1000,"update_wcet_ns":2,"handle_wcet_ns":2},
          {"name":"chassis","period_ns":1000,"update_wcet_ns":50,"handle_wcet_ns":9}]})"}),
      diagnostics);
  REQUIRE(model);
  const auto free = suggest_order(*model, Profile::tight);
  CHECK(free[Rank{0}] != Rank{0});  // the remote after the slower tree ends sooner after it begins
  model->devices[Rank{2}].reads = {Rank{0}};
  const auto bound = suggest_order(*model, Profile::tight);
  CHECK(bound == Order{Rank{0}, Rank{1}, Rank{2}});
  const Model late = reorder(*model, {Rank{1}, Rank{2}, Rank{0}});
  CHECK(suggest_order(late, Profile::tight)[Rank{0}] == Rank{2});  // and it moves a remote that stands after its reader
}

TEST_CASE("every conversion of a measurement takes the periods that it does not fit into") {
  const auto acquire = [](const std::string& conversions) {
    return chain_of(R"({"tick_ns":1000,"buses":[],"devices":[{"name":"depth","period_ns":1000,"update_wcet_ns":10,
        "handle_wcet_ns":10,"acquisition":{"periods":4,"begun_every":4,"conversion_ns":2500)" +
                        conversions + "}}]}",
                    Rank{0})
        .acquire.value();
  };
  // Two periods more, both until it is published and until the next one is; so for each conversion.
  CHECK(acquire("") == 7000_ns + 4000_ns + 10_ns);
  CHECK(acquire(R"(,"conversions":2)") == acquire("") + 2 * 2000_ns);
  CHECK(acquire(R"(,"conversions":1)") == acquire(""));
}
