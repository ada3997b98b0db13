// Fills a text with holes; a hole nobody fills is a bug and says so. templates/README.md says what a template may hold.
#pragma once

#include <initializer_list>
#include <kainjow/mustache.hpp>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace finemote::gen {

using Data = kainjow::mustache::data;

/// Becomes a list of Data. Reserve its size: where it grows, all it holds is copied, not moved.
using DataList = kainjow::mustache::list;

/// A key that a template names: a value, or a section with keys of its own.
struct Hole {
  enum class Kind { value, section, inverted };
  Kind kind = Kind::value;
  std::string key;
  std::vector<Hole> inside;  ///< of a section
};

/// The template files of a folder. Each is read once.
class Templates {
 public:
  explicit Templates(std::string folder) : folder_(std::move(folder)) {}

  /// The text of the file `name`: its partials in their places, its comments gone.
  /// Throws std::logic_error when a tag has no end or partials name each other, and std::runtime_error when a file
  /// cannot be read.
  const std::string& text(const std::string& name) { return text(name, 0); }

  /// Fills the file `name`. Nothing is escaped.
  /// Throws what text() throws, and std::logic_error when the template is broken or names a key that `data` lacks.
  std::string fill(const std::string& name, const Data& data);

 private:
  /// @param depth  of partials within partials
  const std::string& text(const std::string& name, unsigned depth);
  std::string expanded(std::string_view text, unsigned depth);

  std::string folder_;
  std::map<std::string, std::string> texts_;
};

/// The holes of a text that Templates::text() returned, in its order.
std::vector<Hole> holes_in(std::string_view text);

/// Makes `{{key}}` lists of lines: [{text: line}, ...].
Data text_list(const std::vector<std::string>& lines);

/// A list whose elements also know their place: `is_last` of each is set.
Data enumerated(DataList elements);

/// Sets each of `names` to whether it is `chosen`: one section of the template for each kind of a thing.
void set_choice(Data& data, std::initializer_list<const char*> names, std::string_view chosen);

}  // namespace finemote::gen
