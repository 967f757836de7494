#pragma once

// A program that spreads a world over processes runs from one snapshot to another.

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include "shares/compare.h"

namespace halfspace_test {

using Snapshot = std::vector<unsigned char>;

inline void write_file(const std::filesystem::path& path, const Snapshot& bytes) {
  std::ofstream(path, std::ios::binary)
      .write(reinterpret_cast<const char*>(bytes.data()), std::streamsize(bytes.size()));
}

inline Snapshot read_file(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

/// A folder of its own, which is gone in the end.
struct Folder {
  std::filesystem::path path;

  explicit Folder(const std::string& name)
      : path(std::filesystem::temp_directory_path() / (name + "_" + std::to_string(std::random_device()()))) {
    std::filesystem::create_directories(path);
  }
  ~Folder() { std::filesystem::remove_all(path); }
  std::string file(const std::string& name) const { return (path / name).string(); }
};

/// The end of a program: success, and its output.
struct Ended {
  bool is_success;
  std::string output;
};

/// Runs a program on so many processes, more than there are processors.
inline Ended ended_on(int processes, const std::string& program, const Folder& folder) {
  setenv("OMPI_ALLOW_RUN_AS_ROOT", "1", 1);
  setenv("OMPI_ALLOW_RUN_AS_ROOT_CONFIRM", "1", 1);
  setenv("OMPI_MCA_rmaps_base_oversubscribe", "1", 1);
  const std::string output = folder.file("output");
  const std::string command =
      HALFSPACE_MPIEXEC " " + std::to_string(processes) + " " + program + " > " + output + " 2>&1";
  const int status = std::system(command.c_str());
  const Snapshot text = read_file(output);
  return {status == 0, {text.begin(), text.end()}};
}

inline void run_on(int processes, const std::string& program, const Folder& folder) {
  const Ended ended = ended_on(processes, program, folder);
  INFO(program << '\n' << ended.output);
  REQUIRE(ended.is_success);
}

/// Runs the command `halfspace`.
inline void run_command(const std::string& arguments) {
  INFO("halfspace " << arguments);
  REQUIRE(std::system((HALFSPACE_COMMAND " " + arguments + " > /dev/null").c_str()) == 0);
}

/// Cuts a snapshot into shares, and joins others.
inline void split(const Snapshot& start, int shares, const Folder& folder, const std::string& directory) {
  write_file(folder.file("whole.hsw"), start);
  run_command("split " + folder.file("whole.hsw") + " " + std::to_string(shares) + " " +
              folder.file(directory));
}
inline Snapshot joined(const Folder& folder, const std::string& directory) {
  run_command("join " + folder.file(directory) + " " + folder.file("joined.hsw"));
  return read_file(folder.file("joined.hsw"));
}

/// The snapshot at the end of a run of the example for MPI.
inline Snapshot run_shares(const Snapshot& start, int processes, std::int64_t steps) {
  const Folder folder("halfspace_shares_mpi");
  split(start, processes, folder, "start");
  run_on(processes,
         HALFSPACE_HOST " " + folder.file("start") + " " + std::to_string(steps) + " " + folder.file("end"),
         folder);
  return joined(folder, "end");
}

/// A run of a host ends with the bits of the whole world.
inline void check_end(const Snapshot& start, std::int64_t steps, const Snapshot& end) {
  const Context context = make_context();
  const World whole = restored(context.get(), start), joined = restored(context.get(), end);
  require_ok(hs_world_step(whole.get(), steps), context.get());
  CHECK(first_difference(context.get(), joined.get(), context.get(), whole.get()) == "none");
  std::vector<double> sums(HS_SUM_COUNT);
  require_ok(hs_world_get_sums(joined.get(), sums.data()), context.get());
  check_sums(sums, whole.get());
  CHECK(report_of(joined.get()).steps == report_of(whole.get()).steps);
}

}  // namespace halfspace_test
