#!/usr/bin/env Rscript
# Compares `tcert fit roc` and `tcert fit cox` with R on the table of `tcert import barn`.
#
#   Rscript scripts/check_barn.R TCERT BARN.csv
#
# AUC of m1 per planner, clustered by world, and one Cox model of all planners. Exit status 1 if a
# cell disagrees.

suppressPackageStartupMessages({
  library(survival)
  library(pROC)
})
this_file <- sub("^--file=", "", grep("^--file=", commandArgs(FALSE), value = TRUE))
source(file.path(dirname(this_file), "check_cells.R"))

# Obuchowski's (1997) variance, from the placements of each row.
clustered_se <- function(x, y, cluster) {
  good <- y == 1
  placed <- ifelse(good, sapply(x, function(v) mean((v > x[!good]) + (v == x[!good]) / 2)),
                   sapply(x, function(v) mean((x[good] > v) + (x[good] == v) / 2)))
  auc <- mean(placed[good])
  a <- rowsum(ifelse(good, placed - auc, 0), cluster) / sum(good)
  b <- rowsum(ifelse(good, 0, placed - auc), cluster) / sum(!good)
  correction <- function(cluster) { k <- length(unique(cluster)); k / (k - 1) }
  sqrt(correction(cluster[good]) * sum(a^2) + correction(cluster[!good]) * sum(b^2) +
         2 * correction(cluster) * sum(a * b))
}

check_planner <- function(tool, rows) {
  planner <- rows$planner[1]
  if (length(unique(rows$success)) < 2) return(cat(sprintf("  %-16s one class\n", planner)))
  data <- tempfile(fileext = ".csv")
  on.exit(unlink(data))
  write.csv(rows, data, row.names = FALSE)
  found <- run_json(tool, c("fit", "roc", "--data", data, "--formula", "success ~ m1",
                            "--cluster", "world"))$auc
  auc <- as.numeric(roc(rows$success, rows$m1, levels = 0:1, direction = "<", quiet = TRUE)$auc)
  failures <- sum(rows$success == 0)
  # One unit in a class has no variance.
  se <- if (min(failures, nrow(rows) - failures) < 2) NA else
    clustered_se(rows$m1, rows$success, rows$world)
  check("AUC of m1", planner, found$estimate, auc)
  check("AUC of m1, clustered SE", planner, found$std.error, se)
  cat(sprintf("  %-16s n %4d, failures %4d, AUC %.6f, SE %.6f\n", planner, nrow(rows), failures,
              auc, se))
}

check_cox <- function(tool, file, table) {
  found <- run_json(tool, c("fit", "cox", "--data", file, "--formula",
                            "Surv(time_s, success) ~ m1 + strata(planner) + cluster(world)"))
  fit <- coxph(Surv(time_s, success) ~ m1 + strata(planner) + cluster(world), table,
               control = coxph.control(eps = 1e-14, toler.chol = 1e-15, iter.max = 100))
  check("Cox coefficient", "m1", found$coefficients$estimate, coef(fit), FITTED)
  check("Cox robust SE", "m1", found$coefficients$robust.se, sqrt(fit$var), FITTED)
  cat(sprintf("Cox, m1: %.12g, robust SE %.12g\n", coef(fit), sqrt(fit$var)))
}

main <- function(arguments) {
  table <- read.csv(arguments[2])
  for (rows in split(table, table$planner)) check_planner(arguments[1], rows)
  check_cox(arguments[1], arguments[2], table)
  report()
}

main(commandArgs(trailingOnly = TRUE))
