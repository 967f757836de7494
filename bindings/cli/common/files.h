#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "common/directory_lock.h"

namespace halfspace::cli {

/// All bytes of a file. @throws std::runtime_error if it cannot be read
std::string content_of(const std::string& file);

/// Writes a file, which is complete or absent: it is written under another name, then renamed.
/// @throws std::runtime_error with the reason
void write_file(const std::filesystem::path& file, const std::string& content);

/// The extension of a path in lower case, as ".csv".
std::string extension_of(const std::string& file);

/// The paths of a frame and its contacts in the directory of their run.
std::string frame_name(int number);
std::string contacts_name(int number);
std::string bolts_name(int number);
std::string water_name(int number);
std::string terrain_name(int number);

/// The name of the checkpoint at the end of a stage.
std::string stage_checkpoint_name(std::size_t stage);

/// The name of a share among those of a world.
std::string share_name(std::size_t number);

/// Handling of the files of an earlier run.
enum class Earlier { refuse, replace, keep };

/// The output directory of a run, which no other run can have meanwhile.
class OutputDirectory {
 public:
  /// With Earlier::replace, files of an earlier run are removed before the first file is written; other files
  /// stay.
  /// @throws std::runtime_error if the directory cannot be created, is that of another run, or has files and
  /// `earlier` is Earlier::refuse
  OutputDirectory(std::filesystem::path path, Earlier earlier);
  /// A directory that was made and has no file is removed.
  ~OutputDirectory();
  OutputDirectory(const OutputDirectory&) = delete;
  OutputDirectory& operator=(const OutputDirectory&) = delete;

  /// Removes the frames from this number on.
  void remove_frames_from(int number);
  /// Removes the checkpoints at the ends of the stages from this number on.
  void remove_stages_from(std::size_t number);
  /// Writes a file, given its path in the directory. @throws std::runtime_error
  void write(const std::string& name, const std::string& content);

  const std::filesystem::path& path() const { return path_; }
  const std::vector<std::string>& written() const { return written_; }

 private:
  std::filesystem::path path_;
  bool is_made_;  ///< by this object
  DirectoryLock lock_;
  bool replaces_;                     ///< the files of an earlier run, which are not removed yet
  std::vector<std::string> written_;  ///< in the order of first writing
};

}  // namespace halfspace::cli
