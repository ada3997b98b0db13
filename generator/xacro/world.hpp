// What expressions and substitutions may ask of the document around them: files, arguments, packages, messages.
#pragma once

#include <iosfwd>
#include <optional>
#include <string>
#include <string_view>

#include "generator/xacro/arguments.hpp"
#include "generator/xacro/current_piece.hpp"
#include "generator/xacro/engine.hpp"
#include "generator/xacro/input_files.hpp"
#include "generator/xacro/packages.hpp"
#include "generator/xacro/substitution.hpp"
#include "generator/xacro/trail.hpp"
#include "generator/xacro/warnings.hpp"

namespace finemote::gen::xacro {

class World : public expression::Services, public SubstitutionHost {
 public:
  /// What it answers from; all outlive it.
  struct Parts {
    const files::Access& access;
    const PackagePath& packages;
    const Trail& trail;
    const CurrentPiece& piece;
    InputFiles& files;
    ArgumentTable& arguments;
    Warnings& warnings;
    std::ostream* messages;  ///< for xacro.message() and xacro.print_location(); may be null
  };
  explicit World(const Parts& parts) : parts_(parts) {}

  const SourceFile* open_yaml(const std::string& file) override;
  std::string absolute_name(const std::string& file) override { return parts_.trail.absolute(file); }
  const std::string* argument(const std::string& name) override { return parts_.arguments.ask(name); }
  void say(MessageKind kind, const std::string& text, bool with_location) override;
  void deprecated(std::string_view name, std::string_view name_space) override;
  std::string package_folder(const std::string& name) override;
  std::optional<std::string> environment(const std::string& name) override;
  [[nodiscard]] bool hides_environment() const override { return parts_.access.is_sandbox(); }

 private:
  Parts parts_;
};

}  // namespace finemote::gen::xacro
