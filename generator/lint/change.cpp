#include "generator/lint/change.hpp"

#include <fmt/format.h>

#include <optional>
#include <variant>

#include "generator/xml/parse.hpp"

namespace finemote::gen {
namespace {

using Path = std::vector<const xml::Node*>;  ///< from the root to an element

/// Fills `path` with the way to the element that begins at `at`; empty where there is none.
bool find_path(const xml::Node& node, const Position& at, Path& path) {
  path.push_back(&node);
  if (node.is_element() && node.at.line == at.line && node.at.column == at.column) return true;
  for (const xml::Node& child : node.children) {
    if (find_path(child, at, path)) return true;
  }
  path.pop_back();
  return false;
}

Path path_of(const xml::Document& document, const Position& at) {
  Path path;
  find_path(document.root, at, path);
  return path;
}

/// Elements of xacro, and of any other language that is mixed in, have a prefix.
bool is_foreign(const xml::Node& node) { return node.is_element() && node.name.find(':') != std::string::npos; }

/// Why the element was not written where it stands in the robot; empty: it was.
std::string origin(const Position& at) {
  if (at.via == nullptr) return {};
  const char* kind = at.via->kind == Expansion::Kind::macro ? "macro" : "the included file";
  return fmt::format("it comes from {} '{}'", kind, at.via->name);
}

/// The way to an element in the text of its file as it is, and why it may not be edited there; empty: it may.
struct Place {
  Path path;
  std::string obstacle;
};

/// @param document  none: the file is no XML without xacro
Place place_of(const std::optional<xml::Document>& document, const Position& at) {
  if (!document) return {{}, "its file is no XML by itself"};
  Path path = path_of(*document, at);
  if (path.empty()) return {{}, "it is not written as an element of this file"};
  for (std::size_t i = path.size() - 1; i-- > 0;) {
    if (is_foreign(*path[i])) return {path, fmt::format("it stands in <{}>", path[i]->name)};
  }
  return {path, {}};
}

/// Why an element may not go over what stands between it and another one; empty: it may.
std::string obstacle_between(const Path& first, const Path& second) {
  if (second.size() < 2 || first.size() != second.size() || first[first.size() - 2] != second[second.size() - 2])
    return "the two do not stand side by side in one element";
  const auto& siblings = second[second.size() - 2]->children;
  const auto place = [&](const Path& path) { return static_cast<std::size_t>(path.back() - siblings.data()); };
  for (std::size_t i = place(first); i < place(second); ++i) {
    if (is_foreign(siblings[i])) return fmt::format("<{}> stands between the two", siblings[i].name);
  }
  return place(first) < place(second) ? "" : "it stands before the other one";
}

std::optional<xml::Document> read_document(const SourceFile& file) {
  auto document = xml::read_document(file);
  if (!std::holds_alternative<xml::Document>(document)) return std::nullopt;
  return std::get<xml::Document>(std::move(document));
}

Change refused(std::string reason) { return {{}, std::move(reason)}; }

}  // namespace

Change move_before(const Position& element, const Position& target) {
  if (std::string reason = origin(element); !reason.empty()) return refused(reason);
  if (const std::string reason = origin(target); !reason.empty()) return refused("the other one" + reason.substr(2));
  if (element.file == nullptr || element.file != target.file) return refused("the two are not in one file");
  const auto document = read_document(*element.file);
  const Place from = place_of(document, element);
  if (!from.obstacle.empty()) return refused(from.obstacle);
  const Path to = path_of(*document, target);
  if (std::string reason = obstacle_between(to, from.path); !reason.empty()) return refused(reason);
  const auto taken = find_element(element);
  const auto before = find_element(target);
  if (!taken || !before) return refused("it is not written as an element of this file");
  const SourceFile& file = *element.file;
  const ElementExtent whole = with_comments(file, *taken);
  const std::size_t place = with_comments(file, *before).begin;
  if (whole.begin < place) return refused("the two share a line");
  return {{{&file, place, place, file.text.substr(whole.begin, whole.end - whole.begin)},
           {&file, whole.begin, whole.end, {}}},
          {}};
}

Change remove_element(const Position& element) {
  if (std::string reason = origin(element); !reason.empty()) return refused(reason);
  const auto document = read_document(*element.file);
  const Place place = place_of(document, element);
  if (!place.obstacle.empty()) return refused(place.obstacle);
  const auto extent = find_element(element);
  if (!extent) return refused("it is not written as an element of this file");
  return {{{element.file, extent->begin, extent->end, {}}}, {}};
}

}  // namespace finemote::gen
