// The words of the command line, and that docs/reference/commands.md names every one of them and no other.
#include <fmt/format.h>

#include <map>
#include <set>
#include <sstream>

#include "catch.hpp"
#include "cli/program.hpp"
#include "generator/cli/command_line.hpp"
#include "generator/diagnostic/render.hpp"

using namespace finemote::gen;
using Words = std::vector<std::string>;

namespace {

/// What the page says of one command: the first column of the table below its heading, and the operands in the heading.
struct Section {
  std::string operands;           ///< of `## generate IN`: ` IN`
  std::set<std::string> options;  ///< each name with its dashes, and `--format json` for a choice
};

/// The texts between backquotes.
Words quoted(const std::string& line) {
  Words found;
  for (std::size_t begin = line.find('`'); begin != std::string::npos;) {
    const std::size_t end = line.find('`', begin + 1);
    if (end == std::string::npos) break;
    found.push_back(line.substr(begin + 1, end - begin - 1));
    begin = line.find('`', end + 1);
  }
  return found;
}

/// `-o DIR` and `--output DIR` are names with a value; `--format json` is a choice where `choices` holds it.
std::string option_word(const std::string& text, const std::set<std::string>& choices) {
  return choices.count(text) > 0 ? text : text.substr(0, text.find(' '));
}

void add_options(const CommandWords& command, std::set<std::string>& options) {
  for (const OptionWords& option : command.options) {
    for (const std::string& choice : option.choices) options.insert(option.names.back() + " " + choice);
    if (option.choices.empty()) options.insert(option.names.begin(), option.names.end());
  }
}

/// Sections by the name in their heading; of `# Commands` itself, none.
std::map<std::string, Section> sections_of(const std::string& page, const std::set<std::string>& choices) {
  std::map<std::string, Section> sections;
  Section* current = nullptr;
  std::istringstream lines(page);
  for (std::string line; std::getline(lines, line);) {
    if (line.rfind("## ", 0) == 0) {
      const std::size_t end = line.find_first_of("ABCDEFGHIJKLMNOPQRSTUVWXYZ[", 4);
      const bool is_command = line.find_first_of("[ABCDEFGHIJKLMNOPQRSTUVWXYZ", 3) != 3;
      const std::string name = is_command ? line.substr(3, end == std::string::npos ? end : end - 4) : line.substr(3);
      current = &sections[name];
      current->operands = is_command && end != std::string::npos ? line.substr(end) : "";
    }
    if (current == nullptr || line.rfind("| `-", 0) != 0) continue;
    for (const std::string& text : quoted(line.substr(0, line.find(" | ")))) {
      current->options.insert(option_word(text, choices));
    }
  }
  return sections;
}

/// Commands without subcommands, `board show` among them.
std::vector<CommandWords> leaves(const CommandWords& level, const std::string& prefix = {}) {
  std::vector<CommandWords> found;
  for (CommandWords command : level.commands) {
    command.name = prefix + command.name;
    const auto below = leaves(command, command.name + " ");
    if (below.empty())
      found.push_back(command);
    else
      found.insert(found.end(), below.begin(), below.end());
  }
  return found;
}

}  // namespace

TEST_CASE("the page of the commands names every command, operand, option and choice, and no other") {
  const CommandWords program = command_line_words();
  const std::vector<CommandWords> commands = leaves(program);
  REQUIRE(commands.size() >= 13);
  std::set<std::string> choices;
  add_options(program, choices);
  for (const CommandWords& command : commands) add_options(command, choices);
  const std::string page = finemote::test::read_file(finemote::test::source_path("docs/reference/commands.md"));
  auto sections = sections_of(page, choices);
  for (const CommandWords& command : commands) {
    INFO("section '## " << command.name << "'");
    REQUIRE(sections.count(command.name) == 1);
    std::set<std::string> options;
    add_options(command, options);
    CHECK(sections[command.name].options == options);
    for (const std::string& operand : command.operands)
      CHECK(sections[command.name].operands.find(operand) != std::string::npos);
    CHECK(page.find(fmt::format("| [`{}`](#", command.name)) != std::string::npos);
    sections.erase(command.name);
  }
  std::set<std::string> options;
  add_options(program, options);
  CHECK(sections["Options of all commands"].options == options);
  sections.erase("Options of all commands");
  sections.erase("Exit status");
  sections.erase("Formats");
  for (const auto& [name, section] : sections) FAIL_CHECK("the page has a section '## " << name << "'");
}

TEST_CASE("an option before the command is one behind it") {
  const auto option = GENERATE(Words{"--device-path", "generate"}, Words{"--board", "host"}, Words{"--package", "a=b"},
                               Words{"-o", "out"}, Words{"--output=out"}, Words{"--format", "json"}, Words{"-q"},
                               Words{"-W", "error"}, Words{"--depfile", "check"}, Words{"--data-dir", "run"});
  const auto parse = [](const Words& before, const Words& behind) {
    Words words = before;
    words.push_back("generate");
    words.push_back("robot.urdf");
    words.insert(words.end(), behind.begin(), behind.end());
    return parse_command_line(words);
  };
  const auto first = parse(option, {});
  const auto last = parse({}, option);
  REQUIRE(first.options);
  REQUIRE(last.options);
  for (const auto& parsed : {first, last}) {
    CHECK(parsed.options->command == "generate");
    CHECK(parsed.options->input == "robot.urdf");
  }
  const auto same = [](const Options& a, const Options& b) {
    return a.device_paths == b.device_paths && a.board == b.board && a.packages == b.packages && a.out == b.out &&
           a.format == b.format && a.quiet == b.quiet && a.warnings_are_errors == b.warnings_are_errors &&
           a.depfile == b.depfile && a.data_dir == b.data_dir;
  };
  CHECK(same(*first.options, *last.options));
  CHECK_FALSE(same(*first.options, *parse({}, {}).options));
}

TEST_CASE("a command of two words is found behind options") {
  const auto parsed = parse_command_line({"--format", "json", "board", "-q", "show", "host"});
  REQUIRE(parsed.options);
  CHECK(parsed.options->command == "board show");
  CHECK(parsed.options->input == "host");
  CHECK(parsed.options->format == Format::json);
}

TEST_CASE("help of what does not exist is a usage error") {
  const auto [words, message] = GENERATE(
      std::pair<Words, std::string>{{"frobnicate", "--help"}, "there is no command 'frobnicate'"},
      std::pair<Words, std::string>{{"--help", "frobnicate"}, "there is no command 'frobnicate'"},
      std::pair<Words, std::string>{{"frobnicate", "--version"}, "there is no command 'frobnicate'"},
      std::pair<Words, std::string>{{"--format", "json", "frobnicate"}, "there is no command 'frobnicate'"},
      std::pair<Words, std::string>{{"--frob", "generate", "x.urdf"}, "command 'generate' has no option '--frob'"},
      std::pair<Words, std::string>{{"board", "frob", "--help"}, "there is no command 'board frob'"},
      std::pair<Words, std::string>{{"board"}, "command 'board' needs a second word"},
      std::pair<Words, std::string>{{}, "a command is missing"},
      std::pair<Words, std::string>{{"tree", "--bogus", "--help"}, "command 'tree' has no option '--bogus'"});
  const auto parsed = parse_command_line(words);
  CHECK_FALSE(parsed.options);
  CHECK(parsed.exit_status == 2);
  CHECK(parsed.text.rfind("finemote: error[FM0001]: " + message + "\n", 0) == 0);
}

TEST_CASE("help and version are answers") {
  for (const Words& words : {Words{"--help"}, Words{"xacro", "--help"}, Words{"--help", "tree"}, Words{"--version"},
                             Words{"board", "--help"}, Words{"tree", "--version"}}) {
    const auto parsed = parse_command_line(words);
    CHECK_FALSE(parsed.options);
    CHECK(parsed.exit_status == 0);
    CHECK(!parsed.text.empty());
  }
  for (const char* command : {"xacro", "generate", "check", "analyze"}) {
    CHECK(parse_command_line({command, "--help"}).text.find("name:=value") != std::string::npos);
  }
}
