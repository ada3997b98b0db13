#include "generator/dump/dump.hpp"

namespace finemote::gen {
namespace {

Json values_of(const std::vector<Hole>& holes, const Data& data);

Json value_of(const Hole& hole, const Data& value) {
  if (value.is_string()) return value.string_value();
  if (!value.is_list()) return value.is_true();
  Json list = Json::array();
  for (const Data& element : value.list_value()) list.push_back(values_of(hole.inside, element));
  return list;
}

/// Adds what `data` itself holds of the holes and of those inside them: a section may name what is around it.
void add_values(const std::vector<Hole>& holes, const Data& data, Json& values) {
  for (const Hole& hole : holes) {
    const Data* value = data.get(hole.key);
    if (value != nullptr && !values.contains(hole.key)) values[hole.key] = value_of(hole, *value);
    add_values(hole.inside, data, values);
  }
}

Json values_of(const std::vector<Hole>& holes, const Data& data) {
  Json values = Json::object();
  add_values(holes, data, values);
  return values;
}

}  // namespace

Json dump_plan(const std::vector<TemplateData>& files, const std::string& folder) {
  Templates templates(folder);
  Json list = Json::array();
  for (const TemplateData& file : files) {
    list.push_back({{"file", file.name},
                    {"template", file.template_name},
                    {"values", values_of(holes_in(templates.text(file.template_name)), file.data)}});
  }
  return {{"stage", "plan"}, {"files", list}};
}

}  // namespace finemote::gen
