// The traces of simulate and run: what Perfetto and chrome://tracing ask of the trace event format.
#include <algorithm>

#include "catch.hpp"
#include "cli/program.hpp"

using namespace finemote::test;
using Json = nlohmann::json;

namespace {

struct Slice {
  std::int64_t begin, end;
};

std::int64_t nanoseconds(const Json& microseconds) { return std::llround(microseconds.get<double>() * 1000); }

/// The tracks of a trace, with its slices by track, the outer ones first.
struct Trace {
  std::map<int, std::string> names;
  std::map<int, std::vector<Slice>> slices;
  std::map<int, std::vector<std::int64_t>> begins;           ///< of stages, as they stand in the file
  std::map<int, std::pair<int, std::int64_t>> starts, ends;  ///< of flows by id: track, time
  bool well_formed = true;

  explicit Trace(const Json& document) {
    for (const Json& e : document["traceEvents"]) {
      const std::string kind = e["ph"];
      const int track = e["tid"];
      if (kind == "M") {
        if (e["name"] == "thread_name") well_formed &= names.emplace(track, e["args"]["name"]).second;
      } else if (kind == "X") {
        const std::int64_t begin = nanoseconds(e["ts"]), length = nanoseconds(e["dur"]);
        well_formed &= begin >= 0 && length >= 0 && e["name"].is_string();
        slices[track].push_back({begin, begin + length});
        if (e["name"] != "job") begins[track].push_back(begin);
      } else if (kind == "s" || kind == "f") {
        auto& side = kind == "s" ? starts : ends;
        well_formed &= side.emplace(e["id"].get<int>(), std::pair{track, nanoseconds(e["ts"])}).second;
      } else {
        well_formed = false;
      }
    }
    for (auto& [track, list] : slices) {
      std::stable_sort(list.begin(), list.end(), [](const Slice& a, const Slice& b) {
        return a.begin != b.begin ? a.begin < b.begin : a.end > b.end;
      });
    }
  }

  [[nodiscard]] bool nests(int track) const {
    std::vector<std::int64_t> open;
    for (const Slice& s : slices.at(track)) {
      while (!open.empty() && open.back() <= s.begin) open.pop_back();
      if (!open.empty() && s.end > open.back()) return false;
      open.push_back(s.end);
    }
    return true;
  }

  [[nodiscard]] bool in_a_slice(const std::pair<int, std::int64_t>& point) const {
    const auto& list = slices.at(point.first);
    return std::any_of(list.begin(), list.end(),
                       [&](const Slice& s) { return s.begin <= point.second && point.second <= s.end; });
  }
};

/// Arrows as Perfetto reads them, which goes through a file once, in the order of time: an arrow leaves the innermost
/// slice that is open, and ends at the slice of its track that begins next.
struct Arrows {
  struct End {
    std::string slice;
    std::int64_t begin, end;
  };
  std::map<int, End> from, to;  ///< by id
  bool in_order = true, nest = true;

  explicit Arrows(const Json& document) {
    std::int64_t last = 0;
    for (const Json& e : document["traceEvents"]) {
      if (e["ph"] == "M") continue;
      const std::int64_t time = nanoseconds(e["ts"]);
      in_order &= time >= last;
      last = time;
      take(e, time);
    }
  }

 private:
  void take(const Json& e, std::int64_t time) {
    std::vector<End>& open = open_[e["tid"].get<int>()];
    std::vector<int>& pending = pending_[e["tid"].get<int>()];
    if (e["ph"] == "s" && !open.empty()) from.emplace(e["id"].get<int>(), open.back());
    if (e["ph"] == "f") pending.push_back(e["id"].get<int>());
    if (e["ph"] != "X") return;
    while (!open.empty() && open.back().end <= time) open.pop_back();
    const End slice{e["name"], time, time + nanoseconds(e["dur"])};
    nest &= open.empty() || slice.end <= open.back().end;
    for (const int id : pending) to.emplace(id, slice);
    pending.clear();
    open.push_back(slice);
  }

  std::map<int, std::vector<End>> open_;
  std::map<int, std::vector<int>> pending_;
};

void check_arrows(const Json& document, const Trace& trace) {
  const Arrows arrows(document);
  CHECK(arrows.in_order);
  CHECK(arrows.nest);
  REQUIRE(arrows.from.size() == trace.starts.size());
  REQUIRE(arrows.to.size() == trace.ends.size());
  for (const auto& [id, from] : arrows.from) {
    const Arrows::End& to = arrows.to.at(id);
    INFO("flow " << id << " from " << from.slice << " to " << to.slice);
    CHECK(from.slice != "job");
    CHECK(to.slice != "job");
    CHECK(from.end - trace.starts.at(id).second <= 1);
    CHECK(to.begin == trace.ends.at(id).second);
  }
}

void check_tracks(const Trace& trace) {
  CHECK(trace.well_formed);
  for (const auto& [track, list] : trace.slices) {
    INFO("track " << track);
    CHECK(trace.names.count(track) == 1);
    CHECK(trace.nests(track));
    CHECK(std::is_sorted(trace.begins.at(track).begin(), trace.begins.at(track).end()));
  }
}

}  // namespace

TEST_CASE("a simulated run is a trace with one track per bucket and bus, and whole arrows") {
  for (const std::string robot : {"finsrov.urdf", "deep_forest.urdf"}) {
    INFO(robot);
    TemporaryFolder folder;
    const std::string file = folder.path("trace.json"), input = source_path("examples/" + robot);
    REQUIRE(run_finemote({"simulate", input, "--duration", "50ms", "-o", file}).exit_status == 0);
    const Json document = Json::parse(read_file(file));
    const Trace trace(document);
    check_tracks(trace);
    check_arrows(document, trace);
    const Json tree = finemote_json({"tree", input});
    std::size_t buckets = 0, buses = 0;
    for (const auto& [track, name] : trace.names) {
      buckets += name.rfind("every ", 0) == 0 ? 1 : 0;
      buses += name.rfind("bus ", 0) == 0 ? 1 : 0;
    }
    CHECK(buckets == tree["buckets"].size());
    CHECK(buses == (robot == "finsrov.urdf" ? 3 : 0));
    CHECK(trace.starts.size() > 100);
    CHECK(trace.starts.size() == trace.ends.size());
    for (const auto& [id, start] : trace.starts) {
      INFO("flow " << id);
      REQUIRE(trace.ends.count(id) == 1);
      CHECK(start.second <= trace.ends.at(id).second);
      CHECK(trace.in_a_slice(start));
      CHECK(trace.in_a_slice(trace.ends.at(id)));
    }
  }
}

TEST_CASE("a model with stages of no length is a good trace too") {
  TemporaryFolder folder;
  const Json cases = Json::parse(read_file(source_path("tests/analysis-cases/zero-handle-sensors.json")));
  write_file(folder.path("m.json"), cases["model"].dump());
  REQUIRE(run_finemote({"simulate", folder.path("m.json"), "-o", folder.path("t.json")}).exit_status == 0);
  const Json document = Json::parse(read_file(folder.path("t.json")));
  const Trace trace(document);
  check_tracks(trace);
  check_arrows(document, trace);
  for (const auto& [id, start] : trace.starts) CHECK(trace.in_a_slice(start));
}

TEST_CASE("a run of the firmware is a trace with one track per bucket") {
  TemporaryFolder folder;
  const std::string input = source_path("examples/deep_forest.urdf");
  REQUIRE(run_finemote({"run", input, "--board", "host", "-o", folder.path("t.json")}).exit_status == 0);
  const Trace trace(Json::parse(read_file(folder.path("t.json"))));
  check_tracks(trace);
  CHECK(trace.names.size() == finemote_json({"tree", input})["buckets"].size());
  CHECK(trace.slices.size() == trace.names.size());
}
