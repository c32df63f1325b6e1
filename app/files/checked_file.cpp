#include "app/files/checked_file.hpp"

#include <fmt/format.h>
#include <xxhash.h>

#include <new>
#include <stdexcept>

#include "render/output/input_file.hpp"

namespace spindrift::app {
namespace {

namespace fs = std::filesystem;

/// Removes whatever has the file's name and is not a regular file, and returns the name: a folder
/// or a pipe in the place of a file that the program keeps for itself is of no use.
const fs::path& cleared(const fs::path& file) {
  std::error_code ignored;
  const fs::file_status status = fs::symlink_status(file, ignored);
  if (fs::exists(status) && !fs::is_regular_file(status))
    fs::remove_all(file);
  return file;
}

}  // namespace

struct Checksum::State {
  XXH3_state_t* xxh = XXH3_createState();
  State() {
    if (xxh == nullptr)
      throw std::bad_alloc();
    XXH3_128bits_reset(xxh);
  }
  ~State() { XXH3_freeState(xxh); }
  State(const State&) = delete;
  State& operator=(const State&) = delete;
};

Checksum::Checksum() : state_(std::make_unique<State>()) {}

Checksum::~Checksum() = default;

void Checksum::add(std::span<const std::byte> bytes) {
  XXH3_128bits_update(state_->xxh, bytes.data(), bytes.size());
}

Checksum::Value Checksum::value() const {
  const XXH128_hash_t hash = XXH3_128bits_digest(state_->xxh);
  return {hash.low64, hash.high64};
}

CheckedWriter::CheckedWriter(const fs::path& file, std::string_view magic) : file_(cleared(file)) {
  write(std::as_bytes(std::span(magic)));
}

void CheckedWriter::write(std::span<const std::byte> bytes) {
  file_.write(bytes);
  checksum_.add(bytes);
}

void CheckedWriter::commit() {
  const Checksum::Value value = checksum_.value();
  file_.write(std::as_bytes(std::span(&value, 1)));
  file_.commit();
}

CheckedReader::CheckedReader(fs::path file, std::string_view magic) : file_(std::move(file)) {
  output::require_regular_file(file_);
  in_.open(file_, std::ios::binary);
  const std::uintmax_t size = fs::file_size(file_);
  if (size < magic.size() + sizeof(Checksum::Value))
    fail();
  remaining_ = size - sizeof(Checksum::Value);
  std::string found(magic.size(), '\0');
  read(std::as_writable_bytes(std::span(found)));
  if (found != magic)
    throw std::runtime_error(fmt::format("{} is not a file of this version", file_.string()));
}

void CheckedReader::read(std::span<std::byte> bytes) {
  if (bytes.size() > remaining_)
    fail();
  if (!in_.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(bytes.size())))
    throw std::runtime_error(fmt::format("{} could not be read to its end", file_.string()));
  remaining_ -= bytes.size();
  checksum_.add(bytes);
}

void CheckedReader::finish() {
  Checksum::Value kept;
  if (remaining_ != 0 || !in_.read(reinterpret_cast<char*>(&kept), sizeof kept) ||
      kept != checksum_.value())
    fail();
}

void CheckedReader::fail() const {
  throw std::runtime_error(fmt::format("{} is cut short or damaged; remove it", file_.string()));
}

}  // namespace spindrift::app
