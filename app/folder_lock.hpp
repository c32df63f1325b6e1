// One process at a time in a folder.
#pragma once

#include <filesystem>

namespace spindrift::app {

/// Held as long as it lives, and no longer than its process.
class FolderLock {
 public:
  /// @param wait for the process that holds the lock, or throw at once
  /// @throws std::runtime_error that names the folder
  FolderLock(const std::filesystem::path& folder, bool wait);
  ~FolderLock();
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;

 private:
  int descriptor_;
};

}  // namespace spindrift::app
