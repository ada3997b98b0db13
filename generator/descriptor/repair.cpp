#include "generator/descriptor/repair.hpp"

#include <algorithm>
#include <array>

namespace finemote::gen {
namespace {

/// The value at a path, null when there is none.
Json* value_at(Json& root, const JsonPath& path, std::size_t steps) {
  Json* node = &root;
  for (std::size_t i = 0; i < steps; ++i) {
    const std::string& step = path[i];
    const bool is_index = !step.empty() && step.find_first_not_of("0123456789") == std::string::npos;
    if (node->is_object() && node->contains(step)) {
      node = &(*node)[step];
    } else if (node->is_array() && is_index && step.size() < 9 && std::stoul(step) < node->size()) {
      node = &(*node)[std::stoul(step)];
    } else {
      return nullptr;
    }
  }
  return node;
}

/// A misspelt member gets its name, one that means nothing goes; a misspelt value becomes the one that was meant.
bool put_right(Json& root, const SchemaMistake& mistake) {
  if (mistake.path.empty()) return false;
  Json* parent = value_at(root, mistake.path, mistake.path.size() - 1);
  const std::string& key = mistake.path.back();
  if (parent == nullptr) return false;
  if (mistake.is_unknown && parent->is_object()) {
    if (!mistake.meant.empty() && !parent->contains(mistake.meant) && parent->contains(key))
      (*parent)[mistake.meant] = parent->at(key);
    parent->erase(key);
    return true;
  }
  Json* value = value_at(root, mistake.path, mistake.path.size());
  if (mistake.meant.empty() || value == nullptr || !value->is_string()) return false;
  *value = mistake.meant;
  return true;
}

/// `params/2/...`: that param takes any text from now on.
bool loosen_param(Json& root, const JsonPath& path) {
  if (path.size() < 2 || path[0] != "params") return false;
  Json* param = value_at(root, path, 2);
  if (param == nullptr || !param->is_object()) return false;
  const auto name = param->find("name");
  if (name == param->end() || !name->is_string()) return false;
  *param = Json{{"name", name->get<std::string>()}, {"type", "string"}, {"default", ""}};
  return true;
}

/// Members the model of a robot does without.
bool drop(Json& root, const JsonPath& path) {
  constexpr std::array kOptional{"summary",     "class",         "header",      "geometry",   "link",
                                 "actuator",    "constant_init", "acquisition", "interrupts", "wcet",
                                 "bring_up_ns", "emulation",     "frames",      "references"};
  if (path.empty()) return true;  // a member is missing: filled in below
  const bool is_optional = std::find(kOptional.begin(), kOptional.end(), path[0]) != kOptional.end();
  if (is_optional) root.erase(path[0]);
  return is_optional;
}

ParamValue any_value(const ParamSpec& spec) {
  switch (spec.kind) {
    case ParamKind::integer:
      return std::int64_t{0};
    case ParamKind::real:
      return 0.0;
    case ParamKind::boolean:
      return false;
    default:
      return std::string();
  }
}

}  // namespace

bool repair_device(Json& value, const std::vector<SchemaMistake>& mistakes, const std::string& name) {
  for (const SchemaMistake& mistake : mistakes) {
    if (!put_right(value, mistake) && !loosen_param(value, mistake.path) && !drop(value, mistake.path)) return false;
  }
  value["type"] = name;
  for (const char* key : {"summary", "class", "header"}) {
    if (!value.contains(key)) value[key] = "unknown";
  }
  return true;
}

void relax(DeviceType& type) {
  type.has_mistakes = true;
  type.bus_required = false;
  for (ParamSpec& param : type.params) {
    if (!param.fallback) param.fallback = any_value(param);
  }
  for (RoleSpec& role : type.roles) {
    role.min = 0;
    role.max.reset();
  }
  for (UseSpec& use : type.uses) use.required = false;
}

}  // namespace finemote::gen
