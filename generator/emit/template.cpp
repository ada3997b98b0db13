#include "generator/emit/template.hpp"

#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string_view>

namespace finemote::gen {
namespace {

std::string read_text(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) throw std::runtime_error("cannot read template " + path);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

/// Walks the tags of a template in the order they would be rendered and looks every key up, as mustache does silently.
class KeyCheck {
 public:
  KeyCheck(std::string_view text, std::string name) : text_(text), name_(std::move(name)) {}

  void run(const Data& data) {
    std::vector<const Data*> context{&data};
    section(context, "");
  }

 private:
  struct Tag {
    char kind = 0;  ///< '#', '^', '/', or 0 for a value
    std::string key;
  };

  bool next(Tag& tag) {
    const auto open = text_.find("{{", at_);
    if (open == std::string_view::npos) return false;
    const auto close = text_.find("}}", open);
    std::string_view word = text_.substr(open + 2, close - open - 2);
    at_ = close + 2;
    tag.kind = word.empty() || std::string_view("#^/").find(word.front()) == std::string_view::npos ? 0 : word.front();
    if (tag.kind != 0) word.remove_prefix(1);
    tag.key = std::string(word);
    return true;
  }

  const Data& look_up(const std::vector<const Data*>& context, const std::string& key) const {
    for (auto scope = context.rbegin(); scope != context.rend(); ++scope) {
      if (const Data* found = (*scope)->get(key)) return *found;
    }
    throw std::logic_error("template " + name_ + " names '" + key + "', which the emitter does not provide");
  }

  void skip(const std::string& key) {
    Tag tag;
    while (next(tag) && !(tag.kind == '/' && tag.key == key)) {}
  }

  void section(std::vector<const Data*>& context, const std::string& end) {
    Tag tag;
    while (next(tag)) {
      if (tag.kind == '/' && tag.key == end) return;
      const Data& found = look_up(context, tag.key);
      if (tag.kind != '#') continue;
      const bool list = found.is_non_empty_list();
      if (!list && !found.is_true()) {
        skip(tag.key);
        continue;
      }
      if (list) context.push_back(&found.list_value().front());
      section(context, tag.key);
      if (list) context.pop_back();
    }
  }

  std::string_view text_;
  std::string name_;
  std::size_t at_ = 0;
};

/// At most one blank line in a row: a section that is left out leaves its own blank lines behind.
std::string without_double_blanks(const std::string& text) {
  std::string result;
  for (const char c : text) {
    const bool third = c == '\n' && result.size() >= 2 && result.compare(result.size() - 2, 2, "\n\n") == 0;
    if (!third) result += c;
  }
  return result;
}

/// Compilers join such a line with the next one: it ends in a backslash, in the trigraph of one, or in either and
/// blanks.
bool joins_next(std::string_view line) {
  const std::size_t last = line.find_last_not_of(" \t");
  const std::string_view written = line.substr(0, last == std::string_view::npos ? 0 : last + 1);
  const auto ends_in = [&](std::string_view end) {
    return written.size() >= end.size() && written.substr(written.size() - end.size()) == end;
  };
  return ends_in("\\") || ends_in("?\?/");
}

/// A name at the end of a comment may end in a backslash, which would make the next line part of the comment.
std::string with_ended_lines(const std::string& text) {
  std::string result;
  std::size_t begin = 0;  // of the line
  for (const char c : text) {
    if (c == '\n' && joins_next(std::string_view(result).substr(begin))) result += " //";
    result += c;
    if (c == '\n') begin = result.size();
  }
  return result;
}

}  // namespace

Data text_list(const std::vector<std::string>& lines) {
  Data list(Data::type::list);
  for (const std::string& line : lines) list.push_back(Data("text", line));
  return list;
}

std::string fill_template(const std::string& folder, const std::string& name, const Data& data) {
  const std::string text = read_text(folder + "/" + name);
  KeyCheck(text, name).run(data);
  kainjow::mustache::mustache filler(text);
  if (!filler.is_valid()) throw std::logic_error("template " + name + ": " + filler.error_message());
  filler.set_custom_escape([](const std::string& raw) { return raw; });
  return with_ended_lines(without_double_blanks(filler.render(data)));
}

}  // namespace finemote::gen
