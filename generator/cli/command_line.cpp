#include "generator/cli/command_line.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>
#include <sstream>

#include "generator/cli/commands.hpp"
#include "generator/diagnostic/render.hpp"
#include "generator/diagnostic/suggest.hpp"
#include "generator/version.hpp"

namespace finemote::gen {
namespace {

std::string version_text() {
  std::ostringstream text;
  text << "finemote " << kVersion << "\nextension version 1 to " << kExtensionVersion << ", output format "
       << kOutputFormat << ", device descriptors finemote.device/1, boards finemote.board/1";
  return text.str();
}

/// CLI11 wraps a number that 64 bits do not hold.
std::string check_number(const std::string& word) {
  std::uint64_t value = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (error == std::errc() && end == word.data() + word.size()) return {};
  return "'" + word + "': write a whole number from 0 to " + std::to_string(UINT64_MAX);
}

/// Defines an option of the table with CLI11: one function for each kind of value.
class Definition {
 public:
  Definition(CLI::App& app, Options& options, const Option& option) : app_(app), options_(options), option_(option) {}

  CLI::Option* operator()(bool Options::*flag) const {
    return app_.add_flag(option_.names, options_.*flag, option_.help);
  }
  CLI::Option* operator()(std::uint64_t Options::*number) const {
    return app_.add_option(option_.names, options_.*number, option_.help)->check(check_number, "");
  }
  template <typename Type>
  CLI::Option* operator()(Type Options::*value) const {
    return app_.add_option(option_.names, options_.*value, option_.help);
  }
  CLI::Option* operator()(const Choice& choice) const {
    std::string shown;
    for (const std::string& word : choice.words) shown += (shown.empty() ? "" : "|") + word;
    const auto choose = [&options = options_, &choice, name = option_.names](const CLI::results_t& given) {
      const std::vector<std::string>& words = choice.words;
      const auto word = std::find(words.begin(), words.end(), given.back());
      if (word == words.end())
        throw CLI::ValidationError(name, "'" + given.back() + "': " + did_you_mean(given.back(), words));
      choice.choose(options, static_cast<std::size_t>(word - words.begin()));
      return true;
    };
    return app_.add_option(option_.names, choose, option_.help)->option_text(shown);
  }
  CLI::Option* operator()(const Refusal& refusal) const {
    const auto refuse = [name = option_.names, why = refusal.why] { throw CLI::ValidationError(name, why); };
    return app_.add_flag_callback(option_.names, refuse, option_.help);
  }

 private:
  CLI::App& app_;
  Options& options_;
  const Option& option_;
};

void define(CLI::App& app, Options& options, const std::vector<Option>& table) {
  for (const Option& option : table) {
    CLI::Option* defined = std::visit(Definition(app, options, option), option.value);
    if (option.need == Option::Need::required) defined->required();
    if (option.shown != nullptr) defined->option_text(option.shown);
    if (option.excludes != nullptr) defined->excludes(app.get_option(option.excludes));
  }
}

CLI::App* add_group(CLI::App& app, const std::string& word) {
  for (CLI::App* group : app.get_subcommands({})) {
    if (group->get_name() == word) return group;
  }
  CLI::App* group = app.add_subcommand(word, group_summary(word));
  group->require_subcommand(1);
  return group;
}

/// The command of one word, or of two below the first.
CLI::App& add_command(CLI::App& app, const Command& command) {
  const std::string name = command.name;
  const auto blank = name.find(' ');
  if (blank == std::string::npos) return *app.add_subcommand(name, command.summary);
  return *add_group(app, name.substr(0, blank))->add_subcommand(name.substr(blank + 1), command.summary);
}

/// The whole definition; the values of a parse go to `options`.
void define_command_line(CLI::App& app, Options& options) {
  app.description("From a robot description to firmware with a proven bound on how old every command can be.");
  app.name("finemote");
  app.require_subcommand(1);
  app.fallthrough();
  app.set_version_flag("--version", version_text());
  define(app, options, common_options());
  for (const Command& command : commands()) {
    CLI::App& defined = add_command(app, command);
    define(defined, options, command.options);
    if (command.footer != nullptr) defined.footer(command.footer());
  }
}

/// Of words that may hold mistakes: the last format that is one.
Format asked_format(const std::vector<std::string>& words) {
  Format format = Format::text;
  std::string before;
  for (const std::string& word : words) {
    constexpr std::string_view kOption = "--format";
    const bool is_joined = word.rfind(std::string(kOption) + "=", 0) == 0;
    const std::string value = is_joined ? word.substr(kOption.size() + 1) : before == kOption ? word : "";
    const auto known = std::find(std::begin(kFormatWords), std::end(kFormatWords), value);
    if (known != std::end(kFormatWords)) format = static_cast<Format>(known - std::begin(kFormatWords));
    before = word;
  }
  return format;
}

}  // namespace

CommandWords command_line_words() {
  Options options;
  CLI::App app;
  define_command_line(app, options);
  return words_of(app);
}

ParsedCommandLine parse_command_line(const std::vector<std::string>& words) {
  Options options;
  CLI::App app;
  define_command_line(app, options);
  const std::vector<std::string> ordered = command_first(app, take_arguments(words, options.arguments));
  try {
    app.parse(std::vector<std::string>(ordered.rbegin(), ordered.rend()));  // CLI11 takes the words last first
  } catch (const CLI::ParseError& error) {
    std::ostringstream out;
    std::ostringstream err;
    const bool asked = app.exit(error, out, err) == 0 && app.remaining(true).empty();
    if (asked) return {std::nullopt, kExitYes, out.str(), {}};
    const Diagnostics mistake = usage_error(app, ordered, error);
    return {std::nullopt, kExitInvalid, render_text(mistake, false), render_for_ci(asked_format(words), mistake, "")};
  }
  options.command = chosen_command(app);
  return {std::move(options), kExitYes, {}, {}};
}

}  // namespace finemote::gen
