#include <fstream>
#include <map>
#include <sstream>
#include <stdexcept>

#include "generator/dump/dump.hpp"

namespace finemote::gen {
namespace {

/// A key that a template names: a value, or a section with keys of its own.
struct Hole {
  std::string key;
  std::vector<Hole> inside;
};

/// The holes of a template's text, from `at` to the end of the section `end` (empty: of the text).
std::vector<Hole> find_holes(std::string_view text, std::size_t& at, std::string_view end) {
  std::vector<Hole> holes;
  for (std::size_t open = text.find("{{", at); open != std::string_view::npos; open = text.find("{{", at)) {
    const std::size_t close = text.find("}}", open);
    std::string_view word = text.substr(open + 2, close - open - 2);
    at = close + 2;
    const char kind = word.empty() ? ' ' : word.front();
    const bool is_value = std::string_view("#^/").find(kind) == std::string_view::npos;
    if (!is_value) word.remove_prefix(1);
    if (kind == '/' && word == end) return holes;
    Hole& hole = holes.emplace_back(Hole{std::string(word), {}});
    if (!is_value) hole.inside = find_holes(text, at, word);
  }
  return holes;
}

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

std::vector<Hole> holes_of(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) throw std::runtime_error("cannot read template " + path);
  std::ostringstream text;
  text << file.rdbuf();
  std::size_t at = 0;
  return find_holes(text.str(), at, "");
}

}  // namespace

Json dump_plan(const std::vector<TemplateData>& files, const std::string& templates) {
  Json list = Json::array();
  for (const TemplateData& file : files) {
    list.push_back({{"file", file.name},
                    {"template", file.template_name},
                    {"values", values_of(holes_of(templates + "/" + file.template_name), file.data)}});
  }
  return {{"stage", "plan"}, {"files", list}};
}

}  // namespace finemote::gen
