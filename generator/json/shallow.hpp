// Text to a document of the JSON library, which copies and prints what is nested by recursion.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "generator/json/parse.hpp"

namespace finemote::gen::json {

/// Discarded where the text is no JSON, or is nested deeper than kMaxDepth. `Document` is one of the JSON library.
template <class Document>
Document parse_shallow(const std::string& text) {
  bool is_deep = false;
  const auto look = [&is_deep](int depth, nlohmann::detail::parse_event_t, Document&) {
    is_deep = is_deep || depth > kMaxDepth;
    return !is_deep;
  };
  Document document = Document::parse(text, look, false);
  return is_deep ? Document(nlohmann::json::value_t::discarded) : document;
}

}  // namespace finemote::gen::json
