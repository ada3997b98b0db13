// The tags of xacro, one function each.
#include <fmt/format.h>

#include <algorithm>

#include "generator/diagnostic/printable.hpp"
#include "generator/diagnostic/suggest.hpp"
#include "generator/xacro/block.hpp"
#include "generator/xacro/expander.hpp"
#include "generator/xacro/limits.hpp"
#include "generator/xacro/tag.hpp"
#include "generator/xml/characters.hpp"

namespace finemote::gen::xacro {
namespace {

constexpr std::size_t kIncludeSteps = 500;  // the system is asked for the file each time

/// A computed name of an element or attribute.
void insist_on_name(const xml::Node& tag, const std::string& name, const Position& at) {
  if (name.empty()) throw Failure{code::xacro_attribute, tag.name + ": empty name", at};
  if (!xml::is_name(name))
    throw Failure{code::xacro_no_xml, fmt::format("{}: '{}' cannot be a name in XML", tag.name, printable(name)), at};
}

[[noreturn]] void fail_block(const std::string& name, const Context& context, const Position& at) {
  std::vector<std::string> blocks;
  for (const std::string& visible : context.scope->names()) {
    const auto plain = visible.find_first_not_of('*');
    if (plain != 0 && plain != std::string::npos) blocks.push_back(visible.substr(plain));
  }
  const std::string hint = did_you_mean(name, blocks);
  throw Failure{code::xacro_block,
                fmt::format("Undefined block \"{}\"", name),
                at,
                {},
                hint.empty() ? std::vector<std::string>{} : std::vector<std::string>{hint}};
}

}  // namespace

/// False when no tag of xacro itself has that name.
bool Expander::expand_tag(std::string_view tag, const Node& source, const Context& context, Sink& out, bool has_next) {
  if (tag == "property") return expand_property(source, context, out, has_next), true;
  if (tag == "if" || tag == "unless") return expand_condition(source, context, out, has_next), true;
  if (tag == "insert_block") return expand_block(source, context, out), true;
  if (tag == "macro") return define_macro(source, context, out, has_next), true;
  if (tag == "include") return expand_include(source, context, out, has_next), true;
  if (tag == "arg") return expand_argument(source, context, out, has_next), true;
  if (tag == "call") return call_by_name(source, context, out, has_next), true;
  if (tag == "element") return expand_renamed(source, context, out, has_next), true;
  if (tag == "attribute") return expand_attribute(source, context, out), true;
  return false;
}

/// The comments before the child at `end` belong to a tag that vanishes.
void Expander::remove_comments(Sink& out, std::size_t end, bool has_next) {
  const auto mark = mark_.remove_comments(out, end, has_next);
  mark_.set(out, mark);
}

void Expander::expand_property(const Node& source, const Context& context, Sink& out, bool has_next) {
  remove_comments(out, out.end(), has_next);
  properties_.define(source, context);
}

void Expander::expand_condition(const Node& source, const Context& context, Sink& out, bool has_next) {
  const auto mark = mark_.remove_comments(out, has_next);
  const xml::Attribute& value = required(source, "value", context);
  check_attributes(source, {"value"}, context, warnings_);
  const Position at = context.place(value.value_at);
  const bool holds = condition_of(evaluator_.value_of(value.value, at, *context.scope), value.value, at);
  if (holds == (source.name == "xacro:if")) {
    // ROS xacro evaluates the attribute once more here; that shows only where a call has an effect.
    if (value.value.find('(') != std::string::npos) evaluator_.value_of(value.value, at, *context.scope);
    expand_in_place(source, context, out);
  }
  mark_.set(out, mark);
}

/// xacro:element: the element gets the name its attribute evaluates to, and is then processed as any other.
void Expander::expand_renamed(const Node& source, const Context& context, Sink& out, bool has_next) {
  const xml::Attribute& name = required(source, "xacro:name", context);
  const Position at = context.place(name.value_at);
  Node renamed = source;
  renamed.name = evaluator_.text_of(name.value, at, *context.scope);
  insist_on_name(source, renamed.name, at);
  std::erase_if(renamed.attributes, [](const xml::Attribute& a) { return a.name == "xacro:name"; });
  trail_.count("too many macro calls", at);
  renamed_.push_back(std::move(renamed));
  const Level level = trail_.enter_block("maximum recursion depth exceeded", at);
  expand_element(renamed_.back(), context, out, has_next);
}

/// xacro:attribute: sets an attribute of the element around it.
void Expander::expand_attribute(const Node& source, const Context& context, Sink& out) {
  const xml::Attribute& name = required(source, "name", context);
  const xml::Attribute& value = required(source, "value", context);
  xml::Attribute attribute;
  attribute.at = context.place(name.value_at);
  attribute.value_at = context.place(value.value_at);
  attribute.name = evaluator_.text_of(name.value, attribute.at, *context.scope);
  attribute.value = evaluator_.text_of(value.value, attribute.value_at, *context.scope);
  insist_on_name(source, attribute.name, attribute.at);
  set_attribute(out.element, std::move(attribute));
}

void Expander::expand_argument(const Node& source, const Context& context, Sink& out, bool has_next) {
  const xml::Attribute& name = required(source, "name", context);
  const xml::Attribute& otherwise = required(source, "default", context);
  check_attributes(source, {"name", "default"}, context, warnings_);
  if (arguments_.ask(name.value) == nullptr) {
    const Position at = context.place(otherwise.value_at);
    arguments_.set_default(name.value, evaluator_.text_of(otherwise.value, at, *context.scope));
  }
  remove_comments(out, out.end(), has_next);
}

/// insert_block: evaluates the block's text again, with the names visible here.
void Expander::expand_block(const Node& source, const Context& context, Sink& out) {
  const xml::Attribute& name = required(source, "name", context);
  check_attributes(source, {"name"}, context, warnings_);
  const Position at = context.place(source.at);
  auto found = context.scope->find("**" + name.value);
  const bool content_only = static_cast<bool>(found);
  if (!found) found = context.scope->find("*" + name.value);
  const std::shared_ptr<const Block> block = found ? block_of(found.property->value) : nullptr;
  if (!block) fail_block(name.value, context, at);
  trail_.count("too many macro calls and inserted blocks", at);

  const Level level = trail_.enter_block("maximum recursion depth exceeded: a block inserts itself", at);
  const Context inner{context.scope, context.macros, block->via, block->is_placed};
  if (!content_only) return expand_plain_element(*block->node, inner, out);
  expand_in_place(*block->node, inner, out);
}

void Expander::define_macro(const Node& source, const Context& context, Sink& out, bool has_next) {
  remove_comments(out, out.end(), has_next);
  const xml::Attribute& name = required(source, "name", context);
  check_attributes(source, {"name", "params"}, context, warnings_);
  const Position at = context.place(name.value_at);
  auto macro = std::make_shared<Macro>();
  macro->name = name.value;
  if (macro->name == "call") throw Failure{code::xacro_macro, "Invalid use of macro name 'call'", at};
  if (macro->name.find('.') != std::string::npos) {
    throw Failure{code::xacro_macro, "macro names must not contain '.' (reserved for namespaces): " + macro->name, at};
  }
  if (macro->name.starts_with("xacro:")) {
    warnings_.add(code::xacro_macro_prefix, at, "macro names must not contain prefix 'xacro:': " + macro->name);
    macro->name.erase(0, 6);
  }
  macro->file = trail_.file();
  macro->body = std::shared_ptr<const Node>(std::shared_ptr<const Node>(), &source);
  if (const auto* parameters = source.attribute("params")) {
    if (parameters->value.size() > kMaxParameters) {
      throw Failure{code::xacro_limit, "the parameters of the macro are too long", context.place(parameters->value_at)};
    }
    macro->parameters = parse_parameters(parameters->value);
  }
  context.macros->define(std::move(macro));
}

void Expander::call_by_name(const Node& source, const Context& context, Sink& out, bool has_next) {
  const xml::Attribute& macro = required(source, "macro", context);
  const Position at = context.place(macro.value_at);
  if (macro.value.empty()) throw Failure{code::xacro_call, "xacro:call is missing the 'macro' attribute", at};
  call_macro(source, evaluator_.text_of(macro.value, at, *context.scope), context, out, has_next);
}

void Expander::call_macro(const Node& source, const std::string& name, const Context& context, Sink& out,
                          bool has_next) {
  const Callee callee(source, name, context);
  const auto inside = trail_.enter_macro(callee.macro(), context.place(source.at));
  const std::size_t begin = out.end();
  run_macro(source, callee, out);
  remove_comments(out, begin, has_next);
}

void Expander::run_macro(const Node& source, const Callee& callee, Sink& out) {
  const Macro& macro = callee.macro();
  auto scope = std::make_unique<Scope>(Scope::Kind::local, callee.body().scope);
  auto macros = std::make_unique<MacroScope>(callee.body().macros);

  ParameterBinder binder(source, callee, *scope, evaluator_, properties_);
  binder.bind_arguments();
  Node blocks;
  Sink sink = output_.open(blocks);
  expand_children(source, callee.arguments(), sink);
  binder.bind_blocks(std::move(blocks));
  binder.bind_defaults();

  const Position at = callee.body().place(source.at);
  const Expansion* via = sources_.add(Expansion{Expansion::Kind::macro, macro.name, at});
  const Context inner{scope.get(), macros.get(), via, false};
  lift_namespaces(*macro.body, out.element, at);
  expand_in_place(*macro.body, inner, out);
  scopes_.close(std::move(scope), std::move(macros));
}

void Expander::expand_include(const Node& source, const Context& context, Sink& out, bool has_next) {
  const xml::Attribute& name = required(source, "filename", context);
  check_attributes(source, {"filename", "ns", "optional"}, context, warnings_);
  const Position at = context.place(name.value_at);
  Context inner = context;
  const xml::Attribute* space = source.attribute("ns");
  if (space != nullptr && !space->value.empty()) {
    const Position space_at = context.place(space->value_at);
    inner = scopes_.open_name_space(evaluator_.text_of(space->value, space_at, *context.scope), context);
  }
  const xml::Attribute* optional = source.attribute("optional");
  const bool is_optional = optional != nullptr && condition_of(Value(optional->value), "None", at);
  if (std::any_of(source.children.begin(), source.children.end(), [](const Node& n) { return n.is_element(); })) {
    warnings_.add(code::xacro_ignored, context.place(source.at), "Child elements of a <xacro:include> tag are ignored");
  }
  const std::size_t begin = out.end();
  const std::string specification = evaluator_.text_of(name.value, at, *context.scope);
  for (const std::string& file : files_.matching(trail_.absolute(specification), specification, at, warnings_)) {
    include_file(source, file, is_optional, inner, out);
  }
  remove_comments(out, begin, has_next);
}

void Expander::include_file(const Node& source, const std::string& file, bool is_optional, const Context& context,
                            Sink& out) {
  const Position at = context.place(source.at);
  trail_.check_include(file, at);
  visit(source, context, kIncludeSteps);
  const xml::Document* document = files_.include(file, is_optional, at);
  if (document == nullptr) return;
  const auto inside = trail_.enter_file(file);
  Context inner = context;
  inner.via = sources_.add(Expansion{Expansion::Kind::include, file, at});
  inner.is_placed = false;
  Node root;  // dropped but for its namespaces
  expand_attributes(document->root, inner, root);
  expand_in_place(document->root, inner, out);
  lift_namespaces(root, out.element, at);
}

}  // namespace finemote::gen::xacro
