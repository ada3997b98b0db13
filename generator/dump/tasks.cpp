#include "generator/dump/dump.hpp"
#include "generator/timing/json.hpp"

namespace finemote::gen {

Json dump_tasks(const timing::Model& model) { return {{"stage", "tasks"}, {"model", timing::model_json(model)}}; }

}  // namespace finemote::gen
