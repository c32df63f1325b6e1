#include "app/tables/frame_rate_text.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <numeric>
#include <system_error>

namespace spindrift::app {
namespace {

/// The rate as a fraction in lowest terms; none where a term is not positive or is larger than a
/// video file can hold.
std::optional<FrameRate> fraction(long long pictures, long long seconds) {
  constexpr int most = 1'000'000;
  if (pictures <= 0 || seconds <= 0)
    return std::nullopt;
  const long long divisor = std::gcd(pictures, seconds);
  if (pictures / divisor > most || seconds / divisor > most)
    return std::nullopt;
  return FrameRate{static_cast<int>(pictures / divisor), static_cast<int>(seconds / divisor)};
}

}  // namespace

std::string rate_text(const FrameRate& rate) {
  return rate.denominator == 1 ? fmt::format("{}", rate.numerator)
                               : fmt::format("{}/{}", rate.numerator, rate.denominator);
}

std::optional<FrameRate> rate_of(const std::string& text) {
  long long pictures = 0, seconds = 1;
  const char* const end = text.data() + text.size();
  auto read = std::from_chars(text.data(), end, pictures);
  if (read.ec == std::errc() && read.ptr != end && *read.ptr == '/')
    read = std::from_chars(read.ptr + 1, end, seconds);
  if (read.ec != std::errc() || read.ptr != end)
    return std::nullopt;
  return fraction(pictures, seconds);
}

std::optional<FrameRate> rate_of(double number) {
  const double thousandths = std::round(number * 1000);
  if (std::abs(number * 1000 - thousandths) > 1e-6)
    return std::nullopt;
  return fraction(static_cast<long long>(thousandths), 1000);
}

}  // namespace spindrift::app
