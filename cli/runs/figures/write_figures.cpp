#include "cli/runs/figures/write_figures.hpp"

#include <fstream>
#include <iterator>
#include <set>
#include <string_view>
#include <table/diagnostic.hpp>
#include <table/path_name.hpp>

#include "cli/runs/figures/gnuplot_program.hpp"
#include "reports/figure/gnuplot.hpp"
#include "reports/figure/vega_lite.hpp"
#include "reports/table_json.hpp"

namespace tcert::cli {
namespace {

/// The PDF's one fact about the day it was made, replaced by a day that is always the same.
void fix_date(const std::filesystem::path& path) {
  std::fstream file(path, std::ios::in | std::ios::out | std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  constexpr std::string_view kKey = "/CreationDate (D:";
  constexpr std::string_view kDay = "20000101000000";
  const auto at = bytes.rfind(kKey);
  if (at == std::string::npos || at + kKey.size() + kDay.size() > bytes.size()) {
    return;
  }
  file.clear();
  file.seekp(static_cast<std::streamoff>(at + kKey.size()));
  file.write(kDay.data(), static_cast<std::streamsize>(kDay.size()));
}

}  // namespace

void write_figure(const Figure& figure, const ResultFolder& folder, bool draw) {
  folder.write(figure.name + ".vl.json", dumped(vega_lite(figure), 1));
  folder.write(figure.name + ".csv", figure_csv(figure));
  folder.write(figure.name + ".gp", gnuplot_script(figure));
  if (draw) {
    for (const char* const form : {"svg", "pdf"}) {
      run_gnuplot(folder.staging(), figure.name + ".gp", form);
    }
    fix_date(folder.staging() / (figure.name + ".pdf"));
  }
}

FigureFiles write_figures(const Results& results,
                          const std::vector<std::string>& trials,
                          const ResultFolder& folder) {
  FigureFiles files;
  files.drawn = has_gnuplot();
  StudyFigures study = study_figures(results);
  files.missing = std::move(study.missing);
  std::set<std::string> drawn;
  for (const std::string& trial : trials) {
    if (!drawn.insert(trial).second) {
      continue;
    }
    if (!table::is_file_name(trial)) {
      files.missing.push_back({"trial_" + table::shortened(trial),
                               "its id is not " + std::string(table::kFileNameRule)});
      continue;
    }
    const std::optional<TrialPicture> picture = trial_picture(results, trial);
    if (!picture) {
      files.missing.push_back({"trial_" + trial, "no series of this trial"});
      continue;
    }
    for (std::optional<Figure> figure :
         {trial_series_figure(*picture), trial_map_figure(*picture)}) {
      if (figure) {
        study.figures.push_back(std::move(*figure));
      } else {
        files.missing.push_back({"a figure of trial " + trial, "no value of it is known"});
      }
    }
  }
  for (const Figure& figure : study.figures) {
    write_figure(figure, folder, files.drawn);
  }
  files.figures = study.figures.size();
  return files;
}

}  // namespace tcert::cli
