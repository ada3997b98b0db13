// $(find p), $(arg a), $(env V), $(optenv V default), $(cwd): the words between the brackets to a text.
#pragma once

#include <optional>
#include <string>

namespace finemote::gen::xacro {

/// What the substitutions ask for.
class SubstitutionHost {
 public:
  virtual ~SubstitutionHost() = default;
  virtual const std::string* argument(const std::string& name) = 0;             ///< null when it has no value
  virtual std::optional<std::string> environment(const std::string& name) = 0;  ///< of the process; none when hidden
  [[nodiscard]] virtual bool hides_environment() const = 0;                     ///< the sandbox has none
  virtual std::string package_folder(const std::string& name) = 0;              ///< fails when there is none
};

/// @param inside  the text between `$(` and `)`
/// Fails with the words of ROS on unknown commands and wrong numbers of words.
std::string substitute(SubstitutionHost& host, const std::string& inside);

}  // namespace finemote::gen::xacro
