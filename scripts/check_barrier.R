#!/usr/bin/env Rscript
# Random quadratic programs of the barrier filter, solved by R's quadprog and by the filter.
#
#   Rscript scripts/check_barrier.R FILTER_COMMANDS [N]
#
# FILTER_COMMANDS is build/release/tests/core/filter_commands (ninja -C build/release filter_commands).
# Needs the package quadprog. Exit status 1 if one differs by more than 1e-9 in units of the box, if a
# command that is returned breaks a row, or if only one of both finds a solution.

suppressPackageStartupMessages(library(quadprog))
arguments <- commandArgs(TRUE)
n <- if (length(arguments) > 1) as.integer(arguments[2]) else 100000L
set.seed(20)
unit <- c(0.22, 0.6)
problems <- lapply(seq_len(n), function(i) {
  k <- sample(0:8, 1)
  list(wanted = c(0.11 + 0.2 * runif(1, -1, 1), 0.8 * runif(1, -1, 1)),
       rows = cbind(runif(k, -1, 1), 0.3 * runif(k, -1, 1), 0.1 * runif(k, -1, 1) - 0.05))
})
lines <- vapply(problems, function(p) paste(format(c(p$wanted, t(p$rows)), digits = 17), collapse = " "), "")
ours <- read.table(text = system2(arguments[1], stdout = TRUE, input = lines))
# In units of the box, as the filter has it: least |u - u_ref|^2.
box <- rbind(c(1, 0, 0), c(-1, 0, -1), c(0, 1, -1), c(0, -1, -1))
theirs <- t(vapply(problems, function(p) {
  rows <- rbind(cbind(p$rows[, 1] * unit[1], p$rows[, 2] * unit[2], p$rows[, 3]), box)
  solved <- try(solve.QP(diag(2), p$wanted / unit, t(rows[, 1:2, drop = FALSE]), rows[, 3]), silent = TRUE)
  if (inherits(solved, "try-error")) c(0, NA, NA) else c(1, solved$solution * unit)
}, numeric(3)))
both <- ours[, 1] == 1 & theirs[, 1] == 1
differ <- pmax(abs(ours[both, 2] - theirs[both, 2]) / unit[1], abs(ours[both, 3] - theirs[both, 3]) / unit[2])
slack <- vapply(which(ours[, 1] == 1), function(i) {
  rows <- problems[[i]]$rows
  min(1, rows[, 1] * ours[i, 2] + rows[, 2] * ours[i, 3] - rows[, 3])
}, 0)
cat(n, "programs,", sum(both), "with a solution, largest difference", max(differ), "in units of the box;\n",
    "least slack of a returned command", min(slack), ";", sum(ours[, 1] != theirs[, 1]), "of one side alone\n")
quit(status = as.integer(max(differ) > 1e-9 || min(slack) < -1e-9 || any(ours[, 1] != theirs[, 1])))
