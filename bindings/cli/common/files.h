#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace halfspace::cli {

/// All bytes of a file. @throws std::runtime_error if it cannot be read
std::string content_of(const std::string& file);

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

/// The output directory of a run. Files are complete or absent: each is written under another name, then
/// renamed.
class OutputDirectory {
 public:
  /// With Earlier::replace, files of an earlier run are removed before the first file is written; other files
  /// stay.
  /// @throws std::runtime_error if the directory cannot be created, or has files and `earlier` is
  /// Earlier::refuse
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
  bool is_made_ = false;              ///< by this object
  bool replaces_;                     ///< the files of an earlier run, which are not removed yet
  std::vector<std::string> written_;  ///< in the order of first writing
};

}  // namespace halfspace::cli
