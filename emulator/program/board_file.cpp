#include "emulator/program/board_file.hpp"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <system_error>
#include <vector>

namespace finemote::emulator {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

/// Folders with boards and chips, those that are there.
std::vector<fs::path> folders() {
  std::error_code ignored;
  const fs::path program = fs::read_symlink("/proc/self/exe", ignored).parent_path();
  std::vector<fs::path> places{program / "share", program.parent_path() / "share" / "finemote"};
  const char* environment = std::getenv("FINEMOTE_DATA");
  if (environment != nullptr && *environment != '\0') places = {environment};
  std::vector<fs::path> found;
  for (const fs::path& place : places) {
    for (const char* kind : {"boards", "chips"}) {
      const fs::path folder = place / "schemas" / kind;
      if (fs::is_directory(folder, ignored)) found.push_back(folder);
    }
  }
  return found;
}

std::string names_in(const std::vector<fs::path>& places) {
  std::vector<std::string> names;
  for (const fs::path& folder : places) {
    if (folder.filename() != "boards") continue;
    for (const auto& entry : fs::directory_iterator(folder)) names.push_back(entry.path().stem().string());
  }
  std::sort(names.begin(), names.end());
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "'" : ", '") + name + "'";
  return text;
}

fs::path find(const std::string& board, const std::vector<fs::path>& places) {
  std::error_code ignored;
  if (board.find('/') != std::string::npos || fs::is_regular_file(board, ignored)) return board;
  for (const fs::path& folder : places) {
    const fs::path file = folder / (board + ".json");
    if (fs::is_regular_file(file, ignored)) return file;
  }
  throw std::invalid_argument("there is no board '" + board + "'; there are " + names_in(places));
}

Json parse(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  if (!in) throw std::invalid_argument("cannot read '" + file.string() + "'");
  try {
    return Json::parse(in);
  } catch (const nlohmann::json::exception& error) {
    throw std::invalid_argument("'" + file.string() + "' is no board file: " + error.what());
  }
}

/// RFC 7386, as schemas/board.schema.json says of `extends`.
Json merged(const fs::path& file, unsigned depth) {
  constexpr unsigned kMost = 16;
  Json board = parse(file);
  const auto base = board.find("extends");
  if (base == board.end() || !base->is_string()) return board;
  if (depth == kMost) throw std::invalid_argument("'" + file.string() + "' extends itself");
  std::vector<fs::path> places = folders();
  places.insert(places.begin(), file.parent_path().empty() ? "." : file.parent_path());
  Json whole = merged(find(base->get<std::string>(), places), depth + 1);
  whole.merge_patch(board);
  return whole;
}

}  // namespace

Json read_board_file(const std::string& board) { return merged(find(board, folders()), 0); }

}  // namespace finemote::emulator
