# The mixed-model cells of H1 and H2 against lme4. Sourced by check_hypotheses.R, not run.
#
# glmer is run at a tolerance far below its default, whose answer is not at the optimum. Its errors
# come from finite differences, so they are held to less than its estimates.

MIXED <- 1e-4     # Estimates.
MIXED_SE <- 1e-3  # What depends on a finite-difference Hessian; the SD of clusters.

tight_glmer <- function() {
  lme4::glmerControl(optimizer = "bobyqa", tolPwrss = 1e-13, calc.derivs = TRUE,
                     optCtrl = list(maxfun = 1e5, rhobeg = 2e-2, rhoend = 1e-10))
}

fit_mixed <- function(x, d) {
  data <- list(y = d$y, x = x, cluster = d$cluster)
  suppressWarnings(suppressMessages(lme4::glmer(y ~ x + (1 | cluster), data = data, nAGQ = 15,
                                                family = binomial, control = tight_glmer())))
}

# SD, ICC, marginal and conditional R2. A variance that lme4 leaves at rounding is 0.
mixed_variances <- function(fit, x) {
  sd <- attr(lme4::VarCorr(fit)[[1]], "stddev")[[1]]
  if (sd < 1e-4) sd <- 0
  fixed <- var(drop(cbind(1, x) %*% lme4::fixef(fit)))
  residual <- pi^2 / 3
  whole <- fixed + sd^2 + residual
  c(sd = sd, icc = sd^2 / (sd^2 + residual), marginal = fixed / whole,
    conditional = (fixed + sd^2) / whole)
}

check_mixed_row <- function(d, where, found, x, single) {
  fit <- fit_mixed(x, d)
  variances <- mixed_variances(fit, x)
  check("mixed log-likelihood", where, found$loglik, as.numeric(logLik(fit)), 1e-8)
  check("mixed SD of clusters", where, found$sd_cluster, variances[["sd"]], MIXED_SE)
  check("mixed ICC", where, found$icc, variances[["icc"]], 2 * MIXED_SE)
  check("mixed R2", where, c(found$r2_marginal, found$r2_conditional),
        variances[c("marginal", "conditional")], MIXED_SE)
  beta <- lme4::fixef(fit)[[2]]
  se <- sqrt(as.matrix(vcov(fit))[2, 2])
  half <- qnorm((1 + d$level) / 2) * se
  or <- if (single) exp(beta) else NA
  check("mixed OR per SD", where, found$or_per_sd, or, MIXED)
  check("mixed OR per SD CI", where, c(found$or_per_sd_low, found$or_per_sd_high),
        if (single) exp(beta + c(-1, 1) * half) else c(NA, NA), MIXED_SE)
  # d log p is about z times that of z.
  z <- abs(beta / se)
  check("mixed p", where, found$p, if (single) two_sided(beta, se) else NA, MIXED_SE * (1 + z^2))
  as.numeric(logLik(fit))
}

# R2 of log time of those that arrive, and the jackknife of its gain by whole clusters.
fit_log_time <- function(x, time, cluster) {
  control <- lme4::lmerControl(optimizer = "bobyqa", calc.derivs = FALSE, check.conv.singular = "ignore",
                               optCtrl = list(maxfun = 1e6, rhobeg = 0.2, rhoend = 1e-12))
  suppressWarnings(suppressMessages(lme4::lmer(y ~ x + (1 | cluster), control = control,
                                               data = list(y = log(time), x = x, cluster = cluster))))
}

r2_log_time <- function(fit, x) {
  between <- as.numeric(lme4::VarCorr(fit)[[1]])
  fixed <- var(drop(cbind(1, x) %*% lme4::fixef(fit)))
  whole <- fixed + between + sigma(fit)^2
  c(fixed / whole, (fixed + between) / whole)
}

#' All rows of a panel's table of log time: `designs` as of the mixed models, on all trials.
check_log_time <- function(d, found) {
  if (is.null(found) || is.null(d$censored) || length(unique(d$cluster)) == d$n) return(invisible())
  arrived <- d$censored[, "status"] == 1
  k <- length(d$columns)
  designs <- c(lapply(seq_len(k), function(j) d$scaled[, j, drop = FALSE]),
               if (k > 1) list(d$scaled[, -1, drop = FALSE], d$scaled))
  stamps <- if ("start" %in% colnames(d$censored)) d$censored[, "stop"] - d$censored[, "start"] else d$censored[, "time"]
  time <- stamps[arrived]
  cluster <- as.character(d$cluster[arrived])
  r2 <- function(r, keep) {
    x <- designs[[r]][arrived, , drop = FALSE][keep, , drop = FALSE]
    r2_log_time(fit_log_time(x, time[keep], cluster[keep]), x)
  }
  all <- sapply(seq_along(designs), r2, rep(TRUE, length(time)))
  clusters <- unique(cluster)
  without <- sapply(clusters, function(one) sapply(seq_along(designs), function(r) r2(r, cluster != one)[1]))
  for (r in seq_along(designs)) {
    where <- paste(d$name, found$predictor[r])
    check("log time R2", where, c(found$r2_marginal[r], found$r2_conditional[r]), all[, r], 1e-5)
    if (r == 1) next
    better <- if (r == k + 2) r else 1
    than <- if (r == k + 2) r - 1 else r
    gain <- all[1, better] - all[1, than]
    G <- length(clusters)
    se <- sqrt((G - 1) / G * sum((without[better, ] - without[than, ] - gain)^2))
    half <- qt((1 + d$level) / 2, G - 1) * se
    check("log time gain of R2", where, found$r2_gain[r], gain, 1e-4)
    check("log time gain of R2, CI", where, c(found$r2_gain_low[r], found$r2_gain_high[r]), gain + c(-1, 1) * half, 1e-3)
  }
}

#' All rows of a panel's mixed table: predictors, rivals together, added.
check_mixed <- function(d, mixed) {
  if (length(unique(d$cluster)) == d$n) return(invisible())
  k <- length(d$columns)
  designs <- c(lapply(seq_len(k), function(j) d$scaled[, j, drop = FALSE]),
               if (k > 1) list(d$scaled[, -1, drop = FALSE], d$scaled))
  loglik <- sapply(seq_along(designs), function(r) {
    check_mixed_row(d, paste(d$name, mixed$predictor[r]), mixed[r, ], designs[[r]],
                    single = r != k + 1)
  })
  p <- rep(NA, nrow(mixed))
  if (k > 1) p[k + 2] <- pchisq(2 * (loglik[k + 2] - loglik[k + 1]), 1, lower.tail = FALSE)
  for (r in seq_len(nrow(mixed))) {
    check("mixed likelihood ratio p", paste(d$name, mixed$predictor[r]), mixed$lr_p[r], p[r], 1e-5)
  }
  in_metres <- grepl("^tc_(early|landmark)$", mixed$predictor[1])
  cm <- if (in_metres) mixed$or_per_sd[1]^(0.01 / d$sd[1]) else NA
  check("mixed OR per cm", d$name, mixed$or_per_cm[1], cm)
}

#' The statistic of the last columns' likelihood ratio.
mixed_ratio <- function(x, d, last) {
  2 * as.numeric(logLik(fit_mixed(x, d)) - logLik(fit_mixed(x[, -last, drop = FALSE], d)))
}
