// Writes files that appear under their names only when they are complete.
#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <string_view>
#include <vector>

namespace spindrift::output {

/// A file that is written under a hidden temporary name in the folder of its final name; commit()
/// renames it, replacing an older file of that name. Without commit() the temporary file is
/// removed, so that a reader sees the old file, or the new one, or none, and never a half.
///
/// This holds for a crash of the program and for a full disk. Nothing is forced out to the medium
/// (fsync), so it does not hold for a power cut.
///
/// Every failure to write is a std::runtime_error that names the final file and says why; to use
/// the object after commit() is a std::logic_error.
class AtomicFile {
 public:
  /// Creates the temporary file. The folder must exist.
  explicit AtomicFile(std::filesystem::path file);
  ~AtomicFile();
  AtomicFile(const AtomicFile&) = delete;
  AtomicFile& operator=(const AtomicFile&) = delete;

  /// Appends bytes; small pieces are gathered into large writes.
  void write(std::span<const std::byte> bytes);
  void write(std::string_view text) { write(std::as_bytes(std::span(text))); }

  /// Closes the file and gives it its final name. It may be called only once.
  void commit();

  const std::filesystem::path& final_name() const { return file_; }
  /// Name for a library that writes the file itself instead of through write().
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

/// Makes a folder and its parent folders where they do not exist yet.
/// @throws std::runtime_error naming the folder, and the file that is in its way where there is one
void make_folders(const std::filesystem::path& folder);

/// Returns a hidden name in the folder of `file`, with its extension, under which to write it until
/// it is complete.
std::filesystem::path part_name(const std::filesystem::path& file);

/// Throws unless a file may be given this name, replacing an older one.
/// @throws std::runtime_error for a name that belongs to a folder, or to anything else that is not
/// a regular file
void require_replaceable(const std::filesystem::path& file);

/// Renames the complete file `part` to `file`, replacing an older one.
/// @throws std::runtime_error where that fails; `part` is then removed
void give_name(const std::filesystem::path& part, const std::filesystem::path& file);

/// Removes the files with temporary names from a folder; they are left there by processes that were
/// ended by force. No other process may be writing in the folder.
/// @throws std::filesystem::filesystem_error where one cannot be removed
void remove_part_files(const std::filesystem::path& folder);

/// Writes a whole text file through AtomicFile.
void write_file(const std::filesystem::path& file, std::string_view text);

}  // namespace spindrift::output
