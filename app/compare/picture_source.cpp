#include "app/compare/picture_source.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <iterator>
#include <utility>

#include "app/errors/errors.hpp"
#include "render/output/input_file.hpp"

namespace spindrift::app {
namespace {

namespace fs = std::filesystem;

/// Whether a file begins as a PNG does.
/// @throws std::runtime_error where it is not a regular file
bool is_png(const fs::path& file) {
  output::require_regular_file(file);
  std::array<char, 8> begin{};
  std::ifstream(file, std::ios::binary).read(begin.data(), begin.size());
  return std::string_view(begin.data(), begin.size()) == "\x89PNG\r\n\x1a\n";
}

std::vector<std::string> png_names(const fs::path& folder) {
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(folder)) {
    const std::string name = entry.path().filename().string();
    if (name.ends_with(".png") && !name.starts_with("."))
      names.push_back(name);
  }
  std::sort(names.begin(), names.end());
  return names;
}

/// Follows the error of a file that can't be read as a video.
constexpr const char* as_video = "; it is not a PNG either";

/// Calls `read` and turns its errors into InputErrors.
/// @param hint text after the error's message
template <class Read>
auto reading(const Read& read, const char* hint = "") {
  try {
    return read();
  } catch (const std::exception& error) {
    throw InputError(error.what() + std::string(hint));
  }
}

}  // namespace

PictureSource::PictureSource(fs::path path) : path_(std::move(path)) {
  std::error_code none;
  if (!fs::exists(path_, none))
    throw InputError(fmt::format("{}: there is no such file or folder", path_.string()));
  if (fs::is_directory(path_, none)) {
    folder_ = fs::is_directory(path_ / "frames", none) ? path_ / "frames" : path_;
    names_ = reading([&] { return png_names(folder_); });
    if (names_.empty())
      throw InputError(fmt::format("{}: there are no PNG files in this folder", folder_.string()));
  } else if (!reading([&] { return is_png(path_); })) {
    video_ = reading([&] { return std::make_unique<output::VideoReader>(path_); }, as_video);
  }
}

std::optional<Picture> PictureSource::next() {
  const std::size_t k = taken_++;
  if (video_) {
    std::optional<Image> image = reading([&] { return video_->next(); }, as_video);
    if (!image)
      return std::nullopt;
    return Picture{fmt::format("{:04}", k), std::move(*image)};
  }
  if (k >= std::max<std::size_t>(1, names_.size()))
    return std::nullopt;
  const fs::path file = names_.empty() ? path_ : folder_ / names_[k];
  return Picture{file.filename().string(), reading([&] { return output::read_png(file); })};
}

void require_same_names(const PictureSource& a, const PictureSource& b) {
  if (a.names().empty() || b.names().empty())
    return;
  const auto require_all = [](const PictureSource& all, const PictureSource& in) {
    std::vector<std::string> missing;
    std::set_difference(all.names().begin(), all.names().end(), in.names().begin(),
                        in.names().end(), std::back_inserter(missing));
    if (!missing.empty())
      throw InputError(fmt::format(
          "{}: {}{} missing, which {} has", in.path().string(), missing.front(),
          missing.size() == 1 ? " is" : fmt::format(" and {} more are", missing.size() - 1),
          all.path().string()));
  };
  require_all(a, b);
  require_all(b, a);
}

}  // namespace spindrift::app
