// An error number of the system to words for a message.
#pragma once

#include <string>

namespace finemote::gen {

/// `no space left on device` for ENOSPC: the system's own words, beginning in lower case.
std::string system_reason(int error);

}  // namespace finemote::gen
