// A path to a text: opens, checks and keeps one input file.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <string_view>

#include "generator/diagnostic/diagnostics.hpp"

namespace finemote::gen::xml {

inline constexpr std::size_t kMaxFileSize = std::size_t{64} << 20;  ///< bytes

/// Reads a file, or standard input for "-", as UTF-8. A byte order mark is dropped, CRLF is kept; a text whose XML
/// declaration says ISO-8859-1 is converted.
///
/// @param name  how messages call the file; `path` when empty, `<stdin>` for "-".
/// @param name_of  where what it is called depends on its bytes: the name as soon as they are known; null: `name`
/// stays.
/// @param at    who asked for the file: where the error is put; the file itself when it points nowhere.
/// Reports FM0002 (missing, a folder, a pipe, a device, no permission), FM0008 (the sandbox of `sources`), FM0003
/// (empty), FM0004 (no UTF-8; at the first wrong byte), FM0005 (over kMaxFileSize) and returns null.
const SourceFile* read_source(const std::string& path, Sources& sources, Diagnostics& diagnostics,
                              std::string_view name = {}, Position at = {},
                              const std::function<std::string(std::string_view bytes)>& name_of = nullptr);

/// Offset of the first byte that is no UTF-8 (overlong forms, surrogates and values beyond U+10FFFF are none), or npos.
std::size_t find_invalid_utf8(std::string_view text);

}  // namespace finemote::gen::xml
