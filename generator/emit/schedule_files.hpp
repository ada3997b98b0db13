// The files that compose the trees into period buckets.
#pragma once

#include "generator/emit/bounds.hpp"

namespace finemote::gen {

Data schedule_header(const Plan& plan, const ProvenBounds& bounds);
Data schedule_source(const Plan& plan, const ProvenBounds& bounds);

}  // namespace finemote::gen
