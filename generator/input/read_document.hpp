// The input to its XML: read, and expanded where it is xacro.
#pragma once

#include <optional>

#include "generator/diagnostic/diagnostics.hpp"
#include "generator/input/input.hpp"
#include "generator/xacro/expand.hpp"
#include "generator/xml/node.hpp"

namespace finemote::gen {

/// Reports FM0001 for arguments of a file that is no xacro, for a timing model and for words of `packages` of another
/// form, and what xml::read_source, xml::parse and xacro::expand report; none after an error.
std::optional<xml::Document> read_document(const Input& input, Sources& sources, Diagnostics& diagnostics);

/// FM0001 for arguments of a file that is no xacro: true where there are some.
bool refuse_arguments(const std::string& path, const std::vector<std::pair<std::string, std::string>>& arguments,
                      Diagnostics& diagnostics);

/// `name=dir` words, each folder from the working directory. Reports FM0001 for words of another form.
std::vector<std::pair<std::string, std::string>> package_folders(const std::vector<std::string>& words,
                                                                 Diagnostics& diagnostics);

/// `name:=value` words as xacro takes them.
xacro::Arguments xacro_arguments(const std::vector<std::pair<std::string, std::string>>& words);

/// The arguments of an input as words `name:=value`, sorted, each name once.
std::vector<std::string> argument_words(const Input& input);

}  // namespace finemote::gen
