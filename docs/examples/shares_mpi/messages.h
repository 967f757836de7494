// Messages between the processes of a run.
#pragma once

#include <mpi.h>

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

[[noreturn]] inline void fail(const std::string &reason) {
  std::fprintf(stderr, "shares_mpi: %s\n", reason.c_str());
  MPI_Abort(MPI_COMM_WORLD, 1);
  std::exit(1);
}

inline int rank() {
  int rank = 0;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  return rank;
}

inline std::size_t rank_count() {
  int count = 0;
  MPI_Comm_size(MPI_COMM_WORLD, &count);
  return std::size_t(count);
}

/// The bytes of rank 0 on all ranks.
inline void broadcast(std::vector<char> &bytes) {
  std::int64_t size = std::int64_t(bytes.size());
  MPI_Bcast(&size, 1, MPI_INT64_T, 0, MPI_COMM_WORLD);
  bytes.resize(std::size_t(size));
  MPI_Bcast(bytes.data(), int(size), MPI_BYTE, 0, MPI_COMM_WORLD);
}

/// Sends a list to each rank, and receives one from each, of a length that both know.
template <class T>
void exchange(const std::vector<std::vector<T>> &sent, std::vector<std::vector<T>> &received) {
  std::vector<MPI_Request> requests;
  const auto size = [](const std::vector<T> &list) { return int(list.size() * sizeof(T)); };
  for (std::size_t r = 0; r < sent.size(); ++r) {
    MPI_Request request;
    if (!received[r].empty()) {
      MPI_Irecv(received[r].data(), size(received[r]), MPI_BYTE, int(r), 0, MPI_COMM_WORLD, &request);
      requests.push_back(request);
    }
    if (!sent[r].empty()) {
      MPI_Isend(sent[r].data(), size(sent[r]), MPI_BYTE, int(r), 0, MPI_COMM_WORLD, &request);
      requests.push_back(request);
    }
  }
  MPI_Waitall(int(requests.size()), requests.data(), MPI_STATUSES_IGNORE);
}

/// The same for lists whose length only the sender knows.
template <class T>
std::vector<std::vector<T>> exchanged(const std::vector<std::vector<T>> &sent) {
  std::vector<std::int64_t> sizes, to_come(sent.size());
  for (const std::vector<T> &list : sent) sizes.push_back(std::int64_t(list.size()));
  MPI_Alltoall(sizes.data(), 1, MPI_INT64_T, to_come.data(), 1, MPI_INT64_T, MPI_COMM_WORLD);
  std::vector<std::vector<T>> received;
  for (const std::int64_t size : to_come) received.emplace_back(std::size_t(size));
  exchange(sent, received);
  return received;
}
