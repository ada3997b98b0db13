// The planned robot to what fills the templates of its files.
#pragma once

#include <string>
#include <vector>

#include "generator/diagnostic/diagnostics.hpp"
#include "generator/emit/bounds.hpp"

namespace finemote::gen {

/// A file to write, before its template is filled.
struct TemplateData {
  std::string name;           ///< of the file
  std::string template_name;  ///< below templates/
  Data data;
};

/// What fills the templates of all sources, in the order of render_files. `data_dir` holds schemas/. Reports what
/// render_files reports.
std::vector<TemplateData> plan_files(const Plan& plan, const ProvenBounds& bounds, const std::string& data_dir,
                                     Diagnostics& diagnostics);

}  // namespace finemote::gen
