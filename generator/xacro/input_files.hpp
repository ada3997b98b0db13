// The files a document is made of: what it includes, parsed once, and the YAML it loads.
#pragma once

#include <memory>
#include <string>
#include <unordered_map>
#include <vector>

#include "generator/diagnostic/source.hpp"
#include "generator/xacro/limits.hpp"
#include "generator/xacro/warnings.hpp"
#include "generator/xml/node.hpp"

namespace finemote::gen::xacro {

/// Files an expansion has read besides its entry, by the path they were opened with, in the order of first use.
struct Dependencies {
  std::vector<std::string> files;
};

class InputFiles {
 public:
  InputFiles(Sources& sources, Dependencies& dependencies) : sources_(sources), dependencies_(dependencies) {}

  /// The document of the entry; fails when it is no XML.
  /// @param path  by which others may include it
  const xml::Document& read_entry(const SourceFile& entry, const std::string& path);

  /// The document of an included file; null when it is `is_optional` and not there. Fails at `at`.
  const xml::Document* include(const std::string& file, bool is_optional, const Position& at);

  /// The text of a YAML file; null when it is empty. Fails at `at`.
  const SourceFile* open_yaml(const std::string& file, const Position& at);

  /// The files that a path with wild cards means, in order; the path itself when it has none. Fails at `at`.
  /// @param specification  the path as it was written, for messages
  std::vector<std::string> matching(const std::string& path, const std::string& specification, const Position& at,
                                    Warnings& warnings);

 private:
  const xml::Document* read_document(const std::string& file, const Position& at);
  void add_dependency(const std::string& file);

  Sources& sources_;
  Dependencies& dependencies_;
  std::unordered_map<std::string, std::unique_ptr<const xml::Document>> documents_;  // by path
  std::size_t folders_left_ = kMaxFolders;
};

}  // namespace finemote::gen::xacro
