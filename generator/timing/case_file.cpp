#include "generator/timing/case_file.hpp"

#include <fmt/format.h>

#include "generator/timing/object_reader.hpp"

namespace finemote::gen::timing {

using json::Value;

const Value* model_object(const Value& root, Diagnostics& diagnostics) {
  ObjectReader values(diagnostics);
  if (!values.is_object(root, "the root")) return nullptr;
  const Value* model = root.find("model");
  if (model == nullptr) return &root;
  for (const json::Member& m : root.members) {
    if (m.key != "model" && m.key != "name" && m.key != "description" && m.key != "expected") {
      diagnostics.error(code::json_unknown_member, m.at, fmt::format("a case file has no member '{}'", m.key))
          .underline(m.key.size() + 2);
    }
  }
  return values.is_object(*model, "'model'") ? model : nullptr;
}

}  // namespace finemote::gen::timing
