#include "generator/xacro/expander.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "generator/xacro/source_failure.hpp"
#include "generator/xml/write.hpp"

namespace finemote::gen::xacro {
namespace {

constexpr std::string_view kPrefix = "xacro:";
constexpr std::size_t kNodeCost = 192;  // bytes of output bookkeeping that a node counts for at least

void set_attribute(xml::Node& node, xml::Attribute attribute) {
  for (xml::Attribute& a : node.attributes) {
    if (a.name == attribute.name) {
      a = std::move(attribute);
      return;
    }
  }
  node.attributes.push_back(std::move(attribute));
}

/// One level deeper, or a failure at the tag that asks for it.
Level enter(std::size_t& depth, std::size_t limit, const char* message, const Position& at) {
  if (depth >= limit) throw Failure{code::xacro_limit, message, at};
  return Level(depth, limit, message);
}

}  // namespace

Expander::Expander(const SourceFile& entry, const Arguments& arguments, const PackagePath& packages, Sources& sources,
                   Diagnostics& diagnostics, Dependencies& dependencies, std::ostream* messages)
    : entry_(entry),
      packages_(packages),
      sources_(sources),
      diagnostics_(diagnostics),
      dependencies_(dependencies),
      messages_(messages),
      arguments_(arguments),
      runtime_(*this) {
  define_builtins();
}

xml::Document Expander::run() {
  files_.push_back(entry_.path.empty() ? entry_.name : entry_.path);
  const std::string& path = files_.back();
  auto parsed = xml::read_document(entry_);
  if (const auto* broken = std::get_if<xml::Malformed>(&parsed)) throw failure_of(*broken, nullptr);
  const auto& source =
      *(documents_[path] = std::make_unique<const xml::Document>(std::move(std::get<xml::Document>(parsed))));

  xml::Document result;
  result.prolog = source.prolog;
  result.epilog = source.epilog;
  const Context context{&top_, &top_macros_, nullptr, false};
  result.root.name = source.root.name;
  result.root.at = source.root.at;
  expand_attributes(source.root, context, result.root);
  if (const auto* target = source.root.attribute("xacro:targetNamespace");
      target != nullptr && !target->value.empty()) {
    set_attribute(result.root, {"xmlns", text_of(target->value, target->value_at, top_), target->at, target->value_at});
  }
  Sink sink{result.root, ++elements_};
  const Arguments given = arguments_;
  expand_children(source.root, context, sink);
  warn_of_unknown_arguments(given);
  return result;
}

/// ROS xacro is silent about a `name:=value` that nobody asked for; it is mostly a slip of the pen.
void Expander::warn_of_unknown_arguments(const Arguments& given) {
  const std::vector<std::string> known(asked_.begin(), asked_.end());
  for (const auto& [name, value] : given) {
    if (asked_.contains(name)) continue;
    Diagnostic* warning =
        warn(code::xacro_unknown_argument, {&entry_},
             fmt::format("argument '{}:={}' has no effect: no <xacro:arg> declares '{}'", name, value, name));
    if (warning == nullptr) continue;
    warning->hint(known.empty() ? "the file takes no arguments" : did_you_mean(name, known));
  }
}

std::vector<std::string> Expander::location() const {
  std::vector<std::string> lines;
  const char* before = "when instantiating macro:";
  for (auto macro = calls_open_.rbegin(); macro != calls_open_.rend(); ++macro) {
    lines.push_back(fmt::format("{} {} ({})", before, (*macro)->name, (*macro)->file));
    before = "instantiated from:";
  }
  before = calls_open_.empty() ? "when processing file:" : "in file:";
  for (auto file = files_.rbegin(); file != files_.rend(); ++file) {
    lines.push_back(fmt::format("{} {}", before, *file));
    before = "included from:";
  }
  return lines;
}

/// Counts a node: a macro may pass its body again and again without an expression.
void Expander::visit(const Node& node, const Context& context, std::size_t steps) {
  std::size_t bytes = node.text.size();
  for (const xml::Attribute& a : node.attributes) bytes += a.value.size();
  try {
    runtime_.budget.visit(steps + node.attributes.size() + expression::cost_of_block(bytes));
  } catch (Failure& failure) {
    failure.at = place(node.at, context);
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
        copy.at = place(child.at, context);
        emit(std::move(copy), out.element);
      }
    }
  }
}

void Expander::expand_element(const Node& source, const Context& context, Sink& out, bool has_next) {
  if (!source.name.starts_with(kPrefix)) return expand_plain_element(source, context, out);
  const std::string_view tag = std::string_view(source.name).substr(kPrefix.size());
  if (tag == "property") return define_property(source, context, out, has_next);
  if (tag == "if" || tag == "unless") return expand_condition(source, context, out, has_next);
  if (tag == "insert_block") return expand_block(source, context, out);
  if (tag == "macro") return define_macro(source, context, out, has_next);
  if (tag == "include") return expand_include(source, context, out, has_next);
  if (tag == "arg") return expand_argument(source, context, out, has_next);
  if (tag == "call") return call_by_name(source, context, out, has_next);
  if (tag == "element") return expand_renamed(source, context, out, has_next);
  if (tag == "attribute") return expand_attribute(source, context, out);
  call_macro(source, std::string(tag), context, out, has_next);
}

void Expander::expand_plain_element(const Node& source, const Context& context, Sink& out) {
  const Level level =
      enter(output_depth_, kMaxOutputDepth, "elements are nested too deeply", place(source.at, context));
  Node element;
  element.name = source.name;
  element.at = place(source.at, context);
  expand_attributes(source, context, element);
  element.children.reserve(source.children.size());
  Sink sink{element, ++elements_};
  expand_children(source, context, sink);
  emit(std::move(element), out.element);
}

void Expander::expand_text(const Node& source, const Context& context, Sink& out) {
  Node text;
  text.kind = Node::Kind::text;
  text.at = place(source.at, context);
  text.text = text_of(source.text, text.at, *context.scope);
  emit(std::move(text), out.element);
}

/// `<!-- xacro:eval-comments -->` switches the evaluation of the following comments on, `:off` switches it off.
void Expander::expand_comment(const Node& source, const Context& context, Sink& out, bool& is_evaluated) {
  if (source.text.find("xacro:eval-comments") != std::string::npos) {
    is_evaluated = source.text.find("xacro:eval-comments:off") == std::string::npos;
    return;
  }
  Node comment = source;
  comment.at = place(source.at, context);
  if (is_evaluated) comment.text = text_of(source.text, comment.at, *context.scope);
  emit(std::move(comment), out.element);
}

void Expander::expand_condition(const Node& source, const Context& context, Sink& out, bool has_next) {
  const auto mark = mark_.remove_comments(out, has_next);
  const xml::Attribute& value = required(source, "value", context);
  check_attributes(source, {"value"}, context);
  const Position at = place(value.value_at, context);
  const bool holds = boolean_of(value_of(value.value, at, *context.scope), value.value, at);
  if (holds == (source.name == "xacro:if")) {
    // ROS xacro evaluates the attribute once more here; that shows only where a call has an effect.
    if (value.value.find('(') != std::string::npos) value_of(value.value, at, *context.scope);
    warn_of_lost_attributes(source, context, out);
    Sink content{out.element, out.id, out.end()};
    expand_children(source, context, content);
  }
  mark_.set(out, mark);
}

/// ROS xacro sets an attribute on the element its tag is in; where that one is replaced by its content, it is lost.
void Expander::warn_of_lost_attributes(const Node& source, const Context& context, const Sink& out) {
  for (const Node& child : source.children) {
    if (!child.is_element("xacro:attribute")) continue;
    Diagnostic* warning =
        warn(code::xacro_lost_attribute, place(child.at, context),
             fmt::format("ROS xacro loses this attribute: it sets it on <{}>, which it removes", source.name));
    if (warning != nullptr) warning->note(fmt::format("here it is set on <{}>", out.element.name));
  }
}

/// xacro:element: the element gets the name its attribute evaluates to, and is then processed as any other.
void Expander::expand_renamed(const Node& source, const Context& context, Sink& out, bool has_next) {
  const xml::Attribute& name = required(source, "xacro:name", context);
  const Position at = place(name.value_at, context);
  Node renamed = source;
  renamed.name = text_of(name.value, at, *context.scope);
  if (renamed.name.empty()) throw Failure{code::xacro_attribute, "xacro:element: empty name", at};
  std::erase_if(renamed.attributes, [](const xml::Attribute& a) { return a.name == "xacro:name"; });
  if (++calls_ > kMaxCalls) throw Failure{code::xacro_limit, "too many macro calls", at};
  renamed_.push_back(std::move(renamed));
  const Level level = enter(block_depth_, kMaxNestedCalls, "maximum recursion depth exceeded", at);
  expand_element(renamed_.back(), context, out, has_next);
}

/// xacro:attribute: sets an attribute of the element around it.
void Expander::expand_attribute(const Node& source, const Context& context, Sink& out) {
  const xml::Attribute& name = required(source, "name", context);
  const xml::Attribute& value = required(source, "value", context);
  xml::Attribute attribute;
  attribute.at = place(name.value_at, context);
  attribute.value_at = place(value.value_at, context);
  attribute.name = text_of(name.value, attribute.at, *context.scope);
  attribute.value = text_of(value.value, attribute.value_at, *context.scope);
  if (attribute.name.empty()) throw Failure{code::xacro_attribute, "xacro:attribute: empty name", attribute.at};
  set_attribute(out.element, std::move(attribute));
}

void Expander::expand_attributes(const Node& source, const Context& context, Node& out) {
  out.attributes.reserve(source.attributes.size());
  for (const xml::Attribute& a : source.attributes) {
    if (a.name.starts_with(kPrefix) || a.name == "xmlns:xacro") continue;
    const Position value_at = place(a.value_at, context);
    xml::Attribute attribute{a.name, text_of(a.value, value_at, *context.scope), place(a.at, context), value_at};
    output_size_ += attribute.name.size() + attribute.value.size() + kNodeCost;
    out.attributes.push_back(std::move(attribute));
  }
}

void Expander::expand_argument(const Node& source, const Context& context, Sink& out, bool has_next) {
  const xml::Attribute& name = required(source, "name", context);
  const xml::Attribute& otherwise = required(source, "default", context);
  check_attributes(source, {"name", "default"}, context);
  asked_.insert(name.value);
  if (!arguments_.contains(name.value)) {
    arguments_[name.value] = text_of(otherwise.value, place(otherwise.value_at, context), *context.scope);
  }
  const auto mark = mark_.remove_comments(out, has_next);
  mark_.set(out, mark);
}

/// insert_block: evaluates the block's text again, with the names visible here.
void Expander::expand_block(const Node& source, const Context& context, Sink& out) {
  const xml::Attribute& name = required(source, "name", context);
  check_attributes(source, {"name"}, context);
  const Position at = place(source.at, context);
  auto found = context.scope->find("**" + name.value);
  const bool content_only = static_cast<bool>(found);
  if (!found) found = context.scope->find("*" + name.value);
  const std::shared_ptr<const Block> block = found ? block_of(found.property->value) : nullptr;
  if (!block) {
    std::vector<std::string> blocks;
    for (const std::string& visible : context.scope->names()) {
      const auto plain = visible.find_first_not_of('*');
      if (plain != 0 && plain != std::string::npos) blocks.push_back(visible.substr(plain));
    }
    const std::string hint = did_you_mean(name.value, blocks);
    throw Failure{code::xacro_block,
                  fmt::format("Undefined block \"{}\"", name.value),
                  at,
                  {},
                  hint.empty() ? std::vector<std::string>{} : std::vector<std::string>{hint}};
  }
  if (++calls_ > kMaxCalls) throw Failure{code::xacro_limit, "too many macro calls and inserted blocks", at};

  const Level level =
      enter(block_depth_, kMaxNestedCalls, "maximum recursion depth exceeded: a block inserts itself", at);
  const Context inner{context.scope, context.macros, block->via, block->is_placed};
  if (!content_only) return expand_plain_element(*block->node, inner, out);
  warn_of_lost_attributes(*block->node, inner, out);
  Sink content{out.element, out.id, out.end()};
  expand_children(*block->node, inner, content);
}

void Expander::emit(Node node, Node& parent) {
  output_size_ += node.name.size() + node.text.size() + kNodeCost;
  if (output_size_ > kMaxOutput) {
    throw Failure{code::xacro_limit, fmt::format("the output is larger than {} MiB", kMaxOutput >> 20), node.at};
  }
  parent.children.push_back(std::move(node));
}

/// Declarations of XML namespaces of a dropped element (of an included file, of a macro) go to the element around it.
void Expander::lift_namespaces(const Node& from, Node& to, Position at) {
  for (const xml::Attribute& a : from.attributes) {
    if (!a.name.starts_with("xmlns:") || a.name == "xmlns:xacro") continue;
    const xml::Attribute* old = to.attribute(a.name);
    if (old != nullptr && old->value != a.value) {
      warn(code::xacro_namespace, at,
           fmt::format("inconsistent namespace redefinitions for {}: old: {} new: {} ({})", a.name, old->value, a.value,
                       files_.back()));
    } else if (old == nullptr) {
      to.attributes.push_back(a);
    }
  }
}

Position Expander::place(Position at, const Context& context) {
  if (!context.is_placed) at.via = context.via;
  return at;
}

const xml::Attribute& Expander::required(const Node& source, std::string_view name, const Context& context) const {
  const xml::Attribute* attribute = source.attribute(name);
  if (attribute != nullptr) return *attribute;
  throw Failure{code::xacro_attribute,
                fmt::format("{}: missing attribute '{}'", source.name, name),
                place(source.at, context),
                {},
                {fmt::format("write <{} {}=\"...\" ...>", source.name, name)}};
}

void Expander::check_attributes(const Node& source, std::initializer_list<std::string_view> known,
                                const Context& context) {
  for (const xml::Attribute& a : source.attributes) {
    const bool is_known = a.name.starts_with("xmlns:") || std::find(known.begin(), known.end(), a.name) != known.end();
    if (is_known) continue;
    warn(code::xacro_unknown_attribute, place(a.at, context),
         fmt::format("{}: unknown attribute(s): {}", source.name, a.name));
  }
}

/// One warning per place and text, however often the place is passed; null when it was given before.
Diagnostic* Expander::warn(Code code, const Position& at, const std::string& message) {
  constexpr std::size_t most = 1000;
  if (warned_.size() >= most || !warned_.emplace(at.file, at.line, at.column, message).second) return nullptr;
  return &diagnostics_.warning(code, at, message);
}

}  // namespace finemote::gen::xacro
