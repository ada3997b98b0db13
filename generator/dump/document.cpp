#include "generator/dump/dump.hpp"
#include "generator/xml/write.hpp"

namespace finemote::gen {

Json dump_document(const xml::Document& document) { return {{"stage", "document"}, {"text", xml::write(document)}}; }

}  // namespace finemote::gen
