// Files that say when they have been damaged: what is written is followed by its checksum.
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

/// A running checksum: 128 bits of XXH3 (Collet's xxHash).
class Checksum {
 public:
  struct Value {
    std::uint64_t low = 0, high = 0;
    bool operator==(const Value&) const = default;
  };

  Checksum();
  ~Checksum();
  void add(std::span<const std::byte> bytes);
  Value value() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// Writes a file that appears under its name only when it is complete, in place of whatever else
/// has that name. Every error is a std::runtime_error that names the file.
class CheckedWriter {
 public:
  /// @param magic the first bytes of the file: its format, and the format's version
  CheckedWriter(const std::filesystem::path& file, std::string_view magic);

  void write(std::span<const std::byte> bytes);
  void commit();

 private:
  output::AtomicFile file_;
  Checksum checksum_;
};

/// Reads such a file. Every error is a std::runtime_error that names the file and says what is
/// wrong with it.
class CheckedReader {
 public:
  CheckedReader(std::filesystem::path file, std::string_view magic);

  /// Bytes that are still to be read.
  std::uint64_t remaining() const { return remaining_; }
  /// @throws std::runtime_error where the file ends before
  void read(std::span<std::byte> bytes);
  /// To be called before anything that was read is used.
  /// @throws std::runtime_error where bytes are left, or the checksum is another
  void finish();
  /// @throws std::runtime_error that says the file is damaged
  [[noreturn]] void fail() const;

 private:
  std::filesystem::path file_;
  std::ifstream in_;
  std::uint64_t remaining_ = 0;
  Checksum checksum_;
};

}  // namespace spindrift::app
