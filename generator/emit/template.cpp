#include "generator/emit/template.hpp"

#include <algorithm>
#include <fstream>
#include <sstream>
#include <stdexcept>

#include "generator/emit/layout.hpp"

namespace finemote::gen {
namespace {

constexpr unsigned kDeepest = 8;  ///< partials within partials
constexpr std::string_view kOpen = "{{", kClose = "}}";

std::string read_text(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) throw std::runtime_error("cannot read template " + path);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

/// One tag with what stands around it.
struct Tag {
  std::size_t begin = 0, end = 0;  ///< in the text; end: behind it
  char kind = ' ';                 ///< `#`, `^`, `/`, `>`, `!`; a blank for a value
  std::string key;
};

/// The next tag from `at` on; none: `begin` is npos. Of more than two braces the last two are the tag's.
Tag next_tag(std::string_view text, std::size_t at) {
  Tag tag;
  tag.begin = text.find(kOpen, at);
  if (tag.begin == std::string_view::npos) return tag;
  while (text.substr(tag.begin + 1, 2) == kOpen) ++tag.begin;
  const std::size_t close = text.find(kClose, tag.begin);
  if (close == std::string_view::npos) throw std::logic_error("a template has '{{' without '}}'");
  tag.end = close + kClose.size();
  std::string_view word = text.substr(tag.begin + kOpen.size(), close - tag.begin - kOpen.size());
  if (!word.empty() && std::string_view("#^/>!").find(word.front()) != std::string_view::npos) {
    tag.kind = word.front();
    word.remove_prefix(1);
  }
  tag.key = std::string(word);
  return tag;
}

/// `text` from one tag to the next as mustache leaves it alone: a brace that stands before a tag is no part of it, and
/// an empty line is not what a section leaves behind.
std::string plain_text(std::string_view text, std::size_t begin, std::size_t end) {
  std::string result;
  for (std::size_t i = begin; i < end; ++i) {
    const bool is_empty_line = text[i] == '\n' && (i == 0 || text[i - 1] == '\n');
    if (is_empty_line) result += kEmptyLine;
    result += text[i];
  }
  std::size_t braces = 0;
  for (; !result.empty() && result.back() == '{'; ++braces) result.pop_back();
  for (; braces > 0; --braces) result += "{{brace}}";
  return result;
}

bool is_alone(std::string_view text, const Tag& tag) {
  return (tag.begin == 0 || text[tag.begin - 1] == '\n') && text.substr(tag.end, 1) == "\n";
}

std::string expanded(const std::string& folder, const std::string& name, unsigned depth) {
  if (depth > kDeepest) throw std::logic_error("template " + name + " is a part of itself");
  const std::string text = read_text(folder + "/" + name);
  std::string result;
  std::size_t at = 0;
  for (Tag tag = next_tag(text, at); tag.begin != std::string::npos; tag = next_tag(text, at)) {
    result += plain_text(text, at, tag.begin);
    const bool takes_line = tag.kind != ' ' && is_alone(text, tag);
    if (tag.kind == '>') {
      std::string part = expanded(folder, tag.key + ".mustache", depth + 1);
      if (!takes_line) part.erase(std::remove(part.begin(), part.end(), '\n'), part.end());
      result += part;
    } else if (tag.kind != '!') {
      result += text.substr(tag.begin, tag.end - tag.begin);
    }
    at = tag.end + (takes_line ? 1 : 0);
  }
  return result + plain_text(text, at, text.size());
}

std::vector<Hole> holes_from(std::string_view text, std::size_t& at, std::string_view end) {
  std::vector<Hole> holes;
  for (Tag tag = next_tag(text, at); tag.begin != std::string_view::npos; tag = next_tag(text, at)) {
    at = tag.end;
    if (tag.kind == '/' && tag.key == end) return holes;
    Hole& hole = holes.emplace_back();
    hole.key = tag.key;
    hole.kind = tag.kind == '#' ? Hole::Kind::section : tag.kind == '^' ? Hole::Kind::inverted : Hole::Kind::value;
    if (hole.kind != Hole::Kind::value) hole.inside = holes_from(text, at, tag.key);
  }
  return holes;
}

const Data& layout_marks() {
  static const Data marks = [] {
    Data data;
    for (const LayoutMark& mark : kLayoutMarks) data.set(mark.key, std::string(mark.text));
    return data;
  }();
  return marks;
}

/// Looks every key up that rendering will ask for, as mustache does silently.
class KeyCheck {
 public:
  explicit KeyCheck(std::string name) : name_(std::move(name)) {}

  void run(const std::vector<Hole>& holes, const Data& data) {
    context_ = {&layout_marks(), &data};
    check(holes);
  }

 private:
  [[nodiscard]] const Data& look_up(const std::string& key) const {
    for (auto scope = context_.rbegin(); scope != context_.rend(); ++scope) {
      if (const Data* found = (*scope)->get(key)) return *found;
    }
    throw std::logic_error("template " + name_ + " names '" + key + "', which the emitter does not provide");
  }

  void check(const std::vector<Hole>& holes) {
    for (const Hole& hole : holes) {
      const Data& found = look_up(hole.key);
      const bool is_nothing = found.is_false() || found.is_empty_list();
      if (hole.kind == Hole::Kind::value || is_nothing != (hole.kind == Hole::Kind::inverted)) continue;
      if (found.is_non_empty_list()) {
        for (const Data& element : found.list_value()) check_with(element, hole.inside);
      } else {
        check_with(found, hole.inside);
      }
    }
  }
  void check_with(const Data& scope, const std::vector<Hole>& holes) {
    context_.push_back(&scope);
    check(holes);
    context_.pop_back();
  }

  std::string name_;
  std::vector<const Data*> context_;
};

}  // namespace

std::string read_template(const std::string& folder, const std::string& name) { return expanded(folder, name, 0); }

std::vector<Hole> holes_in(std::string_view text) {
  std::size_t at = 0;
  return holes_from(text, at, {});
}

std::string fill_template(const std::string& folder, const std::string& name, const Data& data) {
  const std::string text = read_template(folder, name);
  kainjow::mustache::mustache filler(text);
  if (!filler.is_valid()) throw std::logic_error("template " + name + ": " + filler.error_message());
  KeyCheck(name).run(holes_in(text), data);
  filler.set_custom_escape([](const std::string& raw) { return raw; });
  kainjow::mustache::context<std::string> context(&layout_marks());
  context.push(&data);
  return laid_out(filler.render(context));
}

Data text_list(const std::vector<std::string>& lines) {
  Data list(Data::type::list);
  for (const std::string& line : lines) list.push_back(Data("text", line));
  return list;
}

Data enumerated(std::vector<Data> elements) {
  Data list(Data::type::list);
  for (std::size_t i = 0; i < elements.size(); ++i) {
    elements[i].set("is_last", i + 1 == elements.size());
    list.push_back(elements[i]);
  }
  return list;
}

void set_choice(Data& data, std::initializer_list<const char*> names, std::string_view chosen) {
  for (const char* name : names) data.set(name, chosen == name);
}

}  // namespace finemote::gen
