#pragma once

#include <filesystem>

namespace halfspace::cli {

/// Holds a directory for one run. The system releases the lock when the process ends, however it ends.
class DirectoryLock {
 public:
  /// On file systems without locks it holds nothing. @throws std::runtime_error if another run holds the
  /// directory
  explicit DirectoryLock(const std::filesystem::path& directory);
  ~DirectoryLock();
  DirectoryLock(const DirectoryLock&) = delete;
  DirectoryLock& operator=(const DirectoryLock&) = delete;

 private:
  int file_;
};

}  // namespace halfspace::cli
