#!/usr/bin/env Rscript
# Recomputes in R every deterministic cell of the H1, H2 or H3 tables and lists those that differ.
#
#   Rscript scripts/check_hypotheses.R TCERT FEATURES.csv [h1 | h2] [options of `tcert hypotheses`...]
#   Rscript scripts/check_hypotheses.R h3 TCERT REPLAY.csv [options of `tcert hypotheses h3`...]
#
# Needs the packages survival, pROC, lme4 and jsonlite. Of the tool's answer only the numbers to be checked,
# the options it says it used, the folds and the times of the incidence table are read; all else
# comes from the CSV table. Bootstrap intervals are random: one of them is compared loosely and not
# counted. Exit status 1 if a cell disagrees.

suppressPackageStartupMessages({
  library(survival)
  library(pROC)
})
this_file <- sub("^--file=", "", grep("^--file=", commandArgs(FALSE), value = TRUE))
source(file.path(dirname(this_file), "check_cells.R"))
source(file.path(dirname(this_file), "check_mixed.R"))
source(file.path(dirname(this_file), "check_h2.R"))

# ---- What is asked for -----------------------------------------------------------------------

option_of <- function(arguments, name) {
  joined <- grep(paste0("^", name, "="), arguments, value = TRUE)
  if (length(joined) > 0) return(sub("^[^=]*=", "", joined[1]))
  at <- match(name, arguments)
  if (is.na(at)) NULL else arguments[at + 1]
}

# 'column:smaller' means that smaller values speak for success.
directed <- function(words) {
  column <- sub(":(smaller|larger)$", "", words)
  data.frame(column = column, landmark = column, smaller = grepl(":smaller$", words))
}

paper_predictors <- function() {
  data.frame(column = c("tc_early", "contacts_per_m", "dwell", "bend_variance"),
             landmark = c("tc_landmark", "contacts_per_m_landmark", "dwell_landmark",
                          "bend_variance_landmark"),
             smaller = c(FALSE, TRUE, TRUE, TRUE))
}

predictors_of <- function(arguments) {
  predictor <- option_of(arguments, "--predictor")
  rivals <- option_of(arguments, "--baselines")
  if (is.null(predictor) && is.null(rivals)) return(paper_predictors())
  first <- if (is.null(predictor)) paper_predictors()[1, ] else directed(predictor)
  if (is.null(rivals)) first else rbind(first, directed(strsplit(rivals, ",")[[1]]))
}

expected_panels <- function(arguments, table, predictors) {
  own <- all(predictors$landmark != predictors$column & predictors$landmark %in% names(table))
  if (own || !is.null(option_of(arguments, "--landmark"))) c("paper", "landmark") else "table"
}

# ---- The trials of a panel -------------------------------------------------------------------

column_or_na <- function(table, name) {
  if (name %in% names(table)) table[[name]] else rep(NA_real_, nrow(table))
}

# Trials that are over when the window closes, or stand still then, are not at risk after it.
counts_in <- function(panel, table, options) {
  known <- !is.na(table[[options$success]])
  if (panel != "landmark") return(known)
  log_end <- column_or_na(table, "end_s")
  time <- column_or_na(table, options$time)
  end <- ifelse(is.na(time), log_end, time)
  over <- (end <= options$landmark_s) %in% TRUE | (log_end <= options$landmark_s) %in% TRUE
  known & !over & !(column_or_na(table, "still_at_landmark") %in% 1)
}

has_column <- function(name, table) nzchar(name) && name %in% names(table)

complete_rows <- function(table, columns, options) {
  used <- c(columns, Filter(function(name) has_column(name, table),
                            c(options$time, options$cluster, options$strata, options$group)))
  complete.cases(table[used])
}

# The cross of the columns of "algorithm x lighting"; a row where one is missing has none.
strata_within <- function(rows, names) {
  if (!nzchar(names)) return(NULL)
  columns <- rows[strsplit(names, " x ", fixed = TRUE)[[1]]]
  ifelse(complete.cases(columns), do.call(paste, c(columns, sep = "|")), NA)
}

#' A panel: columns of its complete trials. `x` has every predictor turned so that larger is better.
panel_of <- function(panel, table, predictors, options, limit) {
  columns <- if (panel == "landmark") predictors$landmark else predictors$column
  trials <- table[counts_in(panel, table, options), , drop = FALSE]
  rows <- trials[complete_rows(trials, columns, options), , drop = FALSE]
  raw <- as.matrix(rows[columns])
  d <- list(name = panel, columns = columns, smaller = predictors$smaller,
            missing = colSums(is.na(trials[columns])), y = rows[[options$success]],
            raw = raw, x = sweep(raw, 2, ifelse(predictors$smaller, -1, 1), "*"),
            cluster = if (nzchar(options$cluster)) as.character(rows[[options$cluster]])
                      else as.character(seq_len(nrow(rows))),
            strata = if (has_column(options$strata, table)) rows[[options$strata]],
            group = if (!is.null(options$group)) rows[[options$group]],
            within = strata_within(rows, options$within),
            n = nrow(rows), level = options$level)
  d$sd <- apply(d$x, 2, sd)
  d$scaled <- sweep(d$x, 2, d$sd, "/")
  if (has_column(options$time, table)) add_times(d, rows[[options$time]], options, limit) else d
}

add_times <- function(d, time, options, limit) {
  start <- if (d$name == "landmark") options$landmark_s
  d$censored <- aeqSurv(surv(start, time, d$y))
  stop <- d$censored[, if (is.null(start)) "time" else "stop"]
  d$limit <- max(limit, stop)
  d$at_limit <- surv(start, ifelse(d$y == 0, d$limit, stop), d$y)
  d$cause <- surv(start, stop, factor(ifelse(d$y == 1, "egress", "failure"),
                                      c("censored", "egress", "failure")))
  d
}

# The landmark panel is at risk from its start on.
surv <- function(start, stop, event) {
  if (is.null(start)) Surv(stop, event) else Surv(rep(start, length(stop)), stop, event)
}

# ---- AUC -------------------------------------------------------------------------------------

auc_by_ranks <- function(x, y) {
  m <- sum(y == 1)
  (sum(rank(x)[y == 1]) - m * (m + 1) / 2) / (m * sum(y == 0))
}

# Structural components (DeLong et al. 1988), summed within clusters and centred (Obuchowski 1997).
auc_parts <- function(x, y, cluster) {
  good <- y == 1
  m <- sum(good)
  n <- sum(!good)
  auc <- auc_by_ranks(x, y)
  parts <- numeric(length(x))
  parts[good] <- (rank(x)[good] - rank(x[good])) / n - auc
  parts[!good] <- 1 - (rank(x)[!good] - rank(x[!good])) / m - auc
  list(success = rowsum(ifelse(good, parts, 0) / m, cluster)[, 1],
       failure = rowsum(ifelse(good, 0, parts) / n, cluster)[, 1])
}

# Obuchowski's variance of an AUC, or of a difference if the parts are differences.
obuchowski <- function(parts, y, cluster) {
  factor_of <- function(units) units / (units - 1)
  factor_of(length(unique(cluster[y == 1]))) * sum(parts$success^2) +
    factor_of(length(unique(cluster[y == 0]))) * sum(parts$failure^2) +
    2 * factor_of(length(unique(cluster))) * sum(parts$success * parts$failure)
}

auc_variance <- function(x, d) obuchowski(auc_parts(x, d$y, d$cluster), d$y, d$cluster)

gain_variance <- function(x, other, d) {
  first <- auc_parts(x, d$y, d$cluster)
  second <- auc_parts(other, d$y, d$cluster)
  obuchowski(Map(`-`, first, second), d$y, d$cluster)
}

two_sided <- function(estimate, se) 2 * pnorm(-abs(estimate / se))

wald <- function(estimate, se, level) {
  z <- qnorm((1 + level) / 2)
  pmin(1, pmax(0, estimate + c(-z, z) * se))
}

# Numbers with their covariance by the jackknife of whole clusters; `numbers(rows)` are of those rows.
jackknife <- function(cluster, numbers) {
  groups <- unique(cluster)
  all <- numbers(rep(TRUE, length(cluster)))
  change <- matrix(sapply(groups, function(g) numbers(cluster != g)) - all, length(all))
  n <- length(groups)
  list(values = all, covariance = (n - 1) / n * tcrossprod(change), clusters = n)
}

# Of 0, by t with clusters - 1 degrees of freedom.
cluster_jackknife_p <- function(cluster, number) {
  j <- jackknife(cluster, number)
  2 * pt(-abs(j$values) / sqrt(j$covariance[1]), j$clusters - 1)
}

# ---- C ---------------------------------------------------------------------------------------

# `x` is turned to the better side, and better means earlier.
c_of <- function(x, outcome, cluster = NULL) {
  if (is.null(cluster)) return(concordance(outcome ~ x, reverse = TRUE, influence = 1))
  concordance(outcome ~ x, reverse = TRUE, cluster = cluster)
}

# Pairs within strata alone; `outcome` may be 0 and 1, and C the AUC.
c_within <- function(x, outcome, d, cluster = NULL) {
  known <- !is.na(d$within)
  y <- if (is.matrix(outcome)) outcome[known, ] else outcome[known]
  x <- x[known]
  s <- d$within[known]
  if (is.null(cluster)) return(concordance(y ~ x + strata(s), influence = 1))
  concordance(y ~ x + strata(s), cluster = cluster[known])
}

# The paired difference has the difference of the dfbetas as its own.
c_gain_se <- function(x, other, outcome, cluster) {
  dfbeta <- c_of(x, outcome)$dfbeta - c_of(other, outcome)$dfbeta
  sqrt(sum(rowsum(dfbeta, cluster)^2))
}

# ---- Models ----------------------------------------------------------------------------------

exact_glm <- glm.control(epsilon = 1e-14, maxit = 100)
exact_cox <- coxph.control(eps = 1e-14, toler.chol = 1e-15, iter.max = 100)

fit_glm <- function(x, y, rows = rep(TRUE, length(y))) {
  glm.fit(cbind(1, x[rows, , drop = FALSE]), y[rows], family = binomial(), control = exact_glm)
}

fit_cox <- function(x, outcome, rows = rep(TRUE, nrow(x))) {
  x <- x[rows, , drop = FALSE]
  y <- outcome[rows]
  coxph(y ~ x, control = exact_cox)
}

# Rows with the same predictors must tie, so each distinct row is multiplied out once.
linear_predictor <- function(x, beta) {
  key <- do.call(paste, c(as.data.frame(format(x, digits = 17)), sep = "|"))
  first <- !duplicated(key)
  drop(x[first, , drop = FALSE] %*% beta)[match(key, key[first])]
}

log_likelihood <- function(fit, y) sum(dbinom(y, 1, fit$fitted.values, log = TRUE))

lrt_p <- function(small, large, df = 1) pchisq(2 * (large - small), df, lower.tail = FALSE)

#' Scores of a model row: `train` picks the rows of the fit.
glm_scores <- function(x, d, train = rep(TRUE, d$n)) {
  linear_predictor(x, fit_glm(x, d$y, train)$coefficients[-1])
}
cox_scores <- function(x, d, train = rep(TRUE, d$n)) {
  linear_predictor(x, coef(fit_cox(x, d$censored, train)))
}

# ---- Out of fold -----------------------------------------------------------------------------

mean_by_pairs <- function(parts) {
  parts <- Filter(function(part) part["pairs"] > 0, parts)
  pairs <- sapply(parts, `[[`, "pairs")
  sum(pairs * sapply(parts, `[[`, "value")) / sum(pairs)
}

auc_in_fold <- function(scores, y) {
  c(value = auc_by_ranks(scores, y), pairs = sum(y == 1) * sum(y == 0))
}

c_in_fold <- function(scores, outcome) {
  c_all <- c_of(scores, outcome)
  c(value = unname(c_all$concordance),
    pairs = sum(c_all$count[c("concordant", "discordant", "tied.x")]))
}

#' `scores(train)` gives the scores of all rows by a fit to the rows of `train`.
out_of_fold <- function(fold, scores, in_fold) {
  mean_by_pairs(lapply(sort(unique(fold)), function(k) {
    held_out <- fold == k
    in_fold(scores(!held_out)[held_out], held_out)
  }))
}

out_of_fold_auc <- function(fold, d, scores) {
  out_of_fold(fold, scores, function(s, rows) auc_in_fold(s, d$y[rows]))
}
out_of_fold_c <- function(fold, d, scores) {
  out_of_fold(fold, scores, function(s, rows) c_in_fold(s, d$censored[rows]))
}

# ---- Checks ----------------------------------------------------------------------------------

rows_of <- function(table, panel) table[table$panel == panel, , drop = FALSE]

#' The rows of the H1 tables: name, and AUC and C scores by a fit to any rows.
scored_rows <- function(d) {
  single <- lapply(seq_along(d$columns), function(k) {
    raw <- function(train) d$x[, k]
    list(name = d$columns[k], auc = raw, c = raw)
  })
  if (length(d$columns) < 2) return(single)
  model <- function(name, columns) {
    x <- scale(d$x)[, columns, drop = FALSE]
    list(name = name, auc = function(train) glm_scores(x, d, train),
         c = function(train) cox_scores(x, d, train))
  }
  rivals <- seq_along(d$columns)[-1]
  c(single, list(model("rivals together", rivals),
                 model(paste("rivals +", d$columns[1]), c(rivals, 1))))
}

# Larger minus smaller model in the last row, the predictor minus the row in all others.
gains <- function(values, singles) {
  gain <- values[1] - values
  gain[1] <- NA
  if (length(values) > singles) gain[length(values)] <- diff(tail(values, 2))
  gain
}

# NA where the row is no rival.
over_rivals <- function(d, rows, p_of) {
  p <- rep(NA_real_, rows)
  for (k in seq_along(d$columns)[-1]) p[k] <- p_of(k)
  p
}

check_counts <- function(d, h1) {
  check("n", d$name, h1$n, rep(d$n, nrow(h1)))
  check("events", d$name, h1$events, rep(sum(d$y == 1), nrow(h1)))
  check("clusters", d$name, h1$clusters, rep(length(unique(d$cluster)), nrow(h1)))
  models <- rep(NA, nrow(h1) - length(d$columns))
  check("missing", d$name, h1$missing, c(d$missing, models))
  check_text("better if", d$name, h1$better, c(ifelse(d$smaller, "smaller", "larger"), models))
}

check_auc <- function(d, h1, forms, fold) {
  rows <- scored_rows(d)
  all <- rep(TRUE, d$n)
  auc <- sapply(rows, function(row) auc_by_ranks(row$auc(all), d$y))
  check_text("row names", d$name, h1$predictor, sapply(rows, `[[`, "name"))
  check("AUC", d$name, h1$auc, auc)
  check("gain of AUC", d$name, h1$auc_gain, gains(auc, length(d$columns)))
  check("AUC out of fold", d$name, h1$auc_within_folds,
        sapply(rows, function(row) out_of_fold_auc(fold, d, row$auc)))
  for (k in seq_along(d$columns)) {
    se <- sqrt(auc_variance(d$x[, k], d))
    check("AUC clustered SE", d$columns[k], forms$auc_std_error[k], se)
    check("AUC clustered CI", d$columns[k], c(forms$auc_low[k], forms$auc_high[k]),
          wald(auc[k], se, d$level))
  }
  se <- over_rivals(d, nrow(h1), function(k) sqrt(gain_variance(d$x[, 1], d$x[, k], d)))
  check("gain of AUC SE", d$name, forms$auc_gain_std_error, se)
  p <- over_rivals(d, nrow(h1), function(k) cluster_jackknife_p(d$cluster, function(rows) {
    auc_by_ranks(d$x[rows, 1], d$y[rows]) - auc_by_ranks(d$x[rows, k], d$y[rows])
  }))
  check("gain of AUC p", d$name, head(h1$p, length(d$columns)), head(p, length(d$columns)))
  p
}

check_c <- function(d, time, forms, fold) {
  rows <- scored_rows(d)
  all <- rep(TRUE, d$n)
  value <- sapply(rows, function(row) c_of(row$c(all), d$censored)$concordance)
  check_text("row names", d$name, time$predictor, sapply(rows, `[[`, "name"))
  check("C", d$name, time$c, value)
  check("gain of C", d$name, time$c_gain, gains(value, length(d$columns)))
  check("C out of fold", d$name, time$c_within_folds,
        sapply(rows, function(row) out_of_fold_c(fold, d, row$c)))
  for (k in seq_along(d$columns)) {
    se <- sqrt(c_of(d$x[, k], d$censored, d$cluster)$var)
    check("C clustered SE", d$columns[k], forms$c_std_error[k], se)
    check("C clustered CI", d$columns[k], c(forms$c_low[k], forms$c_high[k]),
          wald(value[k], se, d$level))
  }
  for (k in seq_along(d$columns)) {
    j <- jackknife(d$cluster, function(rows) c_of(d$x[rows, k], d$at_limit[rows])$concordance)
    half <- qt((1 + d$level) / 2, j$clusters - 1) * sqrt(j$covariance[1])
    check("C at limit", d$columns[k], time$c_at_limit[k], j$values)
    check("C at limit CI", d$columns[k], c(time$c_at_limit_low[k], time$c_at_limit_high[k]),
          pmin(1, pmax(0, j$values + c(-half, half))))
  }
  se <- over_rivals(d, nrow(time), function(k) {
    c_gain_se(d$x[, 1], d$x[, k], d$censored, d$cluster)
  })
  check("gain of C SE", d$name, forms$c_gain_std_error, se)
  p <- over_rivals(d, nrow(time), function(k) cluster_jackknife_p(d$cluster, function(rows) {
    c_of(d$x[rows, 1], d$censored[rows])$concordance - c_of(d$x[rows, k], d$censored[rows])$concordance
  }))
  check("gain of C p", d$name, head(time$p, length(d$columns)), head(p, length(d$columns)))
  p
}

# The family: gains over each rival, in AUC and in C.
check_holm <- function(d, h1, time, p_auc, p_c) {
  adjusted <- p.adjust(c(p_auc, p_c), "holm")
  check("Holm", paste(d$name, "AUC"), h1$p_holm, head(adjusted, length(p_auc)))
  if (!is.null(p_c)) check("Holm", paste(d$name, "C"), time$p_holm, tail(adjusted, length(p_c)))
}

check_nested <- function(d, h1, time, forms) {
  k <- length(d$columns)
  if (k < 2) return(invisible())
  small <- scale(d$x)[, -1, drop = FALSE]
  large <- scale(d$x)[, c(2:k, 1), drop = FALSE]
  fits <- lapply(list(small, large), fit_glm, y = d$y)
  check("likelihood ratio p, logistic", d$name, forms$auc_lr_p[k + 1:2],
        c(NA, lrt_p(log_likelihood(fits[[1]], d$y), log_likelihood(fits[[2]], d$y))))
  check("nested p, logistic", d$name, h1$p[k + 1:2],
        c(NA, cluster_jackknife_p(d$cluster, function(rows) {
          tail(fit_glm(large, d$y, rows)$coefficients, 1)
        })), FITTED)
  if (is.null(time)) return(invisible())
  fits <- lapply(list(small, large), fit_cox, outcome = d$censored)
  check("likelihood ratio p, Cox", d$name, forms$c_lr_p[k + 1:2],
        c(NA, lrt_p(fits[[1]]$loglik[2], fits[[2]]$loglik[2])))
  check("nested p, Cox", d$name, time$p[k + 1:2],
        c(NA, cluster_jackknife_p(d$cluster, function(rows) {
          tail(coef(fit_cox(large, d$censored, rows)), 1)
        })), FITTED)
}

# AUC or C within strata: values in `found`, closed forms in `forms`. `turn` is -1 where a better value
# goes with a shorter time.
check_within_of <- function(d, name, outcome, turn, found, forms, pooled) {
  column <- function(table, suffix) table[[paste0(name, suffix)]]
  fits <- lapply(seq_along(d$columns), function(k) c_within(turn * d$x[, k], outcome, d, d$cluster))
  dfbetas <- sapply(seq_along(d$columns), function(k) {
    rowsum(c_within(turn * d$x[, k], outcome, d)$dfbeta, d$cluster[!is.na(d$within)])
  })
  value <- sapply(fits, `[[`, "concordance")
  se <- sqrt(sapply(fits, `[[`, "var"))
  quantity <- toupper(name)
  check(paste(quantity, "within"), d$name, column(found, "_within"), value)
  check(paste(quantity, "within, gain"), d$name, column(found, "_gain_within"),
        c(NA, value[1] - value[-1]))
  check(paste(quantity, "between, gain"), d$name, column(found, "_gain_between"),
        column(pooled, "_gain")[seq_along(value)] - c(NA, value[1] - value[-1]))
  counts <- as.matrix(fits[[1]]$count)
  if (ncol(counts) == 1) counts <- t(counts)
  pairs <- sum(counts[, c("concordant", "discordant", "tied.x")])
  check(paste(quantity, "within, pairs"), d$name, column(forms, "_pairs"),
        rep(pairs, length(value)))
  check(paste(quantity, "within SE"), d$name, column(forms, "_std_error"), se)
  check(paste(quantity, "within CI"), d$name, c(column(forms, "_low"), column(forms, "_high")),
        c(pmax(0, value - qnorm((1 + d$level) / 2) * se),
          pmin(1, value + qnorm((1 + d$level) / 2) * se)))
  gain_se <- c(NA, sqrt(colSums((dfbetas[, 1] - dfbetas[, -1, drop = FALSE])^2)))
  check(paste(quantity, "within, gain SE"), d$name, column(forms, "_gain_std_error"), gain_se)
  check(paste(quantity, "within, gain p"), d$name, column(forms, "_gain_p"),
        two_sided(c(NA, value[1] - value[-1]), gain_se))
}

check_within <- function(d, success, time, forms, h1, h1_time) {
  if (is.null(d$within)) return(invisible())
  check("strata within", d$name, forms$strata,
        rep(length(unique(na.omit(d$within))), nrow(forms)))
  check_within_of(d, "auc", d$y, 1, success, forms, h1)
  if (!is.null(d$censored)) check_within_of(d, "c", d$censored, -1, time, forms, h1_time)
}

# coxph stops where the log-likelihood does not change any more; its score may still be 1e-5, which
# shows in a p-value. Newton steps from there, until the score is rounding.
at_optimum <- function(formula, fit, cluster, steps = 3) {
  environment(formula)$cluster <- cluster
  stay <- coxph.control(iter.max = 0)
  for (step in seq_len(steps)) {
    score <- colSums(as.matrix(residuals(fit, type = "score")))
    start <- coef(fit) + drop(fit$naive.var %*% score)
    environment(formula)$start <- start
    fit <- suppressWarnings(coxph(formula, cluster = cluster, ties = "efron", init = start,
                                  control = stay))
  }
  fit
}

# By the jackknife of whole clusters; with more than 100 of them by the sandwich times G / (G - 1).
by_clusters <- function(d, coefficient, robust_variance) {
  beta <- coefficient(rep(TRUE, d$n))
  n <- length(unique(d$cluster))
  variance <- if (n > 100) robust_variance() * n / (n - 1)
              else jackknife(d$cluster, coefficient)$covariance[1]
  half <- qt((1 + d$level) / 2, n - 1) * sqrt(variance)
  c(exp(beta + c(0, -half, half)), 2 * pt(-abs(beta) / sqrt(variance), n - 1))
}

# Ratio, interval and p of the first column of `x`.
hazard_ratio <- function(x, outcome, d, stratified = FALSE) {
  formula <- if (stratified) outcome ~ x + strata(d$strata) else outcome ~ x
  environment(formula) <- environment()
  infinite <- FALSE
  first <- withCallingHandlers(
    coxph(formula, cluster = d$cluster, ties = "efron", control = exact_cox),
    warning = function(w) {
      infinite <<- infinite || grepl("infinite|did not converge", conditionMessage(w))
      invokeRestart("muffleWarning")
    })
  # A monotone likelihood has no ratio. At this tolerance coxph warns of some that have one; per
  # standard deviation those are far below 15.
  if (infinite && abs(coef(first)[[1]]) > 15) return(rep(NA, 4))
  by_clusters(d, function(rows) {
    y <- outcome[rows]
    x <- x[rows, , drop = FALSE]
    s <- d$strata[rows]
    part <- if (stratified) y ~ x + strata(s) else y ~ x
    start <- coxph(part, cluster = d$cluster[rows], ties = "efron", control = exact_cox)
    coef(at_optimum(part, start, d$cluster[rows]))[[1]]
  }, function() at_optimum(formula, first, d$cluster)$var[1, 1])
}

check_hazard_ratio <- function(kind, where, time, forms, expected) {
  columns <- paste0("hr_", kind, c("", "_low", "_high"))
  quantity <- paste0("HR ", kind, c("", " CI", " CI", " p"))
  found <- c(unlist(time[columns]), forms[[paste0("hr_", kind, "_p")]])
  for (i in 1:4) check(quantity[i], where, found[i], expected[i], FITTED)
}

check_hazard_ratios <- function(d, time, forms) {
  k <- length(d$columns)
  for (r in seq_len(nrow(time))) {
    x <- if (r <= k) d$scaled[, r, drop = FALSE] else d$scaled
    together <- r == k + 1  # No single ratio.
    ratio <- function(...) if (together) rep(NA, 4) else hazard_ratio(x, ...)
    where <- paste(d$name, time$predictor[r])
    check("SD", where, time$sd[r], if (together) NA else d$sd[if (r <= k) r else 1])
    check_hazard_ratio("censored", where, time[r, ], forms[r, ], ratio(d$censored, d))
    check_hazard_ratio("at_limit", where, time[r, ], forms[r, ], ratio(d$at_limit, d))
    check_hazard_ratio("stratified", where, time[r, ], forms[r, ],
                       if (is.null(d$strata)) rep(NA, 4) else ratio(d$censored, d, TRUE))
  }
}

check_case_level_auc <- function(d, case) {
  rocs <- lapply(seq_along(d$columns), function(k) {
    roc(d$y, d$x[, k], levels = c(0, 1), direction = "<", quiet = TRUE)
  })
  for (k in seq_along(rocs)) {
    ci <- ci.auc(rocs[[k]], conf.level = d$level, method = "delong")
    check("case level AUC", d$columns[k], case$auc[k], as.numeric(rocs[[k]]$auc))
    check("case level AUC SE", d$columns[k], case$auc_std_error[k],
          sqrt(var(rocs[[k]], method = "delong")))
    check("case level AUC CI", d$columns[k], c(case$auc_low[k], case$auc_high[k]), ci[c(1, 3)])
    check("case level gain of AUC p", d$columns[k], case$auc_gain_p[k], if (k == 1) NA else
          roc.test(rocs[[1]], rocs[[k]], method = "delong", paired = TRUE)$p.value)
  }
}

check_case_level_c <- function(d, case) {
  fits <- lapply(seq_along(d$columns), function(k) c_of(d$x[, k], d$censored))
  for (k in seq_along(fits)) {
    value <- fits[[k]]$concordance
    se <- sqrt(fits[[k]]$var)
    check("case level C", d$columns[k], case$c[k], value)
    check("case level C SE", d$columns[k], case$c_std_error[k], se)
    check("case level C CI", d$columns[k], c(case$c_low[k], case$c_high[k]),
          wald(value, se, d$level))
    check("case level gain of C p", d$columns[k], case$c_gain_p[k], if (k == 1) NA else
          two_sided(fits[[1]]$concordance - value,
                    c_gain_se(d$x[, 1], d$x[, k], d$censored, seq_len(d$n))))
  }
}

quartile_of <- function(x) {
  cuts <- quantile(x, c(0.25, 0.5, 0.75), type = 7, names = FALSE)
  factor(paste0("Q", 1 + rowSums(outer(x, cuts, ">"))), paste0("Q", 1:4))
}

# survfit takes no notice of cluster here, so its influences are summed within clusters by hand.
# survival 3.5-3 ignores `cluster` where there are several end points, so the clustered errors are made
# of its influence values, as its own unclustered ones are.
incidence_of <- function(d, rows) {
  outcome <- d$cause[rows]
  id <- seq_len(sum(rows))
  fit <- survfit(outcome ~ 1, id = id, influence = TRUE)
  influence <- fit$influence.pstate
  without_start <- dim(influence)[2] - length(fit$time) + seq_along(fit$time)
  influence <- influence[, without_start, , drop = FALSE]
  fit$std.err <- apply(influence, 2:3, function(v) sqrt(sum(rowsum(v, d$cluster[rows])^2)))
  fit$influence.pstate <- NULL
  fit
}

# On the scale log(-log p), where 0 and 1 have no interval.
log_log <- function(p, se, level) {
  inside <- ifelse(p > 0 & p < 1, p, NA)
  half <- qnorm((1 + level) / 2) * se / (inside * log(inside))
  c(exp(-exp(log(-log(inside)) - half)), exp(-exp(log(-log(inside)) + half)))
}

check_incidence_cells <- function(name, where, found, points, state, level) {
  at <- match(state, points$states)
  p <- as.matrix(points$pstate)[, at]
  se <- as.matrix(points$std.err)[, at]
  check(paste(name, "estimate"), where, found$estimate, p)
  check(paste(name, "SE"), where, found$std.error, se)
  check(paste(name, "CI"), where, c(found$conf.low, found$conf.high), log_log(p, se, level))
  check(paste(name, "n.risk"), where, found$n.risk, points$n.risk[, 1])
}

check_incidence <- function(d, result) {
  quartile <- quartile_of(d$raw[, 1])
  for (q in levels(quartile)[table(quartile) > 0]) {
    fit <- incidence_of(d, quartile == q)
    for (state in c("egress", "failure")) {
      pick <- function(table) {
        table[table$panel == d$name & table$strata == q & table$state == state, ]
      }
      where <- paste(d$name, q, state)
      shown <- pick(result$h1_incidence)
      curve <- pick(result$h1_incidence_curve)
      check_incidence_cells("incidence", where, shown,
                            summary(fit, times = shown$time, extend = TRUE), state, d$level)
      every <- fit
      check("incidence curve time", where, curve$time, every$time)
      check_incidence_cells("incidence curve", where, curve, every, state, d$level)
    }
  }
}

fold_of_rows <- function(d, folds) {
  check("folds: clusters", d$name, nrow(folds), length(unique(d$cluster)))
  fold <- folds$fold[match(d$cluster, folds$cluster)]
  if (anyNA(fold)) stop("a cluster of the ", d$name, " panel is in no fold")
  fold
}

# Another bootstrap with other draws: close, never equal.
inform_of_bootstrap <- function(d, h1, replicates = 1000) {
  if (cells$withheld) return(invisible())
  set.seed(1)
  rows <- split(seq_len(d$n), d$cluster)
  auc <- replicate(replicates, {
    drawn <- unlist(rows[sample(length(rows), replace = TRUE)], use.names = FALSE)
    auc_by_ranks(d$x[drawn, 1], d$y[drawn])
  })
  units <- length(rows)
  tail <- pnorm(-sqrt(units / (units - 1)) * qt((1 + d$level) / 2, units - 1))
  expanded <- quantile(auc, c(tail, 1 - tail), names = FALSE, na.rm = TRUE, type = 6)
  own <- c(h1$auc_low[1], h1$auc_high[1])
  cat(sprintf("%s, AUC of %s: tool %.4f to %.4f, R's expanded %.4f to %.4f: %s (not counted)\n",
              d$name, d$columns[1], own[1], own[2], expanded[1], expanded[2],
              if (all(abs(own - expanded) < 0.03)) "within 0.03" else "NOT within 0.03"))
}

check_panel <- function(d, result) {
  tables <- c("h1", "h1_time", "h1_within", "h1_time_within", "h1_case_level", "h1_closed_form",
              "h1_within_closed_form", "h1_folds", "h1_mixed", "h1_log_time")
  part <- lapply(result[intersect(tables, names(result))], rows_of, panel = d$name)
  cells$withheld <- too_few(d$y, d$cluster)
  fold <- fold_of_rows(d, part$h1_folds)
  timed <- !is.null(d$censored)
  check_counts(d, part$h1)
  p_auc <- check_auc(d, part$h1, part$h1_closed_form, fold)
  p_c <- if (timed) check_c(d, part$h1_time, part$h1_closed_form, fold)
  check_holm(d, part$h1, part$h1_time, p_auc, p_c)
  check_nested(d, part$h1, if (timed) part$h1_time, part$h1_closed_form)
  check_within(d, part$h1_within, part$h1_time_within, part$h1_within_closed_form, part$h1, part$h1_time)
  check_mixed(d, part$h1_mixed)
  check_log_time(d, part$h1_log_time)
  check_case_level_auc(d, part$h1_case_level)
  if (timed) {
    check_hazard_ratios(d, part$h1_time, part$h1_closed_form)
    check_case_level_c(d, part$h1_case_level)
    check_incidence(d, result)
  }
  inform_of_bootstrap(d, part$h1)
}

main <- function(arguments) {
  if (length(arguments) < 2) stop("Usage: check_hypotheses.R TCERT FEATURES.csv [h1 | h2] [options...]")
  options <- arguments[-(1:2)]
  hypothesis <- "h1"
  if (length(options) > 0 && options[1] %in% c("h1", "h2")) {
    hypothesis <- options[1]
    options <- options[-1]
  }
  result <- run_json(arguments[1],
                     c("hypotheses", hypothesis, "--features", arguments[2], options))
  table <- read.csv(arguments[2], check.names = FALSE)
  predictors <- predictors_of(options)
  if (hypothesis == "h2") predictors <- predictors[1, ]
  limit <- as.numeric(option_of(options, "--limit"))
  check("trials", "summary", result$summary$trials, nrow(table))
  check("outcome missing", "summary", result$summary$outcome_missing,
        sum(is.na(table[[result$summary$success]])))
  panels <- expected_panels(options, table, predictors)
  check_text("panels", hypothesis, paste(unique(result[[hypothesis]]$panel), collapse = " "),
             paste(panels, collapse = " "))
  for (panel in panels) {
    d <- panel_of(panel, table, predictors, result$summary, limit)
    if (hypothesis == "h1") check_panel(d, result) else check_h2_panel(d, result)
  }
  report()
}

arguments <- commandArgs(trailingOnly = TRUE)
if (arguments[1] == "h3") {
  source(file.path(dirname(this_file), "check_h3.R"))
  check_h3(arguments[2], arguments[3], arguments[-(1:3)])
} else {
  main(arguments)
}
