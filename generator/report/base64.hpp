// Bytes, written as hexadecimal digits, to base64 (RFC 4648), as a Content-Security-Policy writes hashes.
#pragma once

#include <string>
#include <string_view>

namespace finemote::gen::report {

/// Requires an even number of hexadecimal digits.
std::string base64_of_hex(std::string_view digits);

}  // namespace finemote::gen::report
