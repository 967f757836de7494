#pragma once

#include <cstdint>
#include <cstring>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace halfspace::cli {

/// A binary archive. The same calls of add() write values and read them back, so that the fields of a state
/// are listed once.
class Archive {
 public:
  Archive() = default;                                                             ///< to write
  explicit Archive(std::string bytes) : bytes_(std::move(bytes)), reads_(true) {}  ///< to read

  template <class Plain>
  void add(Plain& value) {
    static_assert(std::is_trivially_copyable_v<Plain>);
    move(&value, sizeof value);
  }
  void add(bool& flag) {
    std::uint8_t byte = flag;
    add(byte);
    require(byte <= 1, "a flag is neither 0 nor 1");
    flag = byte == 1;
  }
  void add(std::string& text) { add_array(text); }
  template <class Plain>
  void add(std::vector<Plain>& values) {
    static_assert(std::is_trivially_copyable_v<Plain>);
    add_array(values);
  }
  /// Calls add_one for each value of a list.
  template <class Value, class AddOne>
  void add_each(std::vector<Value>& values, AddOne add_one) {
    std::size_t count = values.size();
    add(count);
    if (!reads_) {
      for (Value& value : values) add_one(value);
      return;
    }
    values.clear();  // grows with what is read, whatever the count
    for (; count > 0; --count) add_one(values.emplace_back());
  }

  bool reads() const { return reads_; }
  /// Validates values that were read. @throws std::runtime_error if the condition does not hold
  void require(bool holds, const char* fault) const {
    if (reads_ && !holds) throw std::runtime_error(fault);
  }
  /// Ends the reading. @throws std::runtime_error if bytes are left
  void end() const { require(left() == 0, "it is longer than expected"); }
  const std::string& bytes() const { return bytes_; }

 private:
  static constexpr const char* ends_early = "it ends too early";

  template <class Array>
  void add_array(Array& values) {
    constexpr std::size_t size = sizeof(typename Array::value_type);
    std::size_t count = values.size();
    add(count);
    if (reads_) {
      require(count <= left() / size, ends_early);
      values.resize(count);
    }
    move(values.data(), count * size);
  }

  void move(void* value, std::size_t count) {
    if (reads_) {
      require(count <= left(), ends_early);
      if (count > 0) std::memcpy(value, bytes_.data() + at_, count);
      at_ += count;
    } else {
      bytes_.append(static_cast<const char*>(value), count);
    }
  }
  std::size_t left() const { return bytes_.size() - at_; }

  std::string bytes_;
  std::size_t at_ = 0;  ///< where to read
  bool reads_ = false;
};

}  // namespace halfspace::cli
