// The stages of the pipeline as JSON, to look at: one writer each. Members may change with any version.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "generator/emit/plan_files.hpp"
#include "generator/forest/forest.hpp"
#include "generator/model/robot.hpp"
#include "generator/schedule/schedule.hpp"
#include "generator/timing/model.hpp"
#include "generator/xml/node.hpp"

namespace finemote::gen {

using Json = nlohmann::ordered_json;

/// The XML after xacro, as one text.
Json dump_document(const xml::Document& document);

/// The checked robot; devices, buses and segments stand by their names.
Json dump_model(const Robot& robot);

/// The trees, and the order of all devices.
Json dump_forest(const Robot& robot, const Forest& forest);

/// Buckets, crossings between them, what every role is bound to, and transfer slots.
Json dump_schedule(const Robot& robot, const Schedule& schedule);

/// What the analysis is given, as `analyze --format json` shows it in `model`.
Json dump_tasks(const timing::Model& model);

/// What the templates are given: for each generated file its template, and the values of the keys the template names.
/// @param templates  the folder of templates
Json dump_plan(const std::vector<TemplateData>& files, const std::string& templates);

}  // namespace finemote::gen
