#include "generator/xml/parse.hpp"

#include <expat.h>

#include <algorithm>
#include <memory>

#include "generator/xml/locate.hpp"
#include "generator/xml/prefixes.hpp"

namespace finemote::gen::xml {
namespace {

struct FreeParser {
  void operator()(XML_Parser parser) const { XML_ParserFree(parser); }
};
using ParserHandle = std::unique_ptr<XML_ParserStruct, FreeParser>;

bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\n'; }

/// Where the attributes of a start tag stand: reads `name = "value"` one after the other.
class TagScanner {
 public:
  TagScanner(std::string_view text, std::size_t tag) : text_(text), at_(tag) {
    while (at_ < text_.size() && !is_blank(text_[at_]) && text_[at_] != '>') ++at_;  // '<' and the element's name
  }

  struct Place {
    std::size_t name;
    std::size_t value;
  };

  /// Offsets of the next attribute, which the caller knows to be there and well-formed.
  Place next() {
    skip_blanks();
    const std::size_t name = at_;
    at_ = std::min(text_.find('=', at_), text_.size() - 1) + 1;
    skip_blanks();
    const char quote = at_ < text_.size() ? text_[at_] : '"';
    const std::size_t value = at_ + 1;
    at_ = std::min(text_.find(quote, value), text_.size() - 1) + 1;
    return {name, value};
  }

 private:
  void skip_blanks() {
    while (at_ < text_.size() && is_blank(text_[at_])) ++at_;
  }
  std::string_view text_;
  std::size_t at_;
};

/// Receives expat's events and grows the tree; `open_` holds the elements whose end tag has not come.
class Builder {
 public:
  explicit Builder(const SourceFile& file) : file_(file), locator_(file), parser_(XML_ParserCreate("UTF-8")) {
    XML_SetUserData(parser_.get(), this);
    XML_SetElementHandler(
        parser_.get(), [](void* self, const char* name, const char** attributes) { of(self).start(name, attributes); },
        [](void* self, const char*) { of(self).end(); });
    XML_SetCharacterDataHandler(parser_.get(), [](void* self, const char* text, int size) {
      of(self).characters({text, static_cast<std::size_t>(size)});
    });
    XML_SetCdataSectionHandler(
        parser_.get(), [](void* self) { of(self).start_cdata(); }, [](void* self) { of(self).in_cdata_ = false; });
    XML_SetCommentHandler(parser_.get(), [](void* self, const char* text) { of(self).comment(text); });
    XML_SetProcessingInstructionHandler(
        parser_.get(), [](void* self, const char* target, const char* data) { of(self).instruction(target, data); });
    XML_SetDoctypeDeclHandler(
        parser_.get(),
        [](void* self, const char*, const char*, const char*, int) { of(self).in_document_type_ = true; },
        [](void* self) { of(self).in_document_type_ = false; });
  }

  std::variant<Document, Malformed> run() {
    const XML_Status status =
        XML_Parse(parser_.get(), file_.text.data(), static_cast<int>(file_.text.size()), XML_TRUE);
    if (failure_) return std::move(*failure_);
    if (status != XML_STATUS_OK) return name_open_tag(describe_parser_failure());
    return std::move(document_);
  }

 private:
  static Builder& of(void* self) { return *static_cast<Builder*>(self); }

  [[nodiscard]] std::size_t offset() const {
    return static_cast<std::size_t>(std::max<XML_Index>(XML_GetCurrentByteIndex(parser_.get()), 0));
  }
  Position here() { return locator_.at(offset()); }

  Malformed describe_failure(std::string_view words, Code code) {
    return {here(),
            std::string(words),
            static_cast<std::uint32_t>(XML_GetCurrentLineNumber(parser_.get())),
            static_cast<std::uint32_t>(XML_GetCurrentColumnNumber(parser_.get())),
            code,
            {},
            {},
            false};
  }

  Malformed describe_parser_failure() {
    return describe_failure(XML_ErrorString(XML_GetErrorCode(parser_.get())), code::malformed_xml);
  }

  /// An end tag that does not fit, or none at all, is a mistake at the start tag as often as where it shows.
  Malformed name_open_tag(Malformed failure) {
    const XML_Error error = XML_GetErrorCode(parser_.get());
    const bool is_about_tags = error == XML_ERROR_TAG_MISMATCH || error == XML_ERROR_NO_ELEMENTS;
    if (!is_about_tags || open_.empty()) return failure;
    failure.open = open_.back().at;
    failure.open_name = open_.back().name;
    failure.open_has_children = std::any_of(open_.back().children.begin(), open_.back().children.end(),
                                            [](const Node& child) { return child.is_element(); });
    return failure;
  }

  void stop(std::string_view words, Code code) {
    if (!failure_) failure_ = describe_failure(words, code);
    XML_StopParser(parser_.get(), XML_FALSE);
  }

  void start(const char* name, const char** attributes) {
    if (open_.size() >= kMaxDepth) return stop("elements are nested too deeply", code::nested_too_deeply);
    Node element;
    element.name = name;
    element.at = here();
    read_attributes(element, attributes);
    if (const auto wrong = prefixes_.enter(element); !wrong.empty()) return stop(wrong, code::malformed_xml);
    open_.push_back(std::move(element));
  }

  void read_attributes(Node& element, const char** attributes) {
    const std::size_t tag = offset();
    // Inside the text of an entity the source holds a reference, no tag: all its places are the reference.
    const bool in_source = tag < file_.text.size() && file_.text[tag] == '<';
    const auto written = static_cast<std::size_t>(XML_GetSpecifiedAttributeCount(parser_.get()));
    TagScanner scanner(file_.text, tag);
    element.attributes.reserve(written);
    for (std::size_t i = 0; attributes[i] != nullptr; i += 2) {
      Attribute a{attributes[i], attributes[i + 1], element.at, element.at};
      if (in_source && i < written) {
        const auto place = scanner.next();
        a.at = locator_.at(place.name);
        a.value_at = locator_.at(place.value);
      }
      element.attributes.push_back(std::move(a));
    }
  }

  void end() {
    if (failure_) return;  // expat still closes the empty element it was stopped in
    Node element = std::move(open_.back());
    open_.pop_back();
    prefixes_.leave();
    if (open_.empty()) {
      document_.root = std::move(element);
      root_closed_ = true;
    } else {
      open_.back().children.push_back(std::move(element));
    }
  }

  void characters(std::string_view text) {
    if (open_.empty()) return;
    auto& children = open_.back().children;
    const auto kind = in_cdata_ ? Node::Kind::cdata : Node::Kind::text;
    if (!in_cdata_ && (children.empty() || children.back().kind != kind)) add(kind, {}, {});
    children.back().text += text;
  }

  void start_cdata() {
    add(Node::Kind::cdata, {}, {});
    in_cdata_ = true;
  }

  void comment(const char* text) { add(Node::Kind::comment, {}, text); }
  void instruction(const char* target, const char* data) { add(Node::Kind::instruction, target, data); }

  void add(Node::Kind kind, std::string_view name, std::string_view text) {
    if (in_document_type_) return;
    Node node;
    node.kind = kind;
    node.name = name;
    node.text = text;
    node.at = here();
    place().push_back(std::move(node));
  }

  std::vector<Node>& place() {
    if (!open_.empty()) return open_.back().children;
    return root_closed_ ? document_.epilog : document_.prolog;
  }

  const SourceFile& file_;
  Locator locator_;
  ParserHandle parser_;
  Prefixes prefixes_;
  Document document_;
  std::vector<Node> open_;
  std::optional<Malformed> failure_;
  bool in_cdata_ = false;
  bool root_closed_ = false;
  bool in_document_type_ = false;
};

}  // namespace

std::string closing_hint(const Malformed& malformed) {
  const std::string hint = "close it with </" + malformed.open_name + ">";
  return malformed.open_has_children ? hint : hint + ", or end its start tag in '/>'";
}

std::variant<Document, Malformed> read_document(const SourceFile& file) { return Builder(file).run(); }

std::optional<Document> parse(const SourceFile& file, Diagnostics& diagnostics) {
  auto result = read_document(file);
  if (auto* document = std::get_if<Document>(&result)) return std::move(*document);
  const auto& failure = std::get<Malformed>(result);
  auto& finding = diagnostics.error(failure.code, failure.at, failure.words);
  if (!failure.open_name.empty()) {
    finding.note("<" + failure.open_name + "> is still open", failure.open).hint(closing_hint(failure));
  }
  return std::nullopt;
}

}  // namespace finemote::gen::xml
