// Fills a text with holes; a hole nobody fills is a bug and says so. templates/README.md says what a template may hold.
#pragma once

#include <initializer_list>
#include <kainjow/mustache.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace finemote::gen {

using Data = kainjow::mustache::data;

/// A key that a template names: a value, or a section with keys of its own.
struct Hole {
  enum class Kind { value, section, inverted };
  Kind kind = Kind::value;
  std::string key;
  std::vector<Hole> inside;  ///< of a section
};

/// The text of the template file `name` below `folder`: its partials in their places, its comments gone.
/// Throws std::logic_error when a tag has no end or partials name each other, and std::runtime_error when a file cannot
/// be read.
std::string read_template(const std::string& folder, const std::string& name);

/// The holes of a text that read_template() returned, in its order.
std::vector<Hole> holes_in(std::string_view text);

/// Fills the template file `name` below `folder`. Nothing is escaped.
/// Throws what read_template() throws, and std::logic_error when the template is broken or names a key that `data`
/// lacks.
std::string fill_template(const std::string& folder, const std::string& name, const Data& data);

/// Makes `{{key}}` lists of lines: [{text: line}, ...].
Data text_list(const std::vector<std::string>& lines);

/// A list whose elements also know their place: `is_last` of each is set.
Data enumerated(std::vector<Data> elements);

/// Sets each of `names` to whether it is `chosen`: one section of the template for each kind of a thing.
void set_choice(Data& data, std::initializer_list<const char*> names, std::string_view chosen);

}  // namespace finemote::gen
