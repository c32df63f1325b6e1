// A lock that lets one process at a time work in a folder.
#pragma once

#include <filesystem>

namespace spindrift::app {

/// Holds the lock of a folder as long as the object, and at most its process, lives. The lock's
/// file, ".lock" in the folder, names the process that holds it.
class FolderLock {
 public:
  /// Takes the lock, and makes the folder where there is none. Once the lock is held, unfinished
  /// files that killed processes have left in the folder are removed.
  /// @param wait whether to wait for a process that holds the lock, or to throw at once
  /// @throws std::runtime_error that names the folder, the process at work there, and since when
  FolderLock(const std::filesystem::path& folder, bool wait);
  ~FolderLock();
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;

 private:
  int descriptor_;
};

}  // namespace spindrift::app
