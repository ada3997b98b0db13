#include "generator/xml/read_source.hpp"

#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <optional>

#include "generator/xml/locate.hpp"

namespace finemote::gen::xml {
namespace {

/// Length of the UTF-8 sequence a byte begins, or 0.
std::size_t sequence_length(unsigned char lead) {
  if (lead < 0x80) return 1;
  if (lead >= 0xC2 && lead <= 0xDF) return 2;
  if (lead >= 0xE0 && lead <= 0xEF) return 3;
  if (lead >= 0xF0 && lead <= 0xF4) return 4;
  return 0;
}

/// Table 3-7 of the Unicode standard: what the second byte may be, given the first.
bool is_valid_second(unsigned char lead, unsigned char second) {
  switch (lead) {
    case 0xE0:
      return second >= 0xA0 && second <= 0xBF;
    case 0xED:
      return second >= 0x80 && second <= 0x9F;
    case 0xF0:
      return second >= 0x90 && second <= 0xBF;
    case 0xF4:
      return second >= 0x80 && second <= 0x8F;
    default:
      return second >= 0x80 && second <= 0xBF;
  }
}

bool is_valid_sequence(std::string_view bytes, std::size_t length) {
  if (length == 0 || bytes.size() < length) return false;
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(bytes[i]); };
  if (length > 1 && !is_valid_second(byte(0), byte(1))) return false;
  for (std::size_t i = 2; i < length; ++i) {
    if ((byte(i) & 0xC0) != 0x80) return false;
  }
  return true;
}

/// The name in `<?xml ... encoding="NAME"?>`, in lower case.
std::string declared_encoding(std::string_view text) {
  if (!text.starts_with("<?xml")) return {};
  const std::string_view declaration = text.substr(0, text.find("?>"));
  auto at = declaration.find("encoding");
  if (at == std::string_view::npos) return {};
  at = declaration.find_first_of("\"'", at);
  if (at == std::string_view::npos) return {};
  std::string name(declaration.substr(at + 1, declaration.find(declaration[at], at + 1) - at - 1));
  std::transform(name.begin(), name.end(), name.begin(), [](char c) { return c >= 'A' && c <= 'Z' ? c + 32 : c; });
  return name;
}

bool is_latin1(std::string_view encoding) {
  return encoding == "iso-8859-1" || encoding == "latin-1" || encoding == "latin1";
}

std::string latin1_to_utf8(std::string_view text) {
  std::string out;
  out.reserve(text.size() + text.size() / 8);
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte < 0x80) {
      out += c;
    } else {
      out += static_cast<char>(0xC0 | (byte >> 6));
      out += static_cast<char>(0x80 | (byte & 0x3F));
    }
  }
  return out;
}

/// One read with everything its errors need.
struct Request {
  const std::string& path;
  std::string name;
  Position at;
  Sources& sources;
  Diagnostics& diagnostics;

  /// Reports at the one who asked, else at the file as a whole.
  void fail(Code code, const std::string& message) const {
    Position where = at;
    if (where.file == nullptr) where.file = sources.add(SourceFile{name, path, {}});
    diagnostics.error(code, where, message);
  }
};

files::Handle open_file(const Request& request) {
  if (request.path == "-") return files::Handle(::dup(STDIN_FILENO));
  const files::Asked asked = request.at.file == nullptr ? files::Asked::by_user : files::Asked::by_file;
  files::Denial denial;
  files::Handle file = request.sources.access().open(request.path, asked, denial);
  if (file) return file;
  const std::string message = fmt::format("cannot read '{}': {}", request.name, denial.reason);
  request.fail(denial.is_outside ? code::outside_sandbox : code::unreadable_file, message);
  return file;
}

/// One byte more than a regular file holds, so that one read sees its end; a block for pipes and devices.
std::size_t first_block(int file) {
  struct stat status {};
  const bool is_regular = ::fstat(file, &status) == 0 && S_ISREG(status.st_mode);
  return is_regular ? static_cast<std::size_t>(std::clamp<off_t>(status.st_size + 1, 1, 1 << 20)) : 1 << 16;
}

/// Fills `text` from `size` on, as far as the file reaches. Returns how many bytes, or -1.
ssize_t read_block(int file, std::string& text, std::size_t size) {
  std::size_t filled = size;
  while (filled < text.size()) {
    const ssize_t count = ::read(file, text.data() + filled, text.size() - filled);
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) return -1;
    if (count == 0) break;
    filled += static_cast<std::size_t>(count);
  }
  return static_cast<ssize_t>(filled - size);
}

std::optional<std::string> read_all(int file, const Request& request) {
  std::string text;
  std::size_t size = 0;
  do {
    text.resize(size == 0 ? first_block(file) : std::max<std::size_t>(size * 2, 1 << 16));
    const ssize_t count = read_block(file, text, size);
    if (count < 0) {
      request.fail(code::unreadable_file, fmt::format("cannot read '{}': {}", request.name, std::strerror(errno)));
      return std::nullopt;
    }
    size += static_cast<std::size_t>(count);
    if (size > kMaxFileSize) {
      request.fail(code::file_too_large, fmt::format("'{}' is larger than {} MiB", request.name, kMaxFileSize >> 20));
      return std::nullopt;
    }
  } while (size == text.size());
  text.resize(size);
  return text;
}

/// How many bytes at the beginning are ASCII; looks at eight at a time.
std::size_t ascii_length(std::string_view text) {
  constexpr std::uint64_t high_bits = 0x8080808080808080;
  std::size_t i = 0;
  for (std::uint64_t eight = 0; i + sizeof eight <= text.size(); i += sizeof eight) {
    std::memcpy(&eight, text.data() + i, sizeof eight);
    if ((eight & high_bits) != 0) break;
  }
  while (i < text.size() && static_cast<unsigned char>(text[i]) < 0x80) ++i;
  return i;
}

}  // namespace

std::size_t find_invalid_utf8(std::string_view text) {
  for (std::size_t i = ascii_length(text); i < text.size(); i += ascii_length(text.substr(i))) {
    const std::size_t length = sequence_length(static_cast<unsigned char>(text[i]));
    if (!is_valid_sequence(text.substr(i, 4), length)) return i;
    i += length;
  }
  return std::string_view::npos;
}

const SourceFile* read_source(const std::string& path, Sources& sources, Diagnostics& diagnostics,
                              std::string_view name, Position at,
                              const std::function<std::string(std::string_view bytes)>& name_of) {
  std::string shown(name.empty() ? std::string_view(path) : name);
  if (path == "-" && name.empty()) shown = "<stdin>";
  Request request{path, std::move(shown), at, sources, diagnostics};

  const files::Handle file = open_file(request);
  if (!file) return nullptr;
  auto text = read_all(file.get(), request);
  if (!text) return nullptr;
  if (name_of) request.name = name_of(*text);
  if (text->starts_with("\xEF\xBB\xBF")) text->erase(0, 3);
  if (text->empty()) {
    request.fail(code::empty_file, fmt::format("'{}' is empty", request.name));
    return nullptr;
  }
  if (is_latin1(declared_encoding(*text))) text = latin1_to_utf8(*text);

  const SourceFile* source = sources.add(SourceFile{request.name, path == "-" ? "" : path, std::move(*text)});
  const std::size_t wrong = find_invalid_utf8(source->text);
  if (wrong == std::string_view::npos) return source;
  diagnostics
      .error(code::not_utf8, Locator(*source).at(wrong),
             fmt::format("'{}' is not UTF-8: byte 0x{:02x}", request.name,
                         static_cast<unsigned char>(source->text[wrong])))
      .hint("save the file as UTF-8");
  return nullptr;
}

}  // namespace finemote::gen::xml
