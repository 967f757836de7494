#include "recording/bytes.h"

#include <cerrno>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <system_error>

namespace halfspace::viewer {

std::string bytes_of(const std::string& file) {
  std::ifstream stream(file, std::ios::binary | std::ios::ate);
  const std::streamoff size = stream.is_open() ? static_cast<std::streamoff>(stream.tellg()) : -1;
  if (size < 0) throw std::runtime_error("cannot read " + file);
  std::string bytes(static_cast<std::size_t>(size), '\0');
  stream.seekg(0);
  if (!stream.read(bytes.data(), size)) throw std::runtime_error("cannot read " + file);
  return bytes;
}

void write_bytes(const std::string& file, const std::string& bytes) {
  const std::filesystem::path folder = std::filesystem::path(file).parent_path();
  std::error_code ignored;  // the file tells of it
  if (!folder.empty()) std::filesystem::create_directories(folder, ignored);
  errno = 0;
  std::ofstream stream(file, std::ios::binary);
  stream.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  stream.close();
  if (!stream)
    throw std::runtime_error("cannot write " + file +
                             (errno != 0 ? ": " + std::generic_category().message(errno) : ""));
}

}  // namespace halfspace::viewer
