// A file that appears under its name only when it is complete.
#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <string_view>
#include <vector>

namespace spindrift::output {

/// Writes under a hidden temporary name in the same folder; commit() renames it to its final name,
/// replacing an older file of that name. Without commit() the temporary file is removed, so that a
/// reader sees the old file, or the new one, or none, and never a half.
///
/// This holds for a crash of the program and for a full disk. Nothing is forced out to the medium
/// (fsync), so it does not hold for a power cut.
///
/// Every error is a std::runtime_error that names the final file and says why.
class AtomicFile {
 public:
  /// Creates the temporary file. The folder must exist.
  explicit AtomicFile(std::filesystem::path file);
  ~AtomicFile();
  AtomicFile(const AtomicFile&) = delete;
  AtomicFile& operator=(const AtomicFile&) = delete;

  /// Appends; small pieces are gathered into large writes.
  void write(std::span<const std::byte> bytes);
  void write(std::string_view text) { write(std::as_bytes(std::span(text))); }

  /// Closes the file and gives it its final name. Once only.
  void commit();

  const std::filesystem::path& final_name() const { return file_; }
  /// For a library that wants to write the file itself, by name, instead of through write().
  const std::filesystem::path& temporary_name() const { return temporary_; }

 private:
  void flush();
  void put(std::span<const std::byte> bytes);
  void close_and_remove() noexcept;

  std::filesystem::path file_;
  std::filesystem::path temporary_;
  std::vector<std::byte> buffer_;
  int descriptor_ = -1;
};

/// Makes a folder, and those that it is in, where they are not there yet. Errors are as above;
/// where a file is in the way they name it.
void make_folders(const std::filesystem::path& folder);

/// A hidden name beside a file's own for a file that is not complete yet, with its extension.
std::filesystem::path part_name(const std::filesystem::path& file);

/// Throws where a folder, or what is not a regular file, has a name that a file is to get.
void require_replaceable(const std::filesystem::path& file);

/// Gives a complete file its name, in place of an older one; where that fails it is removed.
void give_name(const std::filesystem::path& part, const std::filesystem::path& file);

/// Removes the files of such names in a folder, which are left where a process was ended by force.
/// To be called where no other process writes in the folder.
void remove_part_files(const std::filesystem::path& folder);

/// Writes a whole text file through AtomicFile.
void write_file(const std::filesystem::path& file, std::string_view text);

}  // namespace spindrift::output
