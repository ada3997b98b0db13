#include "generator/diagnostic/source.hpp"

#include <filesystem>
#include <tuple>

#include "generator/diagnostic/place.hpp"

namespace finemote::gen {

std::string_view SourceFile::line(std::uint32_t line) const {
  if (line == 0) return {};
  std::string_view rest = text;
  for (; line > 1; --line) {
    const auto end = rest.find('\n');
    if (end == std::string_view::npos) return {};
    rest.remove_prefix(end + 1);
  }
  rest = rest.substr(0, rest.find('\n'));
  if (!rest.empty() && rest.back() == '\r') rest.remove_suffix(1);
  return rest;
}

std::string SourceFile::place() const {
  const bool is_elsewhere = !path.empty() && path != name && name.rfind("builtin:", 0) != 0;
  return is_elsewhere ? std::filesystem::path(path).lexically_normal().generic_string() : name;
}

bool before(const Position& a, const Position& b) {
  const auto key = [](const Position& p) {
    return std::make_tuple(p.file ? std::string_view(p.file->name) : std::string_view(), p.line, p.column);
  };
  const Position outer_a = outermost(a);
  const Position outer_b = outermost(b);
  if (key(outer_a) != key(outer_b)) return key(outer_a) < key(outer_b);
  return key(a) < key(b);
}

}  // namespace finemote::gen
