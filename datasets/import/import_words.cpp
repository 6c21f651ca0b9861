#include "datasets/import/import_words.hpp"

#include <fmt/format.h>

namespace tcert::recording {

std::string use_in_words(const LogMap& map, const std::vector<ImportedTrial>& trials) {
  std::string text;
  for (std::size_t i = 0; i < number_of_streams(map); ++i) {
    StreamUse all;
    RangeUse ranges;
    for (const ImportedTrial& trial : trials) {
      if (!trial.rejected) {
        const StreamUse& one = trial.streams[i].use;
        all.rows += one.rows;
        all.used += one.used;
        all.empty += one.empty;
        all.moved += one.moved;
        all.same_time += one.same_time;
        ranges.readings += trial.streams[i].ranges.readings;
        ranges.no_return += trial.streams[i].ranges.no_return;
        ranges.not_ranges += trial.streams[i].ranges.not_ranges;
      }
    }
    text += fmt::format("; {}: {} of {} rows used, {} moved, {} of the time of another, {} empty",
                        key_of(map, i),
                        all.used,
                        all.rows,
                        all.moved,
                        all.same_time,
                        all.empty);
    if (ranges.readings > 0) {
      text += fmt::format(", {} of {} readings nothing in reach, {} no range",
                          ranges.no_return,
                          ranges.readings,
                          ranges.not_ranges);
    }
  }
  return text;
}

std::string places_in_words(const std::vector<std::filesystem::path>& sources) {
  std::string text;
  for (const std::filesystem::path& source : sources) {
    text += (text.empty() ? "" : ", ") + source.filename().string();
    if (text.size() > 200) {
      return text + ", ... (" + std::to_string(sources.size()) + " in all)";
    }
  }
  return text;
}

}  // namespace tcert::recording
