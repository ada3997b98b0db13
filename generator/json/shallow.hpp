// Text to a document of the JSON library, which copies and prints what is nested by recursion.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "generator/json/parse.hpp"

namespace finemote::gen::json {

/// Discarded where the text is no JSON, or is nested deeper than kMaxDepth. `Document` is one of the JSON library.
/// @param watch  is told every event of the parser and what it has read: `watch(event, parsed)`
template <class Document, class Watch>
Document parse_shallow(const std::string& text, Watch watch) {
  bool is_deep = false;
  const auto look = [&](int depth, nlohmann::detail::parse_event_t event, Document& parsed) {
    is_deep = is_deep || depth > kMaxDepth;
    watch(event, parsed);
    return !is_deep;
  };
  Document document = Document::parse(text, look, false);
  return is_deep ? Document(nlohmann::json::value_t::discarded) : document;
}

template <class Document>
Document parse_shallow(const std::string& text) {
  return parse_shallow<Document>(text, [](nlohmann::detail::parse_event_t, const Document&) {});
}

}  // namespace finemote::gen::json
