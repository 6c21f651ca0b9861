#include "reports/h3_chosen_table.hpp"

#include <fmt/format.h>

#include "reports/columns_of.hpp"
#include "reports/h1_intervals.hpp"

namespace tcert {
namespace {

std::string chosen_words(const study::H3Options& options) {
  const std::string folds = std::to_string(options.beta.folds);
  return options.beta.per_m
             ? fmt::format("Beta was chosen beforehand: {:g} per metre{}.",
                           *options.beta.per_m,
                           options.beta.asked ? ""
                                              : ", unless --beta says otherwise, or the middle one "
                                                "of a law that was not replayed at it")
             : "Beta is chosen by " + folds +
                   " folds of clusters: in each, of the other folds' trials, the one with the "
                   "largest rate of advance among those that lose no more than the margin; "
                   "resamples choose anew.";
}

}  // namespace

std::string h3_betas(const study::H3Chosen& one) {
  std::string words;
  std::size_t folds = 0;
  for (const auto& [beta, count] : one.betas) {
    folds += count;
  }
  for (const auto& [beta, count] : one.betas) {
    words += fmt::format("{}{:g}", words.empty() ? "" : ", ", beta);
    if (folds > 1) {
      words += fmt::format(" ({} of {})", count, folds);
    }
  }
  return words;
}

Table h3_chosen_table(const study::H3Table& h3) {
  using Row = study::H3Chosen;
  const study::H3Options& o = h3.options;
  Table table =
      ColumnsOf<Row>()
          .text("speed_law", "law", &Row::law)
          .text("beta_per_m", "beta [1/m]", [](auto& r) { return h3_betas(r); })
          .text("lighting", "lighting", &Row::lighting)
          .estimate("gain_m_per_min", "gain", "m/min", 2, &Row::gain)
          .integer("lost", "lost", &Row::lost)
          .fixed("lost_upper", "bound", &Row::lost_upper)
          .p("p", "p", &Row::p)
          .p("holm", "Holm p", &Row::holm)
          .yes_or_no("holds", "holds", &Row::holds)
          .number("trials_for_power", "for 80 %", &Row::trials_for_power)
          .estimate("gap_recovered", "share of gap", "", 2, &Row::recovered)
          .p("gain_p", "p of gain", &Row::gain_p)
          .p("loss_p", "p of loss", &Row::loss_p)
          .integer("trials", "trials", &Row::trials)
          .table("h3_chosen", "H3 at one beta a law, all laws and lightings at once", h3.chosen);
  table.footnotes = {
      chosen_words(o),
      "p: the larger of the one-sided p of no gain (jackknife of whole clusters, t) and that of a "
      "loss of " +
          significant(100.0 * o.loss_margin, 3) +
          " % or more. Holm: over all laws and lightings; of all lightings together over the laws. "
          "Holds: at most " +
          significant(1.0 - o.level, 3) + ".",
      "For 80 %: so many trials, as alike within clusters as these, find a true loss of " +
          significant(100.0 * o.true_loss, 3) +
          " % (--true-loss) below the margin in 80 of 100 "
          "studies, by the bound alone: without the gain's p and without Holm."};
  return table;
}

}  // namespace tcert
