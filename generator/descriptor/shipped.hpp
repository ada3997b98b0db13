// Which descriptors, board and chip files are those the tool was built with: a test holds them to their schemas.
#pragma once

#include <string_view>

namespace finemote::gen {

/// Whether `text` is one of them, to the last byte. Any other file has to be held to its schema, wherever it lies.
bool is_shipped(std::string_view text);

}  // namespace finemote::gen
