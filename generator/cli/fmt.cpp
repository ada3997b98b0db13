// finemote fmt: the <finemote> elements of a file in their canonical layout.

#include <stdexcept>

#include "generator/cli/answer.hpp"
#include "generator/cli/commands.hpp"
#include "generator/cli/edited_file.hpp"
#include "generator/format/format.hpp"
#include "generator/input/input.hpp"
#include "generator/output/unified_diff.hpp"
#include "generator/xml/parse.hpp"
#include "generator/xml/read_source.hpp"

namespace finemote::gen {
namespace {

Answer answer_of(const Options& options, const SourceFile& file, const std::string& text) {
  const bool is_same = text == file.text;
  const std::string name = input_name(options.input);
  Answer answer{options.dry_run && !is_same ? kExitNo : kExitYes};
  if (options.input == "-" && !options.dry_run) {
    answer.text = text;
  } else if (options.dry_run) {
    answer.text = unified_diff("a/" + name, file.text, "b/" + name, text);
  } else if (!is_same && !options.quiet) {
    answer.text = "formatted " + options.input + "\n";
  }
  answer.document = {{"schema", "finemote.fmt/1"}, {"input", options.input}, {"changed", !is_same}};
  if (options.input == "-" || options.dry_run) answer.document["text"] = text;
  return answer;
}

/// Nothing is written over a file but XML.
void insist_on_xml(const SourceFile& file, const std::string& text) {
  const SourceFile made{file.name, file.path, text};
  Diagnostics unseen;
  if (!xml::parse(made, unseen)) throw std::logic_error("the layout of '" + file.name + "' would be no XML");
}

}  // namespace

Answer run_fmt(const Options& options, Sources& sources, Diagnostics& diagnostics) {
  const SourceFile* file = xml::read_source(options.input, sources, diagnostics);
  if (file == nullptr || !xml::parse(*file, diagnostics)) return no_answer();
  const std::string text = formatted(file->text);
  insist_on_xml(*file, text);
  const bool is_written = options.input != "-" && !options.dry_run && text != file->text;
  if (is_written) {
    const auto mark = mark_before(*file, sources, diagnostics);
    if (!mark || !write_result(options.input, *mark + text, diagnostics)) return no_answer();
  }
  return answer_of(options, *file, text);
}

}  // namespace finemote::gen
