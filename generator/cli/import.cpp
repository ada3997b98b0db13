// finemote import: what ROS knows of a robot's hardware, as a <finemote> element to start from.
#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <string_view>

#include "generator/cli/answer.hpp"
#include "generator/cli/commands.hpp"
#include "generator/cli/edited_file.hpp"
#include "generator/diagnostic/code_project.hpp"
#include "generator/format/format.hpp"
#include "generator/input/read_document.hpp"
#include "generator/output/folder.hpp"
#include "generator/ros2_control/proposal.hpp"
#include "generator/xml/markup_tokens.hpp"

namespace finemote::gen {
namespace {

using ros2_control::Proposal;

/// Reports FM2005, FM2017 and FM0001 where there is no robot, nothing to import, or no place for it.
bool is_importable(const xml::Node& robot, Diagnostics& diagnostics) {
  if (!robot.is_element("robot")) {
    diagnostics.error(code::not_a_robot, robot.at, fmt::format("the root element is <{}>, not <robot>", robot.name));
    return false;
  }
  const auto find = [&](std::string_view tag) {
    return std::find_if(robot.children.begin(), robot.children.end(),
                        [&](const xml::Node& node) { return node.is_element(tag); });
  };
  if (find("ros2_control") == robot.children.end()) {
    diagnostics.error(code::nothing_to_import, robot.at, "the robot has no <ros2_control> element")
        .hint("begin with finemote init");
    return false;
  }
  const auto block = find("finemote");
  if (block == robot.children.end()) return true;
  diagnostics.error(code::usage, block->at, "the robot has a <finemote> element already")
      .hint("take it out, and merge what import prints");
  return false;
}

/// Where the end tag of the root is.
std::size_t end_tag_of_root(std::string_view text) {
  std::size_t end = text.size(), at = 0;
  for (const MarkupToken& token : markup_tokens(text)) {
    if (token.kind == MarkupToken::Kind::end) end = at;
    at += token.bytes.size();
  }
  return end;
}

/// The text of the robot's file with the element before its end.
std::string with_element(const std::string& text, const std::string& element) {
  const std::size_t end = end_tag_of_root(text);
  const std::size_t line = text.rfind('\n', end) + 1;
  const bool is_alone = text.find_first_not_of(" \t", line) == end;
  const std::size_t at = is_alone ? line : end;
  return text.substr(0, at) + (is_alone ? "\n" : "\n\n") + element + text.substr(at);
}

Answer answer_of(const Options& options, const Proposal& proposal) {
  Answer answer{kExitYes};
  if (options.out.empty()) answer.text = proposal.text;
  if (!options.quiet) {
    for (const std::string& what : proposal.lacking) answer.summary += "lacking: " + what + "\n";
    answer.summary +=
        fmt::format("guesses: {}, each in a comment; lacking: {}\n", proposal.guesses.size(), proposal.lacking.size());
  }
  answer.document = {{"schema", "finemote.import/1"},
                     {"guesses", proposal.guesses},
                     {"lacking", proposal.lacking},
                     {"text", proposal.text}};
  return answer;
}

}  // namespace

Answer run_import(const Options& options, Sources& sources, Diagnostics& diagnostics) {
  Input input;
  input.path = options.input;
  input.arguments = options.arguments;
  input.packages = options.packages;
  const auto document = read_document(input, sources, diagnostics);
  if (!document || !is_importable(document->root, diagnostics)) return no_answer();
  Proposal proposal = ros2_control::propose(ros2_control::read_hardware(document->root));
  proposal.text = formatted(proposal.text);
  if (!options.out.empty()) {
    const SourceFile& file = sources.files().front();
    const std::string text = with_element(file.text, proposal.text);
    const auto mark = file.path.empty() ? std::optional(std::string()) : mark_before(file, sources, diagnostics);
    check_outputs({{options.out, "-o"}}, sources, diagnostics);
    if (diagnostics.has_errors() || !write_result(options.out, *mark + text, diagnostics)) return no_answer();
  }
  return answer_of(options, proposal);
}

}  // namespace finemote::gen
