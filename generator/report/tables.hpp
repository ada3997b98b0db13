// Documents to the tables of a report: every result is in a cell that names it (place.hpp).
#pragma once

#include <string>

#include "generator/graph/forest_view.hpp"
#include "generator/report/documents.hpp"
#include "generator/timing/model.hpp"

namespace finemote::gen::report {

/// Bounds of every chain, the worst simulated, and the worst measured where there is a run. Each row says in `data-up`
/// and `data-down` which devices carry it (places in the model, see path.hpp).
std::string chain_table(const Documents& documents, const timing::Model& model);

/// Every `<require>` with what is left of it.
std::string requirement_table(const Documents& documents);

/// Own times with what they rest on, response bounds, worst responses simulated and measured, of every device.
std::string device_table(const Documents& documents, const ForestView& view);

/// Who uses the processor, and how much of each bus is taken.
std::string processor_table(const Documents& documents);
std::string bus_table(const Documents& documents);

/// Flash and RAM by owner: devices, buses, code of types, the rest. Empty without a run that has them.
std::string image_table(const Documents& documents);

/// What the bounds assume, and whether the firmware notices where it does not hold.
std::string assumption_table(const Documents& documents);

}  // namespace finemote::gen::report
