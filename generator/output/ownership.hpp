// Tells files that finemote wrote from those of users.
#pragma once

#include <map>
#include <string>

#include "generator/output/folder.hpp"

namespace finemote::gen {

/// A file is ours if its hash is the manifest's, or its bytes are what this run writes, or it differs from either by CR
/// alone. Whatever else stands in the folder is the user's.
class Ownership {
 public:
  /// Both must outlive the object. The manifest an interrupted run left under a temporary name counts as well: such a
  /// run may have put files in place already.
  Ownership(const Folder& folder, const Output& output);

  /// Whether a file of this name (below the folder) that holds `bytes` is ours.
  [[nodiscard]] bool is_ours(const std::string& name, const std::string& bytes) const;
  /// Whether a manifest has a file of this name.
  [[nodiscard]] bool is_listed(const std::string& name) const { return written_.count(name) > 0; }

 private:
  void remember(const Manifest& manifest);

  std::multimap<std::string, std::string> written_;        ///< name -> hash
  std::map<std::string, const std::string*> written_now_;  ///< name -> text
};

}  // namespace finemote::gen
