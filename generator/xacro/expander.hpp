// The expansion of one document: walks the source once, in document order, and builds the output.
#pragma once

#include <deque>
#include <iosfwd>
#include <string>

#include "generator/xacro/comments.hpp"
#include "generator/xacro/context.hpp"
#include "generator/xacro/expand.hpp"
#include "generator/xacro/macro_call.hpp"
#include "generator/xacro/output.hpp"
#include "generator/xacro/properties.hpp"
#include "generator/xacro/scopes.hpp"
#include "generator/xacro/text_evaluator.hpp"
#include "generator/xacro/trail.hpp"
#include "generator/xacro/warnings.hpp"
#include "generator/xacro/world.hpp"

namespace finemote::gen::xacro {

class Expander {
 public:
  Expander(const SourceFile& entry, const Arguments& arguments, const PackagePath& packages, Sources& sources,
           Diagnostics& diagnostics, Dependencies& dependencies, std::ostream* messages);

  /// Throws Failure.
  xml::Document run();

 private:
  using Node = xml::Node;

  // ---- the nodes of the source: expander.cpp ----
  void expand_children(const Node& source, const Context& context, Sink& out);
  void expand_in_place(const Node& source, const Context& context, Sink& out);
  void visit(const Node& node, const Context& context, std::size_t steps = 8);
  void expand_element(const Node& source, const Context& context, Sink& out, bool has_next);
  void expand_plain_element(const Node& source, const Context& context, Sink& out);
  void expand_text(const Node& source, const Context& context, Sink& out);
  void expand_comment(const Node& source, const Context& context, Sink& out, bool& is_evaluated);
  void expand_attributes(const Node& source, const Context& context, Node& out);

  // ---- xacro tags: expand_tags.cpp ----
  bool expand_tag(std::string_view tag, const Node& source, const Context& context, Sink& out, bool has_next);
  void expand_property(const Node& source, const Context& context, Sink& out, bool has_next);
  void expand_condition(const Node& source, const Context& context, Sink& out, bool has_next);
  void expand_renamed(const Node& source, const Context& context, Sink& out, bool has_next);
  void expand_attribute(const Node& source, const Context& context, Sink& out);
  void expand_argument(const Node& source, const Context& context, Sink& out, bool has_next);
  void expand_block(const Node& source, const Context& context, Sink& out);
  void define_macro(const Node& source, const Context& context, Sink& out, bool has_next);
  void call_by_name(const Node& source, const Context& context, Sink& out, bool has_next);
  void call_macro(const Node& source, const std::string& name, const Context& context, Sink& out, bool has_next);
  void run_macro(const Node& source, const Callee& callee, Sink& out);
  void expand_include(const Node& source, const Context& context, Sink& out, bool has_next);
  void include_file(const Node& source, const std::string& file, bool is_optional, const Context& context, Sink& out);
  void remove_comments(Sink& out, std::size_t end, bool has_next);

  // ---- what is lost ----
  void warn_of_lost_attributes(const Node& source, const Context& context, const Sink& out);
  void lift_namespaces(const Node& from, Node& to, Position at);

  const SourceFile& entry_;
  Sources& sources_;
  // Each part knows only parts above it.
  Warnings warnings_;
  Trail trail_;
  ArgumentTable arguments_;
  InputFiles files_;
  CurrentPiece piece_;
  World world_;
  expression::Library library_;
  TextEvaluator evaluator_;
  Properties properties_;
  Scopes scopes_;
  Output output_;
  CommentMark mark_;
  std::deque<Node> renamed_;  // sources made by xacro:element
};

}  // namespace finemote::gen::xacro
