// Binary files that end with a checksum of their content, so that damage is found when they are
// read.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <memory>
#include <span>
#include <string_view>

#include "render/output/atomic_file.hpp"

namespace spindrift::app {

/// A running 128-bit XXH3 checksum (Collet's xxHash).
class Checksum {
 public:
  struct Value {
    std::uint64_t low = 0, high = 0;
    bool operator==(const Value&) const = default;
  };

  Checksum();
  ~Checksum();
  void add(std::span<const std::byte> bytes);
  /// The checksum of all bytes added so far.
  Value value() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// Writes a file that appears under its name only once it is complete, in place of whatever else
/// has that name. Every error is a std::runtime_error that names the file.
class CheckedWriter {
 public:
  /// @param magic the first bytes of the file: its format, and the format's version
  CheckedWriter(const std::filesystem::path& file, std::string_view magic);

  void write(std::span<const std::byte> bytes);
  /// Writes the checksum and gives the file its name.
  void commit();

 private:
  output::AtomicFile file_;
  Checksum checksum_;
};

/// Reads a file written by CheckedWriter. Every error is a std::runtime_error that names the file
/// and says what is wrong with it.
class CheckedReader {
 public:
  /// @param magic the bytes that the file must begin with
  CheckedReader(std::filesystem::path file, std::string_view magic);

  /// The number of bytes still to be read, without the checksum.
  std::uint64_t remaining() const { return remaining_; }
  /// Fills `bytes` with the next bytes of the file.
  /// @throws std::runtime_error when fewer bytes remain
  void read(std::span<std::byte> bytes);
  /// Compares the checksum; it must be called before anything that was read is used.
  /// @throws std::runtime_error when bytes remain or the checksum differs
  void finish();
  /// Reports the file as damaged.
  /// @throws std::runtime_error always
  [[noreturn]] void fail() const;

 private:
  std::filesystem::path file_;
  std::ifstream in_;
  std::uint64_t remaining_ = 0;
  Checksum checksum_;
};

}  // namespace spindrift::app
