#include "files.h"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <system_error>
#include <utility>

namespace halfspace::cli {
namespace fs = std::filesystem;
namespace {

void remove_matching(const fs::path& directory, const char* begin, const char* end) {
  if (!fs::is_directory(directory)) return;
  std::vector<fs::path> matching;
  for (const fs::directory_entry& entry : fs::directory_iterator(directory)) {
    const std::string name = entry.path().filename().string();
    if (name.starts_with(begin) && name.ends_with(end)) matching.push_back(entry.path());
  }
  for (const fs::path& file : matching) fs::remove(file);
}

void remove_earlier_run(const fs::path& path) {
  for (const char* name : {"run.pvd", "history.csv", "first.svg", "last.svg", "summary.txt"})
    fs::remove(path / name);
  remove_matching(path, "at_", "s.svg");
  remove_matching(path / "frames", "frame_", ".vtp");
}

}  // namespace

std::string content_of(const std::string& file) {
  std::ifstream stream(file, std::ios::binary);
  std::string content{std::istreambuf_iterator<char>(stream), {}};
  if (!stream.is_open() || stream.bad()) throw std::runtime_error("cannot read " + file);
  return content;
}

OutputDirectory::OutputDirectory(fs::path path, bool force) : path_(std::move(path)) {
  try {
    fs::create_directories(path_);
    if (!fs::is_directory(path_)) throw std::runtime_error(path_.string() + " is not a directory");
    if (!force && !fs::is_empty(path_)) {
      throw std::runtime_error("the directory " + path_.string() +
                               " is not empty; --force replaces an earlier run in it");
    }
    remove_earlier_run(path_);
    fs::create_directories(path_ / "frames");
  } catch (const fs::filesystem_error& error) {
    throw std::runtime_error("cannot use the directory " + path_.string() + ": " + error.code().message());
  }
}

void OutputDirectory::write(const std::string& name, const std::string& content) {
  const fs::path target = path_ / name;
  const fs::path temporary = target.string() + ".part";
  std::ofstream stream(temporary, std::ios::binary);
  stream << content;
  stream.close();
  std::error_code error;
  if (stream) fs::rename(temporary, target, error);
  if (!stream || error) {
    std::error_code ignored;
    fs::remove(temporary, ignored);
    throw std::runtime_error("cannot write " + target.string() + (error ? ": " + error.message() : ""));
  }
  if (std::find(written_.begin(), written_.end(), name) == written_.end()) written_.push_back(name);
}

}  // namespace halfspace::cli
