#include "generator/cli/saved_document.hpp"

#include <fmt/format.h>

#include <optional>
#include <set>

#include "generator/json/parse.hpp"
#include "generator/xml/read_source.hpp"

namespace finemote::gen {
namespace {

using json::Value;

/// A kind of document, and what asks for it.
struct Kind {
  const char* schema;
  const char* option;
  const char* hint;
};

constexpr Kind kRun{"finemote.run/1", "--run", "finemote run IN --format json > run.json"};
constexpr Kind kTiming{"finemote.timing/1", "--against", "finemote analyze IN --format json > before.json"};

/// A file with its tree, which knows where everything stands.
struct Saved {
  const SourceFile* file;
  Value root;
};

/// Reports a text that no device of the model has.
void check_name(const Value* name, const std::set<std::string>& names, Diagnostics& diagnostics) {
  if (name == nullptr || !name->is(Value::Kind::string) || names.count(name->text) > 0) return;
  auto& finding = diagnostics.error(code::usage, name->at,
                                    fmt::format("the run measured '{}', which the robot does not have", name->text));
  finding.length = name->length;
  finding.hint("give the robot that was run, as it was then");
}

bool is_of(const Kind& kind, const Value& document) {
  const Value* schema = document.is(Value::Kind::object) ? document.find("schema") : nullptr;
  return schema != nullptr && schema->is(Value::Kind::string) && schema->text == kind.schema;
}

std::optional<Saved> read_saved(const std::string& path, const Kind& kind, Sources& sources, Diagnostics& diagnostics) {
  const SourceFile* file = xml::read_source(path, sources, diagnostics);
  if (file == nullptr) return std::nullopt;
  auto document = json::parse(*file, diagnostics);
  if (!document || diagnostics.has_errors()) return std::nullopt;
  if (is_of(kind, *document)) return Saved{file, std::move(*document)};
  diagnostics
      .error(code::usage, document->at, fmt::format("{} takes a document of schema '{}'", kind.option, kind.schema))
      .hint(kind.hint);
  return std::nullopt;
}

nlohmann::ordered_json json_of(const Saved& saved) {
  return nlohmann::ordered_json::parse(saved.file->text, nullptr, false);
}

void check_names(const Value& document, const std::set<std::string>& names, Diagnostics& diagnostics) {
  for (const char* list : {"stages", "chains"}) {
    const Value* found = document.find(list);
    if (found == nullptr) continue;
    for (const Value& item : found->items) {
      if (diagnostics.has_errors()) return;  // one says it all
      for (const char* member : {"device", "from", "to"}) check_name(item.find(member), names, diagnostics);
    }
  }
}

}  // namespace

nlohmann::ordered_json read_run(const std::string& path, const timing::Model& model, Sources& sources,
                                Diagnostics& diagnostics) {
  const auto saved = read_saved(path, kRun, sources, diagnostics);
  if (!saved) return nullptr;
  std::set<std::string> names;
  for (const timing::Device& device : model.devices) names.insert(device.name);
  check_names(saved->root, names, diagnostics);
  if (diagnostics.has_errors()) return nullptr;
  return json_of(*saved);
}

nlohmann::ordered_json read_timing(const std::string& path, Sources& sources, Diagnostics& diagnostics) {
  const auto saved = read_saved(path, kTiming, sources, diagnostics);
  return saved ? json_of(*saved) : nlohmann::ordered_json(nullptr);
}

}  // namespace finemote::gen
