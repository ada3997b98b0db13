#include "generator/output/ownership.hpp"

#include <algorithm>

#include "generator/output/sha256.hpp"

namespace finemote::gen {

namespace fs = std::filesystem;

Ownership::Ownership(const Folder& folder, const Output& output) {
  remember(folder.previous);
  for (const OutputFile& file : output.files) written_now_[file.name] = &file.text;
  const std::string unfinished = std::string(kManifestName) + kTemporaryMark;
  std::error_code error;
  for (fs::directory_iterator entry(folder.root, error), end; !error && entry != end; entry.increment(error)) {
    if (entry->path().filename().string().rfind(unfinished, 0) != 0) continue;
    const auto manifest = parse_manifest(read_bytes(entry->path().string()).value_or(""));
    if (manifest) remember(*manifest);
  }
}

void Ownership::remember(const Manifest& manifest) {
  for (const HashedFile& file : manifest.outputs) written_.emplace(file.name, file.sha256);
}

bool Ownership::is_ours(const std::string& name, const std::string& bytes) const {
  const std::string plain = without_carriage_returns(bytes);
  const auto now = written_now_.find(name);
  if (now != written_now_.end() && (bytes == *now->second || plain == without_carriage_returns(*now->second)))
    return true;
  const auto [first, last] = written_.equal_range(name);
  if (first == last) return false;
  const std::string hash = sha256(bytes), plain_hash = sha256(plain);
  return std::any_of(first, last,
                     [&](const auto& entry) { return entry.second == hash || entry.second == plain_hash; });
}

}  // namespace finemote::gen
