// Fills a text with holes; a hole nobody fills is a bug and says so.
#pragma once

#include <kainjow/mustache.hpp>
#include <string>
#include <vector>

namespace finemote::gen {

using Data = kainjow::mustache::data;

/// Makes `{{key}}` lists of lines: [{text: line}, ...].
Data text_list(const std::vector<std::string>& lines);

/// Fills the template file `name` below `folder`. Nothing is escaped.
/// Throws std::logic_error when the template is broken or names a key that `data` lacks, and std::runtime_error when
/// it cannot be read.
std::string fill_template(const std::string& folder, const std::string& name, const Data& data);

}  // namespace finemote::gen
