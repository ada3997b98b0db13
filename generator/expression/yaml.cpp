#include "generator/expression/yaml.hpp"

#include <fmt/format.h>
#include <yaml-cpp/eventhandler.h>
#include <yaml-cpp/exceptions.h>
#include <yaml-cpp/parser.h>

#include <algorithm>
#include <numbers>
#include <sstream>
#include <unordered_map>

#include "generator/expression/evaluate.hpp"
#include "generator/expression/expression.hpp"
#include "generator/expression/number.hpp"
#include "generator/expression/print.hpp"
#include "generator/expression/runtime.hpp"

namespace finemote::gen::expression {
namespace {

constexpr std::string_view kStandard = "tag:yaml.org,2002:";
constexpr std::size_t kDeepest = 400;

struct Unit {
  std::string_view tag;
  double factor;
};
constexpr Unit kUnits[] = {{"!radians", 1.0}, {"!degrees", std::numbers::pi / 180.0},
                           {"!meters", 1.0},  {"!millimeters", 0.001},
                           {"!foot", 0.3048}, {"!inches", 0.0254}};

/// Builds values from the parser's events; a repeated alias shares what its anchor names.
class Builder : public YAML::EventHandler {
 public:
  Builder(Runtime& runtime, const SourceFile& file) : runtime_(runtime), file_(file) {}

  [[nodiscard]] const Value& result() const { return result_; }

  void OnDocumentStart(const YAML::Mark& mark) override {
    if (documents_++ > 0) fail_at(mark, "expected a single document in the stream but found another document");
  }
  void OnDocumentEnd() override {}

  void OnNull(const YAML::Mark& /*mark*/, YAML::anchor_t anchor) override { add(anchor, {}); }

  void OnAlias(const YAML::Mark& mark, YAML::anchor_t anchor) override {
    const auto found = anchors_.find(anchor);
    if (found == anchors_.end()) fail_at(mark, "found unconstructable recursive node");
    runtime_.budget.spend(1);
    add(0, found->second);
  }

  void OnScalar(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                const std::string& text) override {
    add(anchor, scalar(mark, tag, text));
  }

  void OnSequenceStart(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                       YAML::EmitterStyle::value /*style*/) override {
    check_container_tag(mark, tag);
    open(mark, anchor, false);
  }
  void OnSequenceEnd() override {
    Open closed = take();
    add(closed.anchor, make_list(std::move(closed.items)));
  }

  void OnMapStart(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                  YAML::EmitterStyle::value /*style*/) override {
    check_container_tag(mark, tag);
    open(mark, anchor, true);
  }
  void OnMapEnd() override {
    Open closed = take();
    add(closed.anchor, mapping(closed));
  }

 private:
  /// A list or mapping whose end has not come; a mapping's items are key, value, key, value ...
  struct Open {
    YAML::Mark mark;
    YAML::anchor_t anchor = 0;
    bool is_map = false;
    Values items;
    std::vector<std::size_t> merges;  // places of `<<` keys
  };

  [[nodiscard]] Position place(const YAML::Mark& mark) const {
    return {&file_, static_cast<std::uint32_t>(mark.line + 1), static_cast<std::uint32_t>(mark.column + 1)};
  }

  [[noreturn]] void fail_at(const YAML::Mark& mark, std::string message) const {
    throw Failure{code::xacro_yaml, std::move(message), place(mark)};
  }

  void open(const YAML::Mark& mark, YAML::anchor_t anchor, bool is_map) {
    if (open_.size() >= kDeepest) fail_at(mark, "the YAML file is nested too deeply");
    open_.push_back({mark, anchor, is_map, {}, {}});
  }

  Open take() {
    Open closed = std::move(open_.back());
    open_.pop_back();
    return closed;
  }

  void add(YAML::anchor_t anchor, Value value) {
    runtime_.budget.spend(1);
    if (anchor != 0) anchors_[anchor] = value;
    if (open_.empty()) {
      result_ = std::move(value);
      return;
    }
    Open& parent = open_.back();
    const bool is_key = parent.is_map && parent.items.size() % 2 == 0;
    if (is_key && is_merge_) parent.merges.push_back(parent.items.size());
    is_merge_ = false;
    parent.items.push_back(std::move(value));
  }

  [[noreturn]] void fail_tag(const YAML::Mark& mark, const std::string& tag) const {
    fail_at(mark, fmt::format("could not determine a constructor for the tag '{}' in \"{}\", line {}, column {}", tag,
                              file_.name, mark.line + 1, mark.column + 1));
  }

  void check_container_tag(const YAML::Mark& mark, const std::string& tag) const {
    const bool is_known = tag.empty() || tag == "?" || tag == "!" || tag == std::string(kStandard) + "map" ||
                          tag == std::string(kStandard) + "seq";
    if (!is_known) fail_tag(mark, tag);
  }

  Value scalar(const YAML::Mark& mark, const std::string& tag, const std::string& text) {
    if (tag == "?" || tag.empty()) {
      is_merge_ = text == "<<";
      return yaml_scalar(text);
    }
    if (tag == "!") return text;
    for (const Unit& unit : kUnits) {
      if (tag == unit.tag) return with_unit(mark, unit, text);
    }
    if (!tag.starts_with(kStandard)) fail_tag(mark, tag);
    return standard(mark, tag, text);
  }

  Value standard(const YAML::Mark& mark, const std::string& tag, const std::string& text) {
    const std::string_view name = std::string_view(tag).substr(kStandard.size());
    const Value plain = yaml_scalar(text);
    if (name == "str") return text;
    if (name == "null") return {};
    if (name == "int" && plain.type() == Type::integer) return plain;
    if (name == "bool" && plain.type() == Type::boolean) return plain;
    if (name == "float") {
      if (const auto d = parse_real(text)) return *d;
      if (plain.type() == Type::real) return plain;
    }
    if (name == "int" || name == "bool" || name == "float") {
      fail_at(mark, fmt::format("the text '{}' is no {}", text, name));
    }
    fail_tag(mark, tag);
  }

  Value with_unit(const YAML::Mark& mark, const Unit& unit, const std::string& text) {
    try {
      const ExpressionPtr code = parse_expression(text);
      const Value value = evaluate(runtime_, *code, runtime_.builtins);
      if (const double* d = as_real(value)) return *d * unit.factor;
      if (const auto i = as_integer(value)) return i->to_double() * unit.factor;
      const auto d = value.text() != nullptr ? parse_real(*value.text()) : std::nullopt;
      if (!d) fail_eval("could not convert string to float: " + to_source(runtime_, value));
      return *d * unit.factor;
    } catch (Failure& failure) {
      const bool is_syntax = failure.message.find("(<expression>, line ") != std::string::npos;
      if (is_syntax) failure.message = "invalid expression: " + text;
      failure.at = place(mark);
      throw;
    }
  }

  /// Merged entries come first and give way to the mapping's own.
  Value mapping(const Open& closed) {
    auto table = std::make_shared<Table>();
    for (const std::size_t at : closed.merges) merge(closed, *table, closed.items[at + 1]);
    for (std::size_t i = 0; i + 1 < closed.items.size(); i += 2) {
      const bool is_merge = std::find(closed.merges.begin(), closed.merges.end(), i) != closed.merges.end();
      if (!is_merge) set(closed, *table, closed.items[i], closed.items[i + 1]);
    }
    return make_dict(std::move(table));
  }

  void merge(const Open& closed, Table& table, const Value& source) {
    if (const auto* dict = source.object<Dict>()) {
      for (const auto& [key, value] : dict->table->entries()) set(closed, table, key, value);
      return;
    }
    const auto* list = source.object<List>();
    if (list == nullptr) fail_at(closed.mark, "expected a mapping or list of mappings for merging");
    for (auto item = list->items->rbegin(); item != list->items->rend(); ++item) {
      if (item->object<Dict>() == nullptr) fail_at(closed.mark, "expected a mapping for merging");
      merge(closed, table, *item);
    }
  }

  void set(const Open& closed, Table& table, const Value& key, const Value& value) {
    const bool is_container = key.object<List>() != nullptr || key.object<Dict>() != nullptr;
    if (is_container) fail_at(closed.mark, "found unhashable key");
    table.set(runtime_, key, value);
  }

  Runtime& runtime_;
  const SourceFile& file_;
  std::vector<Open> open_;
  std::unordered_map<YAML::anchor_t, Value> anchors_;
  Value result_;
  bool is_merge_ = false;
  std::size_t documents_ = 0;
};

/// Fails where the brackets of a file nest so deeply that the parser's recursion would be at risk.
void check_nesting(const SourceFile& file) {
  std::size_t depth = 0;
  for (const char c : file.text) {
    if (c == '[' || c == '{') ++depth;
    if ((c == ']' || c == '}') && depth > 0) --depth;
    if (depth > 5000) throw Failure{code::xacro_yaml, "the YAML file is nested too deeply", {&file, 1, 1}};
  }
}

}  // namespace

Value read_yaml(Runtime& runtime, const SourceFile& file) {
  check_nesting(file);
  std::istringstream stream(file.text);
  Builder builder(runtime, file);
  try {
    YAML::Parser parser(stream);
    while (parser.HandleNextDocument(builder)) {}
  } catch (const YAML::Exception& e) {
    const Position at{&file, static_cast<std::uint32_t>(e.mark.line + 1),
                      static_cast<std::uint32_t>(e.mark.column + 1)};
    throw Failure{code::xacro_yaml, "cannot parse YAML: " + e.msg, at};
  }
  return dotted(builder.result());
}

}  // namespace finemote::gen::expression
