#include "generator/cli/run_file.hpp"

#include <fmt/format.h>

#include <set>

#include "generator/json/parse.hpp"
#include "generator/xml/read_source.hpp"

namespace finemote::gen {
namespace {

using json::Value;

constexpr const char* kSchema = "finemote.run/1";

/// Reports a text that no device of the model has.
void check_name(const Value* name, const std::set<std::string>& names, Diagnostics& diagnostics) {
  if (name == nullptr || !name->is(Value::Kind::string) || names.count(name->text) > 0) return;
  auto& finding = diagnostics.error(code::usage, name->at,
                                    fmt::format("the run measured '{}', which the robot does not have", name->text));
  finding.length = name->length;
  finding.hint("give the robot that was run, as it was then");
}

bool is_run(const Value& document) {
  const Value* schema = document.is(Value::Kind::object) ? document.find("schema") : nullptr;
  return schema != nullptr && schema->is(Value::Kind::string) && schema->text == kSchema;
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
  const SourceFile* file = xml::read_source(path, sources, diagnostics);
  if (file == nullptr) return nullptr;
  const auto document = json::parse(*file, diagnostics);
  if (!document || diagnostics.has_errors()) return nullptr;
  if (!is_run(*document)) {
    diagnostics.error(code::usage, document->at, fmt::format("--run takes a document of schema '{}'", kSchema))
        .hint("finemote run IN --format json > run.json");
    return nullptr;
  }
  std::set<std::string> names;
  for (const timing::Device& device : model.devices) names.insert(device.name);
  check_names(*document, names, diagnostics);
  if (diagnostics.has_errors()) return nullptr;
  return nlohmann::ordered_json::parse(file->text, nullptr, false);
}

}  // namespace finemote::gen
