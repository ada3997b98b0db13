#include "generator/xacro/expander.hpp"

#include <fmt/format.h>

#include "generator/xml/characters.hpp"
#include "generator/xml/write.hpp"

namespace finemote::gen::xacro {
namespace {

constexpr std::string_view kPrefix = "xacro:";

}  // namespace

Expander::Expander(const SourceFile& entry, const Arguments& arguments, const PackagePath& packages, Sources& sources,
                   Diagnostics& diagnostics, Dependencies& dependencies, std::ostream* messages)
    : entry_(entry),
      sources_(sources),
      warnings_(diagnostics),
      trail_(entry.path.empty() ? entry.name : entry.path),
      arguments_(arguments),
      files_(sources, dependencies),
      world_({sources.access(), packages, trail_, piece_, files_, arguments_, warnings_, messages}),
      evaluator_(world_, arguments_, piece_, library_.scope()),
      properties_(evaluator_, warnings_),
      scopes_(library_.scope()) {}

xml::Document Expander::run() {
  const xml::Document& source = files_.read_entry(entry_, trail_.file());
  xml::Document result;
  result.prolog = source.prolog;
  result.epilog = source.epilog;
  const Context context = scopes_.top();
  result.root.name = source.root.name;
  result.root.at = source.root.at;
  expand_attributes(source.root, context, result.root);
  if (const auto* target = source.root.attribute("xacro:targetNamespace");
      target != nullptr && !target->value.empty()) {
    set_attribute(result.root, {"xmlns", evaluator_.text_of(target->value, target->value_at, *context.scope),
                                target->at, target->value_at});
  }
  Sink sink = output_.open(result.root);
  expand_children(source.root, context, sink);
  arguments_.warn_of_unknown(entry_, warnings_);
  return result;
}

/// Counts a node: a macro may pass its body again and again without an expression.
void Expander::visit(const Node& node, const Context& context, std::size_t steps) {
  std::size_t bytes = node.text.size();
  for (const xml::Attribute& a : node.attributes) bytes += a.value.size();
  try {
    evaluator_.budget().visit(steps + node.attributes.size() + expression::cost_of_block(bytes));
  } catch (Failure& failure) {
    failure.at = context.place(node.at);
    throw;
  }
}

void Expander::expand_children(const Node& source, const Context& context, Sink& out) {
  bool comments_evaluated = false;
  for (std::size_t i = 0; i < source.children.size(); ++i) {
    const Node& child = source.children[i];
    visit(child, context);
    switch (child.kind) {
      case Node::Kind::element:
        comments_evaluated = false;
        expand_element(child, context, out, i + 1 < source.children.size());
        break;
      case Node::Kind::text:
        expand_text(child, context, out);
        comments_evaluated = comments_evaluated && xml::is_blank_text(child.text);
        break;
      case Node::Kind::comment:
        expand_comment(child, context, out, comments_evaluated);
        break;
      default: {
        Node copy = child;
        copy.at = context.place(child.at);
        output_.add(std::move(copy), out);
      }
    }
  }
}

/// The content of an element that vanishes: a world of its own until it is complete.
void Expander::expand_in_place(const Node& source, const Context& context, Sink& out) {
  warn_of_lost_attributes(source, context, out);
  Sink content{out.element, out.id, out.end()};
  expand_children(source, context, content);
}

void Expander::expand_element(const Node& source, const Context& context, Sink& out, bool has_next) {
  if (!source.name.starts_with(kPrefix)) return expand_plain_element(source, context, out);
  const std::string_view tag = std::string_view(source.name).substr(kPrefix.size());
  if (!expand_tag(tag, source, context, out, has_next)) call_macro(source, std::string(tag), context, out, has_next);
}

void Expander::expand_plain_element(const Node& source, const Context& context, Sink& out) {
  Node element;
  element.name = source.name;
  element.at = context.place(source.at);
  const Level level = output_.enter_element(element.at);
  expand_attributes(source, context, element);
  element.children.reserve(source.children.size());
  Sink sink = output_.open(element);
  expand_children(source, context, sink);
  output_.add(std::move(element), out);
}

void Expander::expand_text(const Node& source, const Context& context, Sink& out) {
  Node text;
  text.kind = Node::Kind::text;
  text.at = context.place(source.at);
  text.text = evaluator_.text_of(source.text, text.at, *context.scope);
  output_.add(std::move(text), out);
}

/// `<!-- xacro:eval-comments -->` switches the evaluation of the following comments on, `:off` switches it off.
void Expander::expand_comment(const Node& source, const Context& context, Sink& out, bool& is_evaluated) {
  if (source.text.find("xacro:eval-comments") != std::string::npos) {
    is_evaluated = source.text.find("xacro:eval-comments:off") == std::string::npos;
    return;
  }
  Node comment = source;
  comment.at = context.place(source.at);
  if (is_evaluated) {
    comment.text = evaluator_.text_of(source.text, comment.at, *context.scope);
    if (!xml::is_comment_text(comment.text))
      throw Failure{code::xacro_no_xml, "a comment cannot hold '--' or end with '-'", comment.at};
  }
  output_.add(std::move(comment), out);
}

void Expander::expand_attributes(const Node& source, const Context& context, Node& out) {
  out.attributes.reserve(source.attributes.size());
  for (const xml::Attribute& a : source.attributes) {
    if (a.name.starts_with(kPrefix) || a.name == "xmlns:xacro") continue;
    const Position value_at = context.place(a.value_at);
    output_.add({a.name, evaluator_.text_of(a.value, value_at, *context.scope), context.place(a.at), value_at}, out);
  }
}

/// ROS xacro sets an attribute on the element its tag is in; where that one is replaced by its content, it is lost.
void Expander::warn_of_lost_attributes(const Node& source, const Context& context, const Sink& out) {
  for (const Node& child : source.children) {
    if (!child.is_element("xacro:attribute")) continue;
    Diagnostic* warning =
        warnings_.add(code::xacro_lost_attribute, context.place(child.at),
                      fmt::format("ROS xacro loses this attribute: it sets it on <{}>, which it removes", source.name));
    if (warning != nullptr) warning->note(fmt::format("here it is set on <{}>", out.element.name));
  }
}

/// Declarations of XML namespaces of a dropped element (of an included file, of a macro) go to the element around it.
void Expander::lift_namespaces(const Node& from, Node& to, Position at) {
  for (const xml::Attribute& a : from.attributes) {
    if (!a.name.starts_with("xmlns:") || a.name == "xmlns:xacro") continue;
    const xml::Attribute* old = to.attribute(a.name);
    if (old != nullptr && old->value != a.value) {
      warnings_.add(code::xacro_namespace, at,
                    fmt::format("inconsistent namespace redefinitions for {}: old: {} new: {} ({})", a.name, old->value,
                                a.value, trail_.file()));
    } else if (old == nullptr) {
      to.attributes.push_back(a);
    }
  }
}

}  // namespace finemote::gen::xacro
