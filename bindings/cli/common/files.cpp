#include "common/files.h"

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <cstdio>
#include <fstream>
#include <stdexcept>
#include <string_view>
#include <system_error>
#include <utility>

namespace halfspace::cli {
namespace fs = std::filesystem;
namespace {

/// True for numbered files of a run, such as at_2.5s.svg and frames/frame_0007.vtp.
bool is_number_between(std::string_view name, std::string_view begin, std::string_view end) {
  if (name.size() <= begin.size() + end.size() || !name.starts_with(begin) || !name.ends_with(end))
    return false;
  const std::string_view middle = name.substr(begin.size(), name.size() - begin.size() - end.size());
  return middle.find_first_not_of("0123456789.e+-") == std::string_view::npos;
}

void remove_numbered(const fs::path& directory, std::string_view begin, std::string_view end) {
  if (!fs::is_directory(directory)) return;
  std::vector<fs::path> numbered;
  for (const fs::directory_entry& entry : fs::directory_iterator(directory)) {
    if (is_number_between(entry.path().filename().string(), begin, end)) numbered.push_back(entry.path());
  }
  for (const fs::path& file : numbered) fs::remove(file);
}

std::string numbered(const char* begin, int number) {
  char digits[16];
  std::snprintf(digits, sizeof digits, "%04d", number);
  return begin + std::string(digits) + ".vtp";
}

/// Removes links, and keeps their targets.
void remove_earlier_run(const fs::path& path) {
  const fs::path frames = path / "frames";
  if (fs::is_symlink(frames)) fs::remove(frames);
  for (const char* name :
       {"run.pvd",     "contacts.pvd",        "contacts.csv", "cracks.csv",  "bolts.csv",  "bolts.pvd",
        "history.csv", "first.svg",           "last.svg",     "summary.txt", "safety.txt", "stands.svg",
        "falls.svg",   "trade.csv",           "trade.txt",    "trade.svg",   "limit.txt",  "trials.csv",
        "table.csv",   "table.svg",           "results.csv",  "joints.csv",  "checkpoint", "blocks.csv",
        "water.pvd",   "show_in_paraview.py", "view.html",    "terrain.pvd"})
    fs::remove(path / name);
  remove_numbered(path, "at_", "s.svg");
  remove_numbered(path, "stage_", ".svg");
  remove_numbered(path, "stage_", ".checkpoint");
  remove_numbered(path, "share_", ".hsw");
  remove_numbered(frames, "frame_", ".vtp");
  remove_numbered(frames, "contacts_", ".vtp");
  remove_numbered(frames, "bolts_", ".vtp");
  remove_numbered(frames, "water_", ".vtp");
  remove_numbered(frames, "terrain_", ".vtp");
  if (!fs::is_directory(path / "runs")) return;
  for (const fs::directory_entry& run : fs::directory_iterator(path / "runs"))
    if (run.is_directory() && !run.is_symlink()) remove_earlier_run(run.path());
}

/// Writes a new file; a file or a link of that name is removed first. @return 0, or the number of the error
int write_new(const fs::path& path, const std::string& content) {
  std::error_code ignored;
  fs::remove(path, ignored);
  std::FILE* file = std::fopen(path.c_str(), "wbx");
  if (!file) return errno;
  int error = std::fwrite(content.data(), 1, content.size(), file) == content.size() ? 0 : errno;
  if (std::fclose(file) != 0 && error == 0) error = errno;
  return error;
}

/// True if the directory was made.
bool make_directory(const fs::path& path) {
  try {
    const bool is_made = fs::create_directories(path);
    if (!fs::is_directory(path)) throw std::runtime_error(path.string() + " is not a directory");
    return is_made;
  } catch (const fs::filesystem_error& error) {
    throw std::runtime_error("cannot use the directory " + path.string() + ": " + error.code().message());
  }
}

}  // namespace

std::string content_of(const std::string& file) {
  std::error_code unreadable;  // reported below
  if (fs::is_directory(file, unreadable))
    throw std::runtime_error("cannot read " + file + ": it is a directory");
  std::ifstream stream(file, std::ios::binary);
  std::string content;
  // A file larger than the memory is refused before it is read; streams have no size.
  const std::uintmax_t size = fs::is_regular_file(file, unreadable) ? fs::file_size(file, unreadable) : 0;
  try {
    content.reserve(size);
  } catch (const std::exception&) {
    throw std::runtime_error("cannot read " + file + ": there is no memory for its " + std::to_string(size) +
                             " bytes");
  }
  char part[1 << 16];
  while (stream.read(part, sizeof part), stream.gcount() > 0)
    content.append(part, static_cast<std::size_t>(stream.gcount()));
  if (!stream.is_open() || stream.bad()) throw std::runtime_error("cannot read " + file);
  return content;
}

void write_file(const fs::path& file, const std::string& content) {
  const fs::path temporary = file.string() + ".part";
  std::error_code error;
  if (file.has_parent_path()) fs::create_directories(file.parent_path(), error);
  if (!error) error = {write_new(temporary, content), std::generic_category()};
  if (!error) fs::rename(temporary, file, error);
  if (!error) return;
  std::error_code ignored;
  fs::remove(temporary, ignored);
  throw std::runtime_error("cannot write " + file.string() + ": " + error.message());
}

std::string extension_of(const std::string& file) {
  std::string extension = fs::path(file).extension().string();
  for (char& c : extension) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return extension;
}

std::string frame_name(int number) { return numbered("frames/frame_", number); }
std::string contacts_name(int number) { return numbered("frames/contacts_", number); }
std::string bolts_name(int number) { return numbered("frames/bolts_", number); }
std::string water_name(int number) { return numbered("frames/water_", number); }
std::string terrain_name(int number) { return numbered("frames/terrain_", number); }

std::string stage_checkpoint_name(std::size_t stage) {
  return "stage_" + std::to_string(stage) + ".checkpoint";
}

std::string share_name(std::size_t number) { return "share_" + std::to_string(number) + ".hsw"; }

OutputDirectory::OutputDirectory(fs::path path, Earlier earlier)
    : path_(std::move(path)),
      is_made_(make_directory(path_)),
      lock_(path_),
      replaces_(earlier == Earlier::replace) {
  std::error_code error;
  if (earlier != Earlier::refuse || fs::is_empty(path_, error)) return;
  if (error) throw std::runtime_error("cannot use the directory " + path_.string() + ": " + error.message());
  throw std::runtime_error("the directory " + path_.string() +
                           " is not empty; --force replaces an earlier run in it");
}

OutputDirectory::~OutputDirectory() {
  std::error_code error;
  if (is_made_ && written_.empty()) fs::remove(path_, error);  // not if another program has written to it
}

void OutputDirectory::remove_frames_from(int number) {
  for (;; ++number) {
    const fs::path frame = path_ / frame_name(number);
    std::error_code error;
    for (const std::string& name :
         {contacts_name(number), bolts_name(number), water_name(number), terrain_name(number)}) {
      fs::remove(path_ / name, error);
      fs::remove(path_ / (name + ".part"), error);
    }
    const bool was_half_written = fs::remove(frame.string() + ".part", error);
    if (!fs::remove(frame, error) && !was_half_written) return;
  }
}

void OutputDirectory::remove_stages_from(std::size_t number) {
  std::error_code error;
  while (fs::remove(path_ / stage_checkpoint_name(number), error)) ++number;
}

void OutputDirectory::write(const std::string& name, const std::string& content) {
  if (replaces_) remove_earlier_run(path_);
  replaces_ = false;
  write_file(path_ / name, content);
  if (std::find(written_.begin(), written_.end(), name) == written_.end()) written_.push_back(name);
}

}  // namespace halfspace::cli
