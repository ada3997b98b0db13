#include "generator/timing_file/timing_file.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "generator/input/input.hpp"
#include "generator/json/parse.hpp"
#include "generator/timing/object_reader.hpp"
#include "generator/timing_file/cost_words.hpp"
#include "generator/xml/read_source.hpp"

namespace finemote::gen {
namespace {

using json::Value;

/// Members that this version does not know are left alone: later ones add some.
class Reader {
 public:
  explicit Reader(Diagnostics& diagnostics) : values_(diagnostics) {}

  TimingFile read(const Value& root) {
    TimingFile file;
    file.at = root.at;
    for (const Value& stage : items(root, "stages")) read_stage(stage, file.devices);
    for (const Value& line : items_or_none(root, "interrupts")) read_line(line, file);
    for (const Value& task : items_or_none(root, "scheduler")) read_task(task, file.scheduler);
    file.is_complete = root.find("unresolved") != nullptr && items(root, "unresolved").empty();
    if (const Value* model = object(root, "model"))
      file.model = {values_.member_text(*model, "'model'", "name"), number(*model, "version")};
    if (const Value* inputs = object(root, "inputs")) read_inputs(*inputs, file);
    return file;
  }

 private:
  const std::vector<Value>& items(const Value& object, std::string_view key) {
    static const std::vector<Value> kNone;
    const Value* list = object.find(key);
    if (list == nullptr) {
      missing(object, key);
      return kNone;
    }
    return values_.is_array(*list, key) ? list->items : kNone;
  }

  /// Of a member that may be absent.
  const std::vector<Value>& items_or_none(const Value& object, std::string_view key) {
    static const std::vector<Value> kNone;
    return object.find(key) != nullptr ? items(object, key) : kNone;
  }

  const Value* object(const Value& parent, std::string_view key) {
    const Value* found = parent.find(key);
    if (found == nullptr) missing(parent, key);
    return found != nullptr && values_.is_object(*found, fmt::format("'{}'", key)) ? found : nullptr;
  }

  void missing(const Value& object, std::string_view key) {
    values_.error(code::json_missing_member, object, fmt::format("a timing file needs '{}'", key));
  }

  std::int64_t number(const Value& object, std::string_view key) {
    const Value* found = object.find(key);
    if (found == nullptr) missing(object, key);
    return found != nullptr ? values_.integer(*found, key, 0) : 0;
  }

  Duration time(const Value& object, std::string_view key) { return nanoseconds(number(object, key)); }

  /// Empty where it is null or not there.
  std::string text_or_none(const Value& object, std::string_view key) {
    const Value* found = object.find(key);
    if (found == nullptr || found->is(Value::Kind::null)) return {};
    return values_.text(*found, "'inputs'", key);
  }

  void read_stage(const Value& stage, std::map<std::string, StageBounds>& devices) {
    enum class Which { update, handle };
    constexpr std::pair<Which, std::string_view> kWords[] = {{Which::update, "update"}, {Which::handle, "handle"}};
    if (!values_.is_object(stage, "a stage")) return;
    const std::string device = values_.member_text(stage, "a stage", "device");
    const Value* which = stage.find("stage");
    if (which == nullptr) return missing(stage, "stage");
    const bool is_update = values_.one_of(*which, "a stage", "stage", kWords) == Which::update;
    const Duration bound = nanoseconds(number(stage, "wcet_ns"));
    StageBounds& bounds = devices[device];
    auto& place = is_update ? bounds.update : bounds.handle;
    place = std::max(place.value_or(Duration::zero()), bound);
  }

  void read_line(const Value& value, TimingFile& file) {
    if (!values_.is_object(value, "an interrupt")) return;
    LineBounds line{values_.member_text(value, "an interrupt", "source"), time(value, "wcet_ns"), {}};
    const Value* causes = value.find("raised_by");
    if (causes != nullptr && values_.is_object(*causes, "'raised_by'")) {
      for (const json::Member& cause : causes->members)
        line.raised_by[cause.key] = nanoseconds(values_.integer(cause.value, cause.key, 0));
    }
    for (const Value& request : items_or_none(value, "requests"))
      line.requests.push_back(nanoseconds(values_.integer(request, "requests", 0)));
    file.lines.push_back(std::move(line));
  }

  void read_task(const Value& task, SchedulerBounds& bounds) {
    if (!values_.is_object(task, "a part of the scheduler")) return;
    const std::string what = values_.member_text(task, "a part of the scheduler", "what");
    const Duration time = this->time(task, "wcet_ns");
    if (what == cost_words::kRelease) bounds.release = std::max(bounds.release.value_or(time), time);
    if (what == cost_words::kMasked) bounds.masked = std::max(bounds.masked.value_or(time), time);
    if (what == cost_words::kBefore) read_stage(task, bounds.before);
    if (what == cost_words::kRetry) take_longer(bounds.retries[values_.member_text(task, "'retry'", "after")], time);
    if (task.find("behind_ns") != nullptr)
      take_longer(bounds.behind[this->time(task, "period_ns")], this->time(task, "behind_ns"));
  }

  /// Of rows that say the same twice.
  static void take_longer(Duration& longest, Duration time) { longest = std::max(longest, time); }

  void read_inputs(const Value& inputs, TimingFile& file) {
    file.compiler = text_or_none(inputs, "compiler");
    file.hash = text_or_none(inputs, "hash");
    for (const Value& word : items(inputs, "arguments"))
      file.arguments.push_back(values_.text(word, "'inputs'", "arguments"));
    std::sort(file.arguments.begin(), file.arguments.end());
    const Value* options = inputs.find("options");
    if (options == nullptr || !values_.is_object(*options, "'options'")) return;
    file.board = text_or_none(*options, "board");
  }

  timing::ObjectReader values_;
};

bool has_schema(const Value& root) {
  const Value* schema = root.is(Value::Kind::object) ? root.find("schema") : nullptr;
  return schema != nullptr && schema->is(Value::Kind::string) && schema->text == kTimingSchema;
}

}  // namespace

CostModel cost_model() { return {"cortex-m4-maxima", 4}; }

std::string timing_file_path(const std::string& robot) {
  constexpr const char* kEnding = ".timing.json";
  if (robot == "-" || is_timing_model(robot)) return {};
  for (const std::string_view ending : {".urdf.xacro", ".xacro", ".urdf"}) {
    if (robot.size() > ending.size() && robot.ends_with(ending))
      return robot.substr(0, robot.size() - ending.size()) + kEnding;
  }
  return robot + kEnding;
}

std::optional<TimingFile> read_timing_file(const std::string& path, Sources& sources, Diagnostics& diagnostics) {
  const SourceFile* file = xml::read_source(path, sources, diagnostics);
  const auto root = file != nullptr ? json::parse(*file, diagnostics) : std::nullopt;
  if (!root) return std::nullopt;
  if (!has_schema(*root)) {
    diagnostics
        .error(code::timing_file_schema, root->at, fmt::format("this is no document of schema '{}'", kTimingSchema))
        .note("a file of this name beside a robot holds the bounds of its execution times")
        .hint("write it anew: finemote wcet IN -o " + path);
    return std::nullopt;
  }
  Diagnostics found;
  TimingFile read = Reader(found).read(*root);
  for (const Diagnostic& finding : found.in_file_order()) diagnostics.add(finding);
  return found.has_errors() ? std::nullopt : std::optional(std::move(read));
}

}  // namespace finemote::gen
