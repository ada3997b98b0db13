#include "generator/descriptor/library.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "generator/descriptor/check_interfaces.hpp"
#include "generator/descriptor/file_format.hpp"
#include "generator/descriptor/json_file.hpp"
#include "generator/descriptor/library_folders.hpp"
#include "generator/descriptor/read_board.hpp"
#include "generator/descriptor/read_device_type.hpp"
#include "generator/descriptor/read_expander_type.hpp"
#include "generator/descriptor/repair.hpp"
#include "generator/descriptor/schema_check.hpp"
#include "generator/descriptor/schema_file.hpp"
#include "generator/descriptor/shipped.hpp"
#include "generator/file/installed_file.hpp"
#include "generator/xml/read_source.hpp"

namespace finemote::gen {
namespace fs = std::filesystem;
namespace {

/// What the kinds of file have in common: opening, schema version, JSON Schema, the name inside.
class FileReader {
 public:
  FileReader(const Library& library, Sources& sources, Diagnostics& diagnostics, bool always_validate)
      : library_(library), sources_(sources), diagnostics_(diagnostics), needs_schema_(always_validate) {}

  /// The same, of what was read so far.
  [[nodiscard]] FileReader reporting_to(Diagnostics& diagnostics) const {
    return {library_, sources_, diagnostics, needs_schema_};
  }
  std::optional<JsonFile> read(const LibraryFile& file, const FileFormat& format) {
    const std::string path = fs::path(file.path).generic_string();
    // A file of the data folder that is not as it was shipped is the user's: he has to find it.
    const auto name_of = [&](std::string_view bytes) {
      const bool is_known = is_shipped(bytes);
      needs_schema_ = needs_schema_ || !is_known;
      return file.builtin && !is_known ? path : file.display;
    };
    const std::string& unread = file.builtin ? path : file.display;
    const SourceFile* source = xml::read_source(file.path, sources_, diagnostics_, unread, {}, name_of);
    if (source == nullptr) return {};
    std::optional<JsonFile> json = parse_json(*source, diagnostics_);
    if (!json || !has_version(*json, format)) return {};
    return json;
  }
  bool is_valid(const JsonFile& json, const FileFormat& format) { return mistakes(json, format).empty(); }
  std::vector<SchemaMistake> mistakes(const JsonFile& json, const FileFormat& format) {
    if (!needs_schema_) return {};
    const auto schema = read_schema(library_.schema_dir, std::string(format.schema_file), diagnostics_);
    if (!schema) return {SchemaMistake{}};
    return check_schema(json.value, *schema, json.origin, diagnostics_);
  }
  bool has_name(const JsonFile& json, const LibraryFile& file, const FileFormat& format) {
    const auto name = json.value.find(format.name_key);
    if (name == json.value.end() || !name->is_string() || *name == file.name) return true;
    const Extent extent = find_value(json.origin, {format.name_key});
    diagnostics_
        .error(code::descriptor_name, extent.at,
               fmt::format("\"{}\" is '{}' in a file named '{}.json'", format.name_key, name->get<std::string>(),
                           file.name))
        .underline(extent.length)
        .hint(fmt::format("write \"{}\": \"{}\", or rename the file", format.name_key, file.name));
    return false;
  }

 private:
  bool has_version(const JsonFile& json, const FileFormat& format) {
    const auto version = json.value.is_object() ? json.value.find("schema") : json.value.end();
    const bool is_known = json.value.is_object() && version != json.value.end() && *version == format.version;
    if (is_known) return true;
    const Extent extent = find_value(json.origin, {"schema"});
    const std::string found =
        json.value.is_object() && version != json.value.end() ? version->dump() : std::string("none");
    diagnostics_
        .error(code::descriptor_version, extent.at,
               fmt::format("this tool reads \"schema\": \"{}\", not {}", format.version, found))
        .underline(extent.length)
        .hint(fmt::format("\"schema\": \"{}\"", format.version));
    return false;
  }

  const Library& library_;
  Sources& sources_;
  Diagnostics& diagnostics_;
  bool needs_schema_;  ///< something that was read is not as it was shipped
};

LibraryFile* find_file(std::vector<LibraryFile>& files, std::string_view name) {
  const auto found =
      std::find_if(files.begin(), files.end(), [&](const LibraryFile& file) { return file.name == name; });
  return found == files.end() ? nullptr : &*found;
}

/// Whether a file could be read to its end. One whose mistakes were reported may lack what the reader needs.
template <typename Read>
bool succeeds(Read read) {
  try {
    read();
    return true;
  } catch (const Json::exception&) {
    return false;
  }
}

/// The schema comes with the data; should it take more than the reader does, that ends as a message too.
template <typename Read>
bool guarded(const JsonFile& json, Diagnostics& diagnostics, Read read) {
  if (succeeds(read)) return true;
  diagnostics.error(code::descriptor_schema, find_value(json.origin, {}).at, "a member is missing or of another type")
      .note("its schema takes it: the schemas in the data folder are not those of this tool")
      .hint(kInstallAgain);
  return false;
}

/// Where the header of a device type or an expander is found.
template <typename Type>
void place_header(const LibraryFile& file, Type& type) {
  type.builtin = file.builtin;
  type.display_path = file.display;
  if (file.builtin || type.header.empty() || type.header.find("runtime/include/") != std::string::npos) return;
  const fs::path path = fs::path(file.path).parent_path() / type.header;
  type.include_dir = path.parent_path().lexically_normal().generic_string();
}

/// The header of a user's descriptor has to be there; shipped ones are part of the runtime.
void check_header(const JsonFile& json, const LibraryFile& file, const Sources& sources, Diagnostics& diagnostics) {
  const auto member = json.value.find("header");
  if (file.builtin || member == json.value.end() || !member->is_string()) return;
  const auto header = member->get<std::string>();
  if (header.empty()) return;
  const auto denial = sources.access().why_not((fs::path(file.path).parent_path() / header).string());
  if (!denial) return;
  const Extent extent = find_value(json.origin, {"header"});
  if (denial->is_outside) {
    diagnostics.error(code::outside_sandbox, extent.at, fmt::format("cannot read '{}': {}", header, denial->reason))
        .underline(extent.length);
    return;
  }
  diagnostics.error(code::header_missing, extent.at, fmt::format("there is no header '{}' beside this file", header))
      .underline(extent.length)
      .note("the path is relative to the descriptor");
}

bool read_device(Library& library, LibraryFile& file, Sources& sources, Diagnostics& diagnostics,
                 bool always_validate) {
  FileReader reader(library, sources, diagnostics, always_validate);
  const std::size_t findings = diagnostics.size();
  auto json = reader.read(file, kDeviceFormat);
  if (!json) return false;
  const std::vector<SchemaMistake> mistakes = reader.mistakes(*json, kDeviceFormat);
  reader.has_name(*json, file, kDeviceFormat);
  if (!mistakes.empty()) check_header(*json, file, sources, diagnostics);
  if (!mistakes.empty() && !repair_device(json->value, mistakes, file.name)) return false;
  auto type = std::make_unique<DeviceType>();
  const auto read = [&] {
    *type = read_device_type(json->value, json->origin, diagnostics);
    place_header(file, *type);
    if (mistakes.empty()) check_header(*json, file, sources, diagnostics);
    if (!file.builtin) check_interfaces(*type, shipped_interfaces(library.schema_dir), {json->origin, diagnostics});
  };
  if (mistakes.empty() ? !guarded(*json, diagnostics, read) : !succeeds(read)) return false;
  type->name = file.name;
  const bool is_right = diagnostics.size() == findings;
  if (!is_right) relax(*type);
  library.device_types.push_back(std::move(type));  // with mistakes too: the robot is judged by the rest
  return is_right;
}

bool read_expander(Library& library, LibraryFile& file, Sources& sources, Diagnostics& diagnostics,
                   bool always_validate) {
  FileReader reader(library, sources, diagnostics, always_validate);
  const std::size_t findings = diagnostics.size();
  const auto json = reader.read(file, kExpanderFormat);
  if (!json || !reader.is_valid(*json, kExpanderFormat) || !reader.has_name(*json, file, kExpanderFormat)) return false;
  auto type = std::make_unique<ExpanderType>();
  const bool complete = guarded(*json, diagnostics, [&] {
    *type = read_expander_type(json->value, json->origin, diagnostics);
    place_header(file, *type);
    check_header(*json, file, sources, diagnostics);
  });
  if (!complete || diagnostics.size() != findings) return false;
  library.expander_types.push_back(std::move(type));
  return true;
}

/// The board or chip that a board extends; empty where it names none.
std::string extended_by(const Json& board) {
  const auto name = board.find("extends");
  return name != board.end() && name->is_string() ? name->get<std::string>() : std::string();
}

/// Lays a board over the one or the chip that it extends; false when that is wrong or the chain has no end.
bool merge_board(Library& library, JsonFile& json, FileReader& reader, Diagnostics& diagnostics, int depth) {
  if (!json.value.contains("extends")) return true;
  constexpr int kDeepest = 8;
  const std::string name = extended_by(json.value);
  const LibraryFile* board = find_file(library.board_files, name);
  const LibraryFile* base = board != nullptr ? board : find_file(library.chip_files, name);
  if (base == nullptr || depth >= kDeepest) {
    const Extent extent = find_value(json.origin, {"extends"});
    diagnostics
        .error(code::descriptor_contradiction, extent.at,
               base == nullptr ? "there is no such board or chip" : "this board extends itself")
        .underline(extent.length);
    return false;
  }
  const FileFormat& format = board != nullptr ? kBoardFormat : kChipFormat;
  auto below = reader.read(*base, format);
  if (!below || !reader.has_name(*below, *base, format)) return false;
  if (!merge_board(library, *below, reader, diagnostics, depth + 1)) return false;
  below->value.merge_patch(json.value);
  below->value.erase("extends");
  json.value = std::move(below->value);
  json.origin.lay_over(below->origin);
  return true;
}

/// A board from its text merged over those it extends; null when something is wrong with it.
std::unique_ptr<Board> judge_board(const JsonFile& json, const LibraryFile& file, FileReader reader,
                                   Diagnostics& diagnostics) {
  const std::size_t findings = diagnostics.size();
  if (!reader.is_valid(json, kBoardFormat) || !reader.has_name(json, file, kBoardFormat)) return {};
  auto board = std::make_unique<Board>();
  const bool complete = guarded(json, diagnostics, [&] { *board = read_board(json.value, json.origin, diagnostics); });
  board->display_path = file.display;
  return complete && diagnostics.size() == findings ? std::move(board) : nullptr;
}

/// Reads a board. What is wrong with one that it extends is reported there, once, and nothing more.
bool load_board(Library& library, LibraryFile& file, Sources& sources, Diagnostics& diagnostics, bool always_validate) {
  FileReader reader(library, sources, diagnostics, always_validate);
  auto json = reader.read(file, kBoardFormat);
  if (!json) return false;
  const std::string base = extended_by(json->value);
  if (!merge_board(library, *json, reader, diagnostics, 0)) return false;
  Diagnostics aside;
  auto board = judge_board(*json, file, reader.reporting_to(aside), aside);
  if (board == nullptr) {
    const bool extends_board = find_file(library.board_files, base) != nullptr;  // a chip is judged with its boards
    const bool is_base_right = !extends_board || find_board(library, base, sources, diagnostics) != nullptr;
    if (is_base_right) judge_board(*json, file, reader, diagnostics);
    return false;
  }
  library.boards.push_back(std::move(board));
  return true;
}

template <typename T, typename Load>
const T* find_or_load(const std::vector<std::unique_ptr<T>>& loaded, std::vector<LibraryFile>& files,
                      std::string_view name, Load load) {
  for (const auto& entry : loaded) {
    if (entry->name == name) return entry.get();
  }
  LibraryFile* file = find_file(files, name);
  if (file == nullptr || file->failed) return nullptr;
  file->failed = !load(*file);
  return !loaded.empty() && loaded.back()->name == name ? loaded.back().get() : nullptr;
}

std::vector<std::string> names_of(const std::vector<LibraryFile>& files) {
  std::vector<std::string> names;
  for (const LibraryFile& file : files) names.push_back(file.name);
  std::sort(names.begin(), names.end());
  return names;
}

}  // namespace

std::optional<Library> load_library(const LibraryOptions& options, Sources& sources, Diagnostics& diagnostics) {
  Library library;
  const fs::path schemas = fs::path(options.data_dir) / "schemas";
  library.schema_dir = schemas.string();
  files::Denial denial;  // shipped data is never outside
  library.device_files = list_folder(schemas / "devices", "builtin:devices/", true, sources.access(), denial);
  library.board_files = list_folder(schemas / "boards", "builtin:boards/", true, sources.access(), denial);
  library.chip_files = list_folder(schemas / "chips", "builtin:chips/", true, sources.access(), denial);
  library.expander_files = list_folder(schemas / "expanders", "builtin:expanders/", true, sources.access(), denial);
  if (library.board_files.empty()) {
    diagnostics
        .error(code::data_not_found, {}, fmt::format("no board files in '{}'", (schemas / "boards").generic_string()))
        .hint("point --data-dir or FINEMOTE_DATA at FineMote's share folder");
    return {};
  }
  UserFolders folders(library, options.input_dir, sources, diagnostics);
  if (!options.input_dir.empty()) folders.add(fs::path(options.input_dir) / "devices", UserFolders::For::devices);
  folders.add_given(options.device_paths, UserFolders::For::devices);
  folders.add_given(options.board_paths, UserFolders::For::boards);
  return library;
}

const DeviceType* find_device_type(Library& library, std::string_view name, Sources& sources,
                                   Diagnostics& diagnostics) {
  return find_or_load(library.device_types, library.device_files, name,
                      [&](LibraryFile& file) { return read_device(library, file, sources, diagnostics, false); });
}

const ExpanderType* find_expander_type(Library& library, std::string_view name, Sources& sources,
                                       Diagnostics& diagnostics) {
  return find_or_load(library.expander_types, library.expander_files, name,
                      [&](LibraryFile& file) { return read_expander(library, file, sources, diagnostics, false); });
}

const Board* find_board(Library& library, std::string_view name, Sources& sources, Diagnostics& diagnostics) {
  return find_or_load(library.boards, library.board_files, name,
                      [&](LibraryFile& file) { return load_board(library, file, sources, diagnostics, false); });
}

std::vector<std::string> device_type_names(const Library& library) { return names_of(library.device_files); }
std::vector<std::string> board_names(const Library& library) { return names_of(library.board_files); }
std::vector<std::string> expander_type_names(const Library& library) { return names_of(library.expander_files); }

std::string suggested_board(Library& library, Sources& sources) {
  Diagnostics ignored;  // what is wrong with a board is said when a robot names it
  for (const LibraryFile& file : std::vector<LibraryFile>(library.board_files)) {
    const Board* board = file.builtin ? find_board(library, file.name, sources, ignored) : nullptr;
    if (board != nullptr && board->is_suggested) return board->name;
  }
  return "...";
}

std::string suggested_mux(Library& library, Sources& sources) {
  Diagnostics ignored;
  for (const LibraryFile& file : std::vector<LibraryFile>(library.expander_files)) {
    const ExpanderType* type = file.builtin ? find_expander_type(library, file.name, sources, ignored) : nullptr;
    if (type != nullptr && type->is_mux() && type->is_suggested) return type->name;
  }
  return "...";
}

void check_whole_library(Library& library, Sources& sources, Diagnostics& diagnostics) {
  for (LibraryFile& file : library.board_files) file.failed = !load_board(library, file, sources, diagnostics, true);
  for (LibraryFile& file : library.expander_files)
    file.failed = !read_expander(library, file, sources, diagnostics, true);
  for (LibraryFile& file : library.device_files) file.failed = !read_device(library, file, sources, diagnostics, true);
}

}  // namespace finemote::gen
