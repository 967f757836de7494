#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace halfspace::cli {

/// All bytes of a file. @throws std::runtime_error if it cannot be read
std::string content_of(const std::string& file);

/// The paths of a frame and its contacts in the directory of their run.
std::string frame_name(int number);
std::string contacts_name(int number);

/// The fate of files of an earlier run.
enum class Earlier { refuse, replace, keep };

/// The directory of one run. A file in it is either whole or not there: it is written under another name and
/// renamed.
class OutputDirectory {
 public:
  /// @throws std::runtime_error if the directory cannot be made, or holds files that are refused. What an
  /// earlier run wrote there is removed, where it is replaced, before the first file is written; other files
  /// stay.
  OutputDirectory(std::filesystem::path path, Earlier earlier);

  /// Removes the frames from this number on.
  void remove_frames_from(int number);
  /// Writes a file, given its path in the directory. @throws std::runtime_error
  void write(const std::string& name, const std::string& content);

  const std::filesystem::path& path() const { return path_; }
  const std::vector<std::string>& written() const { return written_; }

 private:
  std::filesystem::path path_;
  bool replaces_;                     ///< an earlier run, still to be removed
  std::vector<std::string> written_;  ///< in the order of first writing
};

}  // namespace halfspace::cli
