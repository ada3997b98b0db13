#include "generator/emit/template.hpp"

#include <algorithm>
#include <iterator>
#include <stdexcept>

#include "generator/emit/layout.hpp"
#include "generator/file/installed_file.hpp"

namespace finemote::gen {
namespace {

constexpr unsigned kDeepest = 8;  ///< partials within partials
constexpr std::string_view kOpen = "{{", kClose = "}}";

/// One tag with what stands around it.
struct Tag {
  std::size_t begin = 0, end = 0;  ///< in the text; end: past it
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
  while (begin < end) {
    const bool is_empty_line = text[begin] == '\n' && (begin == 0 || text[begin - 1] == '\n');
    if (is_empty_line) result += kEmptyLine;
    const std::size_t line_end = std::min(text.find('\n', begin), end - 1) + 1;
    result += text.substr(begin, line_end - begin);
    begin = line_end;
  }
  std::size_t braces = 0;
  for (; !result.empty() && result.back() == '{'; ++braces) result.pop_back();
  for (; braces > 0; --braces) result += "{{brace}}";
  return result;
}

bool is_alone(std::string_view text, const Tag& tag) {
  return (tag.begin == 0 || text[tag.begin - 1] == '\n') && text.substr(tag.end, 1) == "\n";
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

const std::string& Templates::text(const std::string& name, unsigned depth) {
  if (depth > kDeepest) throw std::logic_error("template " + name + " is a part of itself");
  const auto known = texts_.find(name);
  if (known != texts_.end()) return known->second;
  std::string text = expanded(read_installed(folder_ + "/" + name), depth);
  return texts_.emplace(name, std::move(text)).first->second;
}

std::string Templates::expanded(std::string_view text, unsigned depth) {
  std::string result;
  std::size_t at = 0;
  for (Tag tag = next_tag(text, at); tag.begin != std::string::npos; tag = next_tag(text, at)) {
    result += plain_text(text, at, tag.begin);
    const bool takes_line = tag.kind != ' ' && is_alone(text, tag);
    if (tag.kind == '>') {
      const std::string& part = this->text(tag.key + ".mustache", depth + 1);
      std::copy_if(part.begin(), part.end(), std::back_inserter(result),
                   [&](char c) { return takes_line || c != '\n'; });
    } else if (tag.kind != '!') {
      result += text.substr(tag.begin, tag.end - tag.begin);
    }
    at = tag.end + (takes_line ? 1 : 0);
  }
  return result + plain_text(text, at, text.size());
}

std::vector<Hole> holes_in(std::string_view text) {
  std::size_t at = 0;
  return holes_from(text, at, {});
}

std::string Templates::fill(const std::string& name, const Data& data) {
  const std::string& template_text = text(name);
  kainjow::mustache::mustache filler(template_text);
  if (!filler.is_valid()) throw std::logic_error("template " + name + ": " + filler.error_message());
  KeyCheck(name).run(holes_in(template_text), data);
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

Data enumerated(DataList elements) {
  for (std::size_t i = 0; i < elements.size(); ++i) elements[i].set("is_last", i + 1 == elements.size());
  return elements;
}

void set_choice(Data& data, std::initializer_list<const char*> names, std::string_view chosen) {
  for (const char* name : names) data.set(name, chosen == name);
}

}  // namespace finemote::gen
