#pragma once

// Runs of LAMMPS with fix halfspace.

#include "hosts/host_run.h"

namespace halfspace_test {

class LammpsRun {
 public:
  LammpsRun(const Snapshot& start, bool is_plane) : is_plane_(is_plane), folder_("halfspace_lammps") {
    write_file(folder_.file("start.hsw"), start);
  }

  /// The first lines of a script.
  std::string box(const std::string& plane = "-40 40 -40 40") const {
    const std::string dimension = is_plane_ ? "2" : "3", z = is_plane_ ? "p" : "s";
    return "units si\ndimension " + dimension + "\nboundary s s " + z +
           "\nnewton off\ncomm_style tiled\nregion box block " + plane + " " +
           (is_plane_ ? "-0.5 0.5" : "-40 40") + "\ncreate_box 1 box\nmass 1 1\n";
  }
  std::string fix(const std::string& start = "start.hsw", const std::string& end = "end.hsw") const {
    return "fix blocks all halfspace " + folder_.file(start) + " save " + folder_.file(end) +
           "\nfix even all balance 500 1.0 rcb\nthermo 500\n";
  }
  std::string file(const std::string& name) const { return folder_.file(name); }

  void run(int processes, const std::string& script) const { run_on(processes, program(script), folder_); }
  /// The output of a run that fails.
  std::string error(const std::string& script) const {
    const Ended ended = ended_on(2, program(script), folder_);
    CHECK_FALSE(ended.is_success);
    return ended.output;
  }
  const Folder& folder() const { return folder_; }
  Snapshot end() const { return read_file(folder_.file("end.hsw")); }

 private:
  std::string program(const std::string& script) const {
    std::ofstream(folder_.file("script")) << script;
    return HALFSPACE_HOST " -log none -in " + folder_.file("script");
  }

  bool is_plane_;
  Folder folder_;
};

}  // namespace halfspace_test
