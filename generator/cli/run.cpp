// finemote run: generates, compiles, runs and measures a robot's firmware.
#include <fmt/format.h>
#include <stdlib.h>

#include <algorithm>
#include <filesystem>
#include <numeric>

#include "generator/cli/commands.hpp"
#include "generator/cli/exit_status.hpp"
#include "generator/cli/finish.hpp"
#include "generator/cli/load.hpp"
#include "generator/output/sha256.hpp"
#include "generator/output/write.hpp"
#include "generator/run/build_firmware.hpp"
#include "generator/run/execute.hpp"
#include "generator/run/measure.hpp"
#include "generator/schedule/period.hpp"
#include "generator/units/units.hpp"

namespace finemote::gen {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

/// A work folder that is removed at the end unless the user keeps it.
class WorkFolder {
 public:
  explicit WorkFolder(const std::string& keep) : path_(keep), keep_(!keep.empty()) {
    if (keep_) {
      fs::create_directories(path_);
      return;
    }
    std::string pattern = (fs::temp_directory_path() / "finemote-run-XXXXXX").string();
    if (mkdtemp(pattern.data()) == nullptr) throw std::runtime_error("cannot make a temporary folder");
    path_ = pattern;
  }
  WorkFolder(const WorkFolder&) = delete;
  WorkFolder& operator=(const WorkFolder&) = delete;
  ~WorkFolder() {
    std::error_code ignored;
    if (!keep_) fs::remove_all(path_, ignored);
  }
  [[nodiscard]] std::string path() const { return path_.string(); }

 private:
  fs::path path_;
  bool keep_;
};

/// A measured chain.
struct Chain {
  std::size_t from = 0, to = 0;
  ChainPath path;
  Statistics decide;
};

/// Least common multiple of the periods; none beyond `limit`.
std::optional<std::int64_t> hyperperiod(const Schedule& schedule, std::int64_t limit) {
  std::int64_t result = 1;
  for (const Bucket& bucket : schedule.buckets) {
    const std::int64_t factor = bucket.period_ns / std::gcd(result, bucket.period_ns);
    if (factor > limit / result) return std::nullopt;
    result *= factor;
  }
  return result;
}

/// Two hyperperiods, at least 100 ms and at most 1 s.
std::int64_t default_duration(const Schedule& schedule) {
  constexpr std::int64_t kShortest = 100'000'000;
  constexpr std::int64_t kLongest = 1'000'000'000;
  const auto whole = hyperperiod(schedule, kLongest);
  return whole ? std::clamp(2 * *whole, kShortest, kLongest) : kLongest;
}

std::optional<std::int64_t> duration_of(Context& context, const Schedule& schedule) {
  if (context.options.duration.empty()) return default_duration(schedule);
  const auto parsed = units::parse_duration(context.options.duration);
  if (parsed && *parsed > 0) return *parsed;
  context.diagnostics.error(code::usage, {}, fmt::format("--duration '{}' is no time above zero", context.options.duration))
      .hint("write for example --duration 100ms");
  return std::nullopt;
}

/// The devices whose handle() ends a chain: leaves that take a command, or the root of a tree without one.
std::vector<std::size_t> chain_ends(const Loaded& loaded, const Tree& tree) {
  std::vector<std::size_t> ends;
  for (std::size_t device : tree.devices) {
    const Device& d = loaded.robot.devices[device];
    if (d.children.empty() && d.type->has_command()) ends.push_back(device);
  }
  if (ends.empty()) ends.push_back(tree.root);
  return ends;
}

/// For every end the leaf of its tree whose data reached it oldest.
std::vector<Chain> measure_chains(const Loaded& loaded, const RunRecord& record) {
  std::vector<Chain> chains;
  for (const Tree& tree : loaded.forest.trees) {
    for (std::size_t end : chain_ends(loaded, tree)) {
      std::optional<Chain> worst;
      for (std::size_t leaf : tree.devices) {
        if (!loaded.robot.devices[leaf].children.empty()) continue;
        auto path = find_chain(loaded.robot, leaf, end);
        if (!path) continue;
        Chain chain{leaf, end, *path, summarize(decision_latencies(record, *path))};
        if (!worst || chain.decide.max_ns > worst->decide.max_ns) worst = std::move(chain);
      }
      if (worst) chains.push_back(std::move(*worst));
    }
  }
  return chains;
}

const std::string& name_of(const Loaded& loaded, std::size_t device) { return loaded.robot.devices[device].name.text; }

Json statistics(const Statistics& s) {
  const bool any = s.count > 0;
  return {{"min_ns", any ? Json(s.min_ns) : Json(nullptr)},
          {"mean_ns", any ? Json(s.mean_ns) : Json(nullptr)},
          {"sd_ns", any ? Json(s.sd_ns) : Json(nullptr)},
          {"max_ns", any ? Json(s.max_ns) : Json(nullptr)},
          {"bound_ns", nullptr}};
}

Json stage_list(const Loaded& loaded, const RunRecord& record) {
  Json list = Json::array();
  for (std::size_t device : loaded.forest.order) {
    for (const bool is_handle : {false, true}) {
      const Statistics s = summarize(stage_times(record, device, is_handle));
      const bool any = s.count > 0;
      list.push_back({{"device", name_of(loaded, device)},
                      {"stage", is_handle ? "handle" : "update"},
                      {"count", s.count},
                      {"min_ns", any ? Json(s.min_ns) : Json(nullptr)},
                      {"mean_ns", any ? Json(s.mean_ns) : Json(nullptr)},
                      {"max_ns", any ? Json(s.max_ns) : Json(nullptr)}});
    }
  }
  return list;
}

Json event_list(const Loaded& loaded, const RunRecord& record, std::int64_t until) {
  Json list = Json::array();
  for (const Event& event : record.events) {
    if (event.t_ns >= until) break;
    list.push_back({{"t_ns", event.t_ns},
                    {"device", name_of(loaded, event.device)},
                    {"stage", event.is_handle ? "handle" : "update"},
                    {"edge", event.is_end ? "end" : "begin"}});
  }
  return list;
}

Json chain_list(const Loaded& loaded, const std::vector<Chain>& chains) {
  const Json unmeasured = statistics({});
  Json list = Json::array();
  for (const Chain& chain : chains) {
    list.push_back({{"from", name_of(loaded, chain.from)},
                    {"to", name_of(loaded, chain.to)},
                    {"samples", chain.decide.count},
                    {"decide", statistics(chain.decide)},
                    {"acquire", unmeasured},
                    {"wire", unmeasured},
                    {"end_to_end", unmeasured}});
  }
  return list;
}

Json bus_list(const Loaded& loaded, const RunRecord& record) {
  Json list = Json::array();
  for (const BusRecord& bus : record.buses) {
    if (bus.bus >= loaded.robot.buses.size()) continue;
    list.push_back({{"name", loaded.robot.buses[bus.bus].name.text},
                    {"transfers", bus.transfers},
                    {"errors", bus.errors},
                    {"busy", bus.busy}});
  }
  return list;
}

std::uint64_t total_overruns(const RunRecord& record) {
  return std::accumulate(record.overruns.begin(), record.overruns.end(), std::uint64_t{0});
}

/// One line per job: the stages in the order they began.
void print_order(Context& context, const Loaded& loaded, const RunRecord& record, std::int64_t until) {
  context.out << "\nobserved order\n";
  std::string line;
  std::int64_t release = -1;
  std::int64_t shortest = loaded.schedule.buckets.front().period_ns;
  for (const Event& event : record.events) {
    if (event.t_ns >= until) break;
    if (event.is_end) continue;
    const std::int64_t slot = event.t_ns / shortest * shortest;
    if (slot != release) {
      if (!line.empty()) context.out << line << "\n";
      line = fmt::format("  {:>9}:", period_text(std::max<std::int64_t>(slot, 1)) == "1 ns" ? "0 ms" : period_text(slot));
      release = slot;
    }
    line += fmt::format(" {}{}", event.is_handle ? "-" : "+", name_of(loaded, event.device));
  }
  context.out << line << "\n  (+ update, - handle)\n";
}

void print_report(Context& context, const Loaded& loaded, const RunRecord& record, const std::vector<Chain>& chains,
                  std::int64_t until) {
  print_order(context, loaded, record, until);
  context.out << "\nage of the data behind a command: begin of update() to end of handle(), us\n";
  context.out << fmt::format("  {:<32} {:>7} {:>10} {:>10} {:>10} {:>10}\n", "chain", "samples", "min", "mean", "max", "sd");
  for (const Chain& chain : chains) {
    const Statistics& s = chain.decide;
    context.out << fmt::format("  {:<32} {:>7} {:>10.3f} {:>10.3f} {:>10.3f} {:>10.3f}\n",
                               name_of(loaded, chain.from) + " -> " + name_of(loaded, chain.to), s.count,
                               static_cast<double>(s.min_ns) / 1e3, s.mean_ns / 1e3, static_cast<double>(s.max_ns) / 1e3,
                               s.sd_ns / 1e3);
  }
  context.out << fmt::format("\noverruns {}\n", total_overruns(record));
  for (const std::string& fault : record.faults) context.out << "fault: " << fault << "\n";
}

std::vector<std::string> user_include_dirs(const Robot& robot) {
  std::vector<std::string> dirs;
  for (const Device& device : robot.devices) {
    const std::string& dir = device.type->include_dir;
    if (!dir.empty() && std::find(dirs.begin(), dirs.end(), dir) == dirs.end()) dirs.push_back(dir);
  }
  return dirs;
}

std::vector<std::string> user_sources(const std::vector<std::string>& dirs) {
  std::vector<std::string> sources;
  for (const std::string& dir : dirs) {
    for (const auto& entry : fs::directory_iterator(dir)) {
      if (entry.path().extension() == ".cpp") sources.push_back(entry.path().string());
    }
  }
  std::sort(sources.begin(), sources.end());
  return sources;
}

std::optional<std::string> make_image(Context& context, const Loaded& loaded, const std::string& board,
                                      std::int64_t duration, const WorkFolder& work) {
  auto files = render_files(loaded.plan(), loaded.data_dir + "/templates", context.diagnostics);
  if (context.diagnostics.has_errors()) return std::nullopt;
  const Output output = make_output(std::move(files), input_files(context, loaded), loaded.robot.name.text);
  write_output(work.path() + "/generated", output, false, context.diagnostics);
  if (context.diagnostics.has_errors()) return std::nullopt;
  FirmwareRequest request;
  request.folder = work.path();
  request.data_dir = loaded.data_dir;
  request.board = board;
  request.duration_ns = duration;
  request.include_dirs = user_include_dirs(loaded.robot);
  request.sources = user_sources(request.include_dirs);
  return build_firmware(request, context.diagnostics);
}

}  // namespace

int run_run(Context& context) {
  // The board chosen here runs the image; the robot keeps its own board, so the generated files are the same.
  Options load_options = context.options;
  load_options.board.clear();
  Context load_context{load_options, context.sources, context.diagnostics, context.out, context.err};
  const auto loaded = load_robot(load_context);
  if (!loaded) return finish(context, kExitInvalid);
  const std::string board = context.options.board.empty() ? loaded->robot.board->name : context.options.board;
  const auto duration = duration_of(context, loaded->schedule);
  if (!duration) return finish(context, kExitInvalid);

  const WorkFolder work(context.options.keep);
  const auto image = make_image(context, *loaded, board, *duration, work);
  if (!image) return finish(context, kExitInvalid);
  if (context.options.build_only) return finish(context, kExitYes);
  const auto record = execute(*image, board, loaded->forest, *duration, context.diagnostics);
  if (!record) return finish(context, kExitInvalid);

  const std::vector<Chain> chains = measure_chains(*loaded, *record);
  const auto whole = hyperperiod(loaded->schedule, *duration);
  const std::int64_t until = whole ? std::min(2 * *whole, *duration) : *duration;
  if (context.options.format == Format::text) {
    context.out << fmt::format("{} on {}, {}\n", loaded->robot.name.text, board, period_text(*duration));
    print_report(context, *loaded, *record, chains, until);
  }
  Json document{{"schema", "finemote.run/1"},
                {"image", {{"sha256", sha256(read_bytes(*image).value_or(""))}}},
                {"board", board},
                {"duration_ns", *duration},
                {"stages", stage_list(*loaded, *record)},
                {"events", event_list(*loaded, *record, until)},
                {"chains", chain_list(*loaded, chains)},
                {"overruns", total_overruns(*record)},
                {"buses", bus_list(*loaded, *record)}};
  return finish(context, total_overruns(*record) > 0 ? kExitNo : kExitYes, std::move(document));
}

}  // namespace finemote::gen
