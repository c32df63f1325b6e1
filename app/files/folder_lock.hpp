// One process at a time in a folder.
#pragma once

#include <filesystem>

namespace spindrift::app {

/// Held as long as it lives, and no longer than its process. The file of the lock says who holds
/// it.
class FolderLock {
 public:
  /// Makes the folder where there is none. Once it is held, what killed processes were about to
  /// write in the folder is removed.
  /// @param wait for the process that holds the lock, or throw at once
  /// @throws std::runtime_error that names the folder, and who is at work there since when
  FolderLock(const std::filesystem::path& folder, bool wait);
  ~FolderLock();
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;

 private:
  int descriptor_;
};

}  // namespace spindrift::app
