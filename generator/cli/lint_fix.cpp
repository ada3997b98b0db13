#include "generator/cli/lint_fix.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <string_view>

#include "generator/cli/diff_facts.hpp"
#include "generator/cli/lint_options.hpp"
#include "generator/diagnostic/render.hpp"

namespace finemote::gen {
namespace {

using Sayings = std::multimap<std::string, std::string>;  ///< of findings, to what they say

/// Whether a device can tell its children of a role apart by their order. A link sends them in it, and what a user's
/// class does is unknown; shipped ones treat children of any interface alike.
bool has_order(const DeviceType& type, const RoleSpec& role) {
  return role.interface != "any" || !type.builtin || role.name == type.link_role;
}

/// Names of the children in every role, in their order where the device can tell one from the other.
std::string children_text(const Robot& robot, const Device& device) {
  std::string text;
  for (std::size_t role = 0; role < device.type->roles.size(); ++role) {
    std::vector<std::string> names;
    for (const DeviceId child : device.children) {
      if (robot.devices[child].role == role) names.push_back(robot.devices[child].name.text);
    }
    if (!has_order(*device.type, device.type->roles[role])) std::sort(names.begin(), names.end());
    text += fmt::format(" {}: {}", device.type->roles[role].name, fmt::join(names, " "));
  }
  return text;
}

/// What the robot is, whatever the order of its devices where nothing can tell; without the buses of these names.
Facts lasting_facts(const PlannedRobot& planned, const std::set<std::string>& without) {
  Facts facts = facts_of(planned);
  for (const std::string& bus : without) facts.erase(fmt::format("bus '{}'", bus));
  for (const Device& device : planned.robot.devices) {
    auto& properties = facts[fmt::format("device '{}'", device.name.text)];
    properties.erase("order");
    properties["children"] = children_text(planned.robot, device);
  }
  return facts;
}

/// The first that is not in both alike, as a user knows it; empty: none.
std::string first_difference(const Facts& a, const Facts& b) {
  for (const auto& [was, is] : {std::pair(&a, &b), std::pair(&b, &a)}) {
    for (const auto& [subject, properties] : *was) {
      const auto found = is->find(subject);
      if (found == is->end() || found->second != properties) return subject;
    }
  }
  return {};
}

/// A finding without its figures, which may change with the order; what stands in quotes is kept.
std::string key_of(const Diagnostic& finding) {
  std::string key = code_name(finding.code) + " ";
  bool is_quoted = false;
  for (const char c : finding.message) {
    if (c == '\'') is_quoted = !is_quoted;
    if (is_quoted || std::string_view("0123456789.").find(c) == std::string_view::npos) key += c;
  }
  return key;
}

Sayings keys_of(const Diagnostics& said, const Linted& linted) {
  Sayings keys;
  for (const Diagnostics* findings : {&said, &linted.verdict.reasons, &linted.findings}) {
    for (const Diagnostic& finding : findings->in_file_order())
      keys.emplace(key_of(finding), fmt::format("{}: {}", code_name(finding.code), finding.message));
  }
  return keys;
}

/// What the first of `all` that `known` lacks says; empty: none.
std::string first_new(const Sayings& all, const Sayings& known) {
  for (const auto& [key, words] : all) {
    if (all.count(key) > known.count(key)) return words;
  }
  return {};
}

/// A bus that nothing uses may be used when the file is read with other arguments, or in another environment.
bool depends_on_arguments(const Sources& sources) {
  constexpr std::string_view kWords[] = {":if", ":unless", ":arg", "$(arg", "$(env", "$(optenv", "$(eval"};
  return std::any_of(sources.files().begin(), sources.files().end(), [&](const SourceFile& file) {
    return std::any_of(std::begin(kWords), std::end(kWords), [&](std::string_view word) {
      return file.name.ends_with(".xacro") && file.text.find(word) != std::string::npos;
    });
  });
}

class FixTrial {
 public:
  FixTrial(const Options& options, const Input& input, const Linted& linted, const Sources& sources,
           const Diagnostics& said)
      : options_(options), input_(input), linted_(linted), sources_(sources), before_(keys_of(said, linted)) {}

  AppliedFixes run() {
    std::vector<const Fix*> open;
    const bool is_open_ended = depends_on_arguments(sources_);
    for (const Fix& fix : linted_.fixes) {
      if (fix.change.edits.empty()) {
        refuse(fix, fix.change.reason);
      } else if (fix.code == code::lint_unused_bus && is_open_ended) {
        refuse(fix, "with other arguments of the file the bus may be used");
      } else {
        open.push_back(&fix);
      }
    }
    if (!open.empty()) try_all(open);
    return std::move(applied_);
  }

 private:
  void refuse(const Fix& fix, std::string reason) { applied_.refused.emplace_back(&fix, std::move(reason)); }

  /// All together, else one after the other.
  void try_all(const std::vector<const Fix*>& fixes) {
    const std::string all_refused = take(fixes);
    if (all_refused.empty()) return;
    for (const Fix* fix : fixes) {
      std::vector<const Fix*> more = applied_.fixed;
      more.push_back(fix);
      const std::string reason = more.size() == fixes.size() ? all_refused : take(more);
      if (!reason.empty()) refuse(*fix, reason);
    }
  }

  /// Keeps the robot with these fixes; or says why it is not what it should be.
  std::string take(const std::vector<const Fix*>& fixes) {
    std::unique_ptr<Edited> edited = read(fixes);
    std::string reason = objection(*edited, fixes);
    if (!reason.empty()) return reason;
    applied_.edited = std::move(edited);
    applied_.fixed = fixes;
    return {};
  }

  [[nodiscard]] std::unique_ptr<Edited> read(const std::vector<const Fix*>& fixes) const {
    std::vector<Edit> edits;
    for (const Fix* fix : fixes) edits.insert(edits.end(), fix->change.edits.begin(), fix->change.edits.end());
    auto edited = std::make_unique<Edited>(
        Edited{apply_edits(*edits.front().file, edits), Sources(sources_.access()), {}, std::nullopt});
    Input input = input_;
    input.text = &edited->text;
    input.messages = nullptr;
    auto planned = plan_robot(input, edited->sources, edited->diagnostics);
    if (planned) edited->linted = lint_planned(options_, std::move(*planned), edited->diagnostics);
    return edited;
  }

  /// Why the edited robot is not what it should be; empty: it is.
  [[nodiscard]] std::string objection(const Edited& edited, const std::vector<const Fix*>& fixes) const {
    if (!edited.linted || edited.diagnostics.has_errors()) {
      for (const Diagnostic& finding : edited.diagnostics.in_file_order()) {
        if (finding.severity == Severity::error)
          return fmt::format("the edited robot has the error {}: {}", code_name(finding.code), finding.message);
      }
      return "the edited robot cannot be read";
    }
    Sayings expected = before_;
    std::set<std::string> removed;
    for (const Fix* fix : fixes) {
      expected.erase(expected.find(key_of({Severity::warning, fix->code, {}, 1, fix->message, {}, {}})));
      if (fix->code == code::lint_unused_bus) removed.insert(fix->subject);
    }
    const std::string finding = first_new(keys_of(edited.diagnostics, *edited.linted), expected);
    if (!finding.empty()) return "the edited robot has a new finding, " + finding;
    const std::string other =
        first_difference(lasting_facts(linted_.planned, removed), lasting_facts(edited.linted->planned, {}));
    return other.empty() ? other : fmt::format("{} would not be what it is", other);
  }

  const Options& options_;
  const Input& input_;
  const Linted& linted_;
  const Sources& sources_;
  Sayings before_;
  AppliedFixes applied_;
};

}  // namespace

std::optional<Linted> lint_planned(const Options& options, PlannedRobot planned, Diagnostics& diagnostics) {
  const Analysis analysis = analyse_robot(planned, Hints::wanted);
  auto verdict = verdict_of(analysis, diagnostics);
  if (!verdict) return std::nullopt;
  auto rules = lint_options(options.allow, options.deny, planned, *analysis.timing, *verdict, diagnostics);
  if (!rules) return std::nullopt;
  Linted linted{std::move(planned), std::move(*verdict), std::move(*rules), {}, {}};
  linted.fixes = lint(linted.planned.robot, linted.options, linted.findings);
  return linted;
}

AppliedFixes apply_fixes(const Options& options, const Input& input, const Linted& linted, const Sources& sources,
                         const Diagnostics& said) {
  return FixTrial(options, input, linted, sources, said).run();
}

}  // namespace finemote::gen
