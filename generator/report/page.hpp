// Finished values to a report: one page that needs no network, no script to read its results, and no other file.
#pragma once

#include <string>

#include "generator/graph/forest_view.hpp"
#include "generator/report/body.hpp"
#include "generator/report/documents.hpp"
#include "generator/report/timeline.hpp"

namespace finemote::gen::report {

struct Contents {
  ForestView view;
  Body body;
  timing::Model model;
  Documents documents;
  Timeline timeline;
};

/// The whole file. Nothing in it is loaded from elsewhere, which its Content-Security-Policy also forbids; scripts run
/// if their hash is the one it names.
/// @param folder  templates/report of the tool's data. Throws std::runtime_error for a
/// file that cannot be read.
std::string page_of(const Contents& contents, const std::string& folder);

}  // namespace finemote::gen::report
