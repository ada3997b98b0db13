// The files that compose the trees into period buckets.
#pragma once

#include "generator/emit/names.hpp"

namespace finemote::gen {

Data schedule_header(const Plan& plan);
Data schedule_source(const Plan& plan);

}  // namespace finemote::gen
