// Directories with the snapshots of shares: share_0.hsw, share_1.hsw, ...
#pragma once

#include <filesystem>
#include <fstream>
#include <iterator>

#include "messages.h"

using Bytes = std::vector<char>;

inline std::string share_name(const std::string &directory, int number) {
  return (std::filesystem::path(directory) / ("share_" + std::to_string(number) + ".hsw")).string();
}

/// The files that this rank reads: every n-th share.
inline std::vector<std::string> files_of_rank(const std::string &start) {
  std::vector<std::string> names;
  for (int number = rank(); std::filesystem::exists(share_name(start, number)); number += int(rank_count()))
    names.push_back(share_name(start, number));
  if (rank() == 0 && names.empty()) fail("cannot read " + share_name(start, 0));
  return names;
}

inline Bytes read(const std::string &name) {
  std::ifstream file(name, std::ios::binary);
  Bytes bytes{std::istreambuf_iterator<char>(file), {}};
  if (bytes.empty()) fail("cannot read " + name);
  return bytes;
}

inline void write(const std::string &name, const Bytes &bytes) {
  if (!std::ofstream(name, std::ios::binary).write(bytes.data(), std::streamsize(bytes.size())).flush())
    fail("cannot write " + name);
}

/// A directory for shares. Those of an earlier run would be taken for some of this one.
inline void make_directory(const std::string &directory) {
  if (std::filesystem::exists(share_name(directory, 0))) fail(directory + " has shares already");
  std::filesystem::create_directories(directory);
  MPI_Barrier(MPI_COMM_WORLD);  // before any rank writes its own
}
