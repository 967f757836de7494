#include <cstdio>
#include <filesystem>
#include <stdexcept>

#include "commands/commands.h"
#include "common/text.h"
#include "recording/run_folder.h"

namespace halfspace::cli {
namespace fs = std::filesystem;
namespace {

/// The viewer's page, which is installed or built beside the command.
std::string viewer_page() {
  const fs::path bin = fs::read_symlink("/proc/self/exe").parent_path();
  const fs::path page = bin.parent_path() / "share/halfspace/viewer/viewer.html";
  if (!fs::exists(page)) {
    throw std::runtime_error("there is no viewer: " + page.string() +
                             " is missing, as this command was built without three.js (Debian: libjs-three)");
  }
  return content_of(page.string());
}

}  // namespace

int view(const std::string& directory, const std::string& file) {
  const std::string viewer = viewer_page();
  viewer::Recording recording = viewer::read_run(directory);
  const std::string page = recording.page(viewer);
  const fs::path target = file.empty() ? fs::path(directory) / "view.html" : fs::path(file);
  write_file(target, page);
  print(stdout, target.string() + ": " + std::to_string(recording.frame_count()) + " frames of " +
                    std::to_string(recording.block_count()) + " blocks, " +
                    decimals(static_cast<double>(page.size()) / 1e6, 1) + " MB; open it in a browser\n");
  return exit_ok;
}

}  // namespace halfspace::cli
