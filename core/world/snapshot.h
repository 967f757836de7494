#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <type_traits>

#include "geometry/vector.h"

namespace halfspace {

template <int D>
class World;

/// Bytes of a snapshot: a header, then every member that visit() lists, in this order. Numbers are in the
/// machine's format.
namespace snapshot {

constexpr std::uint64_t magic = 0x31'77'70'73'66'6c'61'68;  // "halfspw1"
constexpr std::uint32_t version = 36;

/// FNV-1a, to detect damaged files.
inline std::uint64_t checksum(std::span<const std::byte> bytes) {
  std::uint64_t hash = 0xcbf29ce484222325u;
  for (std::byte b : bytes) hash = (hash ^ std::uint64_t(b)) * 0x100000001b3u;
  return hash;
}

/// Writes to `out`; without `out` it only counts.
class Writer {
 public:
  static constexpr bool reads = false;

  explicit Writer(std::byte* out) : out_(out) {}

  template <class... Members>
  void operator()(const Members&... members) {
    (write(members), ...);
  }

  std::size_t size() const { return size_; }

 private:
  template <class T>
  void write(const Array<T>& array) {
    write(std::uint64_t(array.size()));
    raw(array.data(), array.size() * sizeof(T));
  }

  template <int Rows, int Columns>
  void write(const Eigen::Matrix<double, Rows, Columns>& matrix) {
    raw(matrix.data(), sizeof(double) * Rows * Columns);
  }

  template <class T>
  void write(const T& value) {
    if constexpr (requires { const_cast<T&>(value).visit(*this); }) {
      const_cast<T&>(value).visit(*this);
    } else {
      raw(&value, sizeof value);
    }
  }

  void raw(const void* data, std::size_t count) {
    if (out_ && count > 0) std::memcpy(out_ + size_, data, count);
    size_ += count;
  }

  std::byte* out_;
  std::size_t size_ = 0;
};

/// Reads from bytes; failed() if they end too early.
class Reader {
 public:
  static constexpr bool reads = true;

  explicit Reader(std::span<const std::byte> bytes) : bytes_(bytes) {}

  template <class... Members>
  void operator()(Members&... members) {
    (read(members), ...);
  }

  bool failed() const { return failed_; }
  bool at_end() const { return bytes_.empty(); }

 private:
  template <class T>
  void read(Array<T>& array) {
    std::uint64_t size = 0;
    read(size);
    if (size > bytes_.size() / sizeof(T)) {
      failed_ = true;
      return;
    }
    array.resize(std::size_t(size));
    raw(array.data(), array.size() * sizeof(T));
  }

  template <int Rows, int Columns>
  void read(Eigen::Matrix<double, Rows, Columns>& matrix) {
    raw(matrix.data(), sizeof(double) * Rows * Columns);
  }

  template <class T>
  void read(T& value) {
    if constexpr (requires { value.visit(*this); }) {
      value.visit(*this);
    } else {
      raw(&value, sizeof value);
    }
  }

  void raw(void* data, std::size_t count) {
    if (failed_ || count > bytes_.size()) {
      failed_ = true;
      return;
    }
    if (count > 0) std::memcpy(data, bytes_.data(), count);
    bytes_ = bytes_.subspan(count);
  }

  std::span<const std::byte> bytes_;
  bool failed_ = false;
};

/// Writes the state of a world or of a part of it, and returns the number of bytes. Without `out` it only
/// counts.
template <class Part>
std::size_t write_state(const Part& part, std::byte* out);

template <class Part>
std::size_t state_size(const Part& part) {
  return write_state(part, nullptr);
}

/// Restores into a new world a state that write_state() wrote. Returns false for any other.
template <int D>
bool read_state(std::span<const std::byte> state, World<D>& world);

/// Gives a new world the state of another.
template <int D>
void copy_state(const World<D>& from, World<D>& to);

}  // namespace snapshot
}  // namespace halfspace
