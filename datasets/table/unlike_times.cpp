#include <table/unlike_times.hpp>

#include <algorithm>
#include <array>
#include <cstdio>
#include <table/csv_write.hpp>
#include <vector>

namespace tcert::table {
namespace {

constexpr double kFar = 1000.0;
constexpr double kLeastStamp = 1e8;

}  // namespace

std::optional<UnlikeTimes> unlike_times(std::span<const double> times) {
  if (times.empty()) {
    return std::nullopt;
  }
  std::vector<double> ordered(times.begin(), times.end());
  const auto middle = ordered.begin() + static_cast<std::ptrdiff_t>(ordered.size() / 2);
  std::nth_element(ordered.begin(), middle, ordered.end());
  UnlikeTimes unlike;
  unlike.median = *middle;
  if (!(unlike.median > 0.0)) {
    return std::nullopt;
  }
  const auto count = [&](const auto& is_far, const auto& is_farther) {
    for (std::size_t i = 0; i < times.size(); ++i) {
      if (is_far(times[i])) {
        unlike.first = unlike.count == 0 ? i : unlike.first;
        unlike.time = unlike.count == 0 || is_farther(times[i]) ? times[i] : unlike.time;
        ++unlike.count;
      }
    }
  };
  count([&](double time) { return time > kFar * unlike.median; },
        [&](double time) { return time > unlike.time; });
  if (unlike.count == 0 && unlike.median >= kLeastStamp) {
    count([&](double time) { return time < unlike.median / kFar; },
          [&](double time) { return time < unlike.time; });
  }
  return unlike.count == 0 ? std::nullopt : std::optional(unlike);
}

bool are_stamps(std::span<const double> times) noexcept {
  return times.size() > 1 &&
         std::all_of(times.begin(), times.end(), [](double time) { return time >= kLeastStamp; });
}

std::string distance_in_words(const UnlikeTimes& unlike) {
  std::array<char, 32> factor{};
  std::snprintf(factor.data(), factor.size(), "%.3g", unlike.time / unlike.median);
  std::string text(factor.data());
  text += " times the median of ";
  append_number(text, unlike.median);
  return text;
}

}  // namespace tcert::table
