#include "generator/emit/render.hpp"

#include <map>

#include "generator/emit/bus_files.hpp"
#include "generator/emit/constants.hpp"
#include "generator/emit/file_names.hpp"
#include "generator/emit/link.hpp"
#include "generator/emit/plan_files.hpp"
#include "generator/emit/schedule_files.hpp"
#include "generator/emit/tree.hpp"
#include "generator/schedule/name_clash.hpp"

namespace finemote::gen {
namespace {

Data constants_data(const Plan& plan, const std::vector<Constant>& constants) {
  Data data = common_data(plan), list(Data::type::list);
  std::vector<std::string> headers;
  for (const Constant& constant : constants) {
    if (constant.in_tree || !constant.exists()) continue;
    list.push_back(*constant.fields);
    if (!constant.header.empty()) headers.push_back(constant.header);
  }
  data.set("has_includes", !headers.empty());
  data.set("includes", include_list(headers));
  data.set("constants", list);
  return data;
}

/// Two devices may ask for constants of one name: `a` for `yaw_axes`, and `a_yaw` for `axes`.
void check_names(const Plan& plan, const std::vector<Constant>& constants, Diagnostics& diagnostics) {
  std::map<std::string, DeviceId> owners;
  for (const Constant& constant : constants) {
    if (!constant.exists()) continue;
    const auto [first, is_fresh] = owners.emplace(constant.name, constant.device);
    if (is_fresh) continue;
    const Table<DeviceId, Device>& devices = plan.robot.devices;
    report_name_clash(constant.name, devices[constant.device], {&devices[first->second]}, diagnostics);
  }
}

}  // namespace

std::vector<TemplateData> plan_files(const Plan& plan, const ProvenBounds& bounds, const std::string& data_dir,
                                     Diagnostics& diagnostics) {
  std::vector<Constant> constants = make_constants(plan, diagnostics);
  check_names(plan, constants, diagnostics);
  const std::vector<DeviceLink> links = plan_links(plan, shipped_interfaces(data_dir + "/schemas"), diagnostics);
  for (const DeviceLink& link : links) constants.push_back(link_constant(plan, link));
  std::vector<TemplateData> files;
  files.reserve(std::size(kFixedFiles) + 2 * plan.forest.trees.size() + links.size());  // growing copies Data
  const auto add = [&](const std::string& name, const std::string& template_name, Data data) {
    files.push_back({name, template_name, std::move(data)});
  };
  Data fixed[] = {schedule_header(plan, bounds), schedule_source(plan, bounds), bus_header(plan, bounds.plain),
                  bus_source(plan, bounds.plain), constants_data(plan, constants)};
  static_assert(std::size(fixed) == std::size(kFixedFiles));
  for (std::size_t i = 0; i < std::size(fixed); ++i)
    add(kFixedFiles[i], std::string(kFixedFiles[i]) + ".mustache", std::move(fixed[i]));
  for (const Tree& tree : plan.forest.trees) {
    add(tree_header_name(tree), "tree.hpp.mustache", tree_header(plan, tree, constants, bounds));
    add(tree_source_name(tree), "tree.cpp.mustache", tree_source(plan, tree));
  }
  for (const DeviceLink& link : links) {
    add(link_header_name(plan.robot.devices[link.device]), "link.hpp.mustache", link_header(plan, link));
  }
  return files;
}

std::vector<OutputFile> render_files(const Plan& plan, const ProvenBounds& bounds, const std::string& data_dir,
                                     Diagnostics& diagnostics) {
  Templates templates(data_dir + "/templates");
  std::vector<OutputFile> files;
  for (const TemplateData& file : plan_files(plan, bounds, data_dir, diagnostics))
    files.push_back({file.name, templates.fill(file.template_name, file.data)});
  return files;
}

std::vector<std::string> output_names(const Robot& robot, const Forest& forest) {
  std::vector<std::string> names(std::begin(kFixedFiles), std::end(kFixedFiles));
  for (const Tree& tree : forest.trees) {
    names.push_back(tree_header_name(tree));
    names.push_back(tree_source_name(tree));
  }
  for (std::string& name : link_header_names(robot, forest)) names.push_back(std::move(name));
  return names;
}

}  // namespace finemote::gen
