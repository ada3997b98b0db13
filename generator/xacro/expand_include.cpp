// xacro:include.
#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cstring>

#include "generator/xacro/expander.hpp"
#include "generator/xacro/source_failure.hpp"

namespace finemote::gen::xacro {
namespace {

constexpr std::size_t kIncludeSteps = 500;  // the system is asked for the file each time

}  // namespace

void Expander::expand_include(const Node& source, const Context& context, Sink& out, bool has_next) {
  const xml::Attribute& name = required(source, "filename", context);
  check_attributes(source, {"filename", "ns", "optional"}, context);
  const Position at = place(name.value_at, context);
  Context inner = context;
  const xml::Attribute* space = source.attribute("ns");
  if (space != nullptr && !space->value.empty()) {
    inner = inside_of(text_of(space->value, place(space->value_at, context), *context.scope), context);
  }
  const xml::Attribute* optional = source.attribute("optional");
  const bool is_optional = optional != nullptr && boolean_of(Value(optional->value), "None", at);
  if (std::any_of(source.children.begin(), source.children.end(), [](const Node& n) { return n.is_element(); })) {
    warn(code::xacro_ignored, place(source.at, context), "Child elements of a <xacro:include> tag are ignored");
  }
  const std::size_t begin = out.end();
  for (const std::string& file : files_of(text_of(name.value, at, *context.scope), at)) {
    include_file(source, file, is_optional, inner, out);
  }
  const auto mark = mark_.remove_comments(out, begin, has_next);
  mark_.set(out, mark);
}

std::vector<std::string> Expander::files_of(const std::string& specification, const Position& at) {
  const std::string path = absolute_name(specification);
  if (path.find_first_of("*[?") == std::string::npos) return {path};
  files::Denial denial;
  auto files = sources_.access().match(path, folders_left_, denial);
  if (denial.is_outside) fail_outside(specification, denial, at);
  if (folders_left_ == 0) throw Failure{code::xacro_limit, "the wild cards go through too many folders", at};
  if (files.empty()) {
    warn(code::xacro_no_match, at, fmt::format("Include tag's filename spec \"{}\" matched no files.", path));
  }
  return files;
}

/// New tables of properties and macros, known in the enclosing ones by the name of the namespace.
Context Expander::inside_of(const std::string& name_space, const Context& context) {
  auto scope = std::make_unique<Scope>(Scope::Kind::name_space, context.scope);
  auto macros = std::make_unique<MacroScope>();
  const Context inner{scope.get(), macros.get(), context.via, context.is_placed};
  context.scope->set(name_space, {NamespaceRef{scope.get()}, false, {}});
  context.macros->define(name_space, macros.get());
  keep(*context.scope);
  kept_scopes_.push_back(std::move(scope));
  kept_macros_.push_back(std::move(macros));
  return inner;
}

void Expander::include_file(const Node& source, const std::string& file, bool is_optional, const Context& context,
                            Sink& out) {
  const Position at = place(source.at, context);
  if (++calls_ > kMaxCalls) throw Failure{code::xacro_limit, "too many included files", at};
  if (files_.size() > kMaxIncludes) {
    throw Failure{
        code::xacro_limit,
        fmt::format("'{}' is included inside itself without end, or {} includes are nested", file, kMaxIncludes), at};
  }
  visit(source, context, kIncludeSteps);
  add_dependency(file);
  const SystemError missing = why_unreadable(file, sources_, at);
  if (missing.number != 0) {
    if (is_optional) return;
    throw Failure{code::xacro_include,
                  fmt::format("{0}: {1} [Errno {2}] {0}: '{1}'", missing.text, file, missing.number), at};
  }
  const xml::Document* document = read_document(file, at);
  files_.push_back(file);
  Context inner = context;
  inner.via = sources_.add(Expansion{Expansion::Kind::include, file, at});
  inner.is_placed = false;
  Node root;  // dropped but for its namespaces
  expand_attributes(document->root, inner, root);
  warn_of_lost_attributes(document->root, inner, out);
  Sink content{out.element, out.id, out.end()};
  expand_children(document->root, inner, content);
  lift_namespaces(root, out.element, at);
  files_.pop_back();
}

const xml::Document* Expander::read_document(const std::string& file, const Position& at) {
  auto& document = documents_[file];
  if (document) return document.get();
  const Expansion* via = sources_.add(Expansion{Expansion::Kind::include, file, at});
  const SourceFile* source = read_text(file, sources_, at);
  auto parsed = xml::read_document(*source);
  if (const auto* broken = std::get_if<xml::Malformed>(&parsed)) throw failure_of(*broken, via);
  document = std::make_unique<const xml::Document>(std::move(std::get<xml::Document>(parsed)));
  return document.get();
}

void Expander::add_dependency(const std::string& file) {
  auto& files = dependencies_.files;
  if (std::find(files.begin(), files.end(), file) == files.end()) files.push_back(file);
}

}  // namespace finemote::gen::xacro
