// The expansion of one document: walks the source once, in document order, and builds the output.
#pragma once

#include <deque>
#include <functional>
#include <iosfwd>
#include <memory>
#include <set>
#include <string>
#include <unordered_map>
#include <vector>

#include "generator/xacro/block.hpp"
#include "generator/xacro/comments.hpp"
#include "generator/xacro/engine.hpp"
#include "generator/xacro/expand.hpp"
#include "generator/xacro/limits.hpp"
#include "generator/xacro/macro.hpp"
#include "generator/xacro/substitution.hpp"
#include "generator/xacro/text.hpp"

namespace finemote::gen::xacro {

/// What surrounds a piece of source: the names it sees and the way it was reached.
struct Context {
  Scope* scope = nullptr;
  MacroScope* macros = nullptr;
  const Expansion* via = nullptr;
  bool is_placed = false;  ///< the nodes carry their own way already: a block that was evaluated by its caller
};

class Expander : private expression::Host, private SubstitutionHost {
 public:
  Expander(const SourceFile& entry, const Arguments& arguments, const PackagePath& packages, Sources& sources,
           Diagnostics& diagnostics, Dependencies& dependencies, std::ostream* messages);

  /// Throws Failure.
  xml::Document run();

  /// The file, macro and include the expansion stands in, as ROS xacro lists them; one line each.
  [[nodiscard]] std::vector<std::string> location() const;

 private:
  using Node = xml::Node;

  // ---- walking: expander.cpp ----
  void expand_children(const Node& source, const Context& context, Sink& out);
  void visit(const Node& node, const Context& context, std::size_t steps = 8);
  void expand_element(const Node& source, const Context& context, Sink& out, bool has_next);
  void expand_plain_element(const Node& source, const Context& context, Sink& out);
  void expand_text(const Node& source, const Context& context, Sink& out);
  void expand_comment(const Node& source, const Context& context, Sink& out, bool& is_evaluated);
  void expand_condition(const Node& source, const Context& context, Sink& out, bool has_next);
  void expand_renamed(const Node& source, const Context& context, Sink& out, bool has_next);
  void expand_attribute(const Node& source, const Context& context, Sink& out);
  void warn_of_lost_attributes(const Node& source, const Context& context, const Sink& out);
  void warn_of_unknown_arguments(const Arguments& given);
  void expand_attributes(const Node& source, const Context& context, Node& out);
  void expand_argument(const Node& source, const Context& context, Sink& out, bool has_next);
  void expand_block(const Node& source, const Context& context, Sink& out);
  void emit(Node node, Node& parent);
  void lift_namespaces(const Node& from, Node& to, Position at);

  // ---- properties: expand_property.cpp ----
  void define_property(const Node& source, const Context& context, Sink& out, bool has_next);
  void store_property(const Node& source, const Context& context, const std::string& name);
  void check_property_name(const std::string& name, const Position& at) const;
  void set_property(Scope& scope, const std::string& name, Value value, bool is_unevaluated, Position at);

  // ---- macros: expand_macro.cpp ----
  using OpenParameters = std::vector<const Parameter*>;  // that have no value yet
  struct Call {
    std::shared_ptr<const Macro> macro;
    Context arguments;  ///< where arguments and blocks are evaluated
    Context body;       ///< what encloses the scope of the body
  };
  void define_macro(const Node& source, const Context& context, Sink& out, bool has_next);
  void call_by_name(const Node& source, const Context& context, Sink& out, bool has_next);
  void call_macro(const Node& source, const std::string& name, const Context& context, Sink& out, bool has_next);
  void run_macro(const Node& source, const Call& call, Sink& out);
  void bind_arguments(const Node& source, const Call& call, Scope& scope, OpenParameters& open);
  void bind_blocks(const Node& source, const Call& call, Scope& scope, OpenParameters& open);
  void bind_defaults(const Node& source, const Call& call, Scope& scope, OpenParameters& open);
  Value default_of(const Parameter& parameter, const Call& call, const Position& at);
  void release(std::unique_ptr<Scope> scope, std::unique_ptr<MacroScope> macros);

  // ---- includes: expand_include.cpp ----
  void expand_include(const Node& source, const Context& context, Sink& out, bool has_next);
  void include_file(const Node& source, const std::string& file, bool is_optional, const Context& context, Sink& out);
  std::vector<std::string> files_of(const std::string& specification, const Position& at);
  Context inside_of(const std::string& name_space, const Context& context);
  const xml::Document* read_document(const std::string& file, const Position& at);
  void add_dependency(const std::string& file);

  // ---- texts: evaluate_text.cpp ----
  class CurrentPiece;
  std::string text_of(const std::string& text, const Position& at, Scope& scope);
  Value value_of(const std::string& text, const Position& at, Scope& scope);
  const Text& cut_of(const std::string& text);
  Value evaluate_pieces(const Text& text, const Position& at, const std::string& whole, Scope& scope);
  std::string text_of_pieces(const Text& text, const Position& at, const std::string& whole, Scope& scope);
  static void check_piece(const Text& text, std::size_t i, const Position& at, const std::string& whole);
  Value evaluate_piece(const Piece& piece, const Position& at, const std::string& whole, Scope& scope);
  std::string inner_of(const Piece& piece, const Position& at, const std::string& whole, Scope& scope);
  Value evaluate_expression(const Piece& piece, const Position& at, const std::string& whole, Scope& scope);
  Value evaluate_source(const std::string& source, Scope& scope);
  Value property_value(const Scope::Found& found, const std::string& name);
  bool boolean_of(const Value& value, const std::string& condition, const Position& at);
  static Position inside(Position at, const std::string& whole, std::size_t offset);
  /// Of the `${` or `$(` being evaluated.
  Position current_piece() const {
    return current_text_ == nullptr ? current_ : inside(current_, *current_text_, current_offset_);
  }

  // ---- Host and SubstitutionHost: host.cpp ----
  Value load_yaml(const std::string& file) override;
  std::string absolute_name(const std::string& file) override;
  const std::string* argument(const std::string& name) override;
  void say(MessageKind kind, const std::string& text, bool with_location) override;
  void deprecated(std::string_view name, std::string_view name_space) override;
  std::optional<Value> look_up(Scope& scope, const std::string& name) override;
  void keep(Scope& scope) override;
  std::string package_folder(const std::string& name) override;
  std::optional<std::string> environment(const std::string& name) override;
  [[nodiscard]] bool hides_environment() const override;
  std::string evaluate(const std::string& expression) override;
  void define_builtins();
  void define_name_space(const char* name, std::vector<std::pair<std::string, Value>> symbols);

  // ---- attributes of xacro tags ----
  [[nodiscard]] static Position place(Position at, const Context& context);
  const xml::Attribute& required(const Node& source, std::string_view name, const Context& context) const;
  void check_attributes(const Node& source, std::initializer_list<std::string_view> known, const Context& context);
  Diagnostic* warn(Code code, const Position& at, const std::string& message);

  const SourceFile& entry_;
  const PackagePath& packages_;
  Sources& sources_;
  Diagnostics& diagnostics_;
  Dependencies& dependencies_;
  std::ostream* messages_;
  Arguments arguments_;
  std::set<std::string> asked_;  // names of arguments that the document declares or reads
  Runtime runtime_;

  // Scopes that outlive their macro call, first in, last out.
  std::deque<std::unique_ptr<Scope>> kept_scopes_;
  std::deque<std::unique_ptr<MacroScope>> kept_macros_;
  Scope builtins_{Scope::Kind::builtins, nullptr};
  Scope top_{Scope::Kind::local, &builtins_};
  MacroScope top_macros_;

  std::unordered_map<std::string, std::unique_ptr<const xml::Document>> documents_;  // by path
  std::deque<Node> renamed_;                                                         // sources made by xacro:element
  std::unordered_map<std::string, std::unique_ptr<const Text>> texts_;
  std::unordered_map<std::string, std::shared_ptr<const Expression>> expressions_;

  CommentMark mark_;
  std::vector<std::string> files_;             // the file being processed, last
  std::vector<const Macro*> calls_open_;       // the macro being expanded, last
  Position current_;                           // of the text being evaluated
  const std::string* current_text_ = nullptr;  // that text, and where in it the piece begins
  std::size_t current_offset_ = 0;
  std::uint64_t elements_ = 0;  // built so far
  std::size_t calls_ = 0;
  std::size_t folders_left_ = kMaxFolders;
  std::size_t output_size_ = 0;
  std::size_t output_depth_ = 0;
  std::size_t block_depth_ = 0;
  std::size_t evaluation_depth_ = 0;
  std::set<std::tuple<const SourceFile*, std::uint32_t, std::uint32_t, std::string>> warned_;
};

}  // namespace finemote::gen::xacro
