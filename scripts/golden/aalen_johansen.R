# Makes tests/golden/aalen_johansen.json: cumulative incidence of competing end points by
# survival::survfit with a factor as the event, on data simulated here.
# survival 3.5-3 ignores cluster= here, so clustered errors are made of its influence values; with
# weights it counts n.risk, n.event and n.censor in rows, so these are kept for unweighted cases only.
#   Rscript scripts/golden/aalen_johansen.R tests/golden/aalen_johansen.json
suppressPackageStartupMessages({ library(survival); library(jsonlite) })
set.seed(20)
simulate <- function(n, digits, truncated = FALSE) {
  x <- rnorm(n)
  egress <- rexp(n, 0.08 * exp(0.5 * x)); failure <- rexp(n, 0.04 * exp(-0.7 * x)); end <- runif(n, 5, 40)
  start <- if (truncated) round(runif(n, 0, 4), digits) else numeric(n)
  stop <- start + pmax(round(pmin(egress, failure, end), digits), 10^-digits)
  cause <- ifelse(egress < failure, 1, 2) * (pmin(egress, failure) < end)
  data.frame(start, stop = round(stop, digits), cause, group = letters[cut(x, c(-Inf, -0.6, 0.6, Inf), labels = FALSE)],
             day = sprintf("d%02d", sample(12, n, TRUE)), weight = round(runif(n, 0.3, 2), 2))
}
sets <- list(untied = simulate(40, 3), tied = simulate(120, 0), truncated = simulate(80, 1, TRUE))
case <- function(set, weighted = FALSE, clustered = FALSE) {
  d <- sets[[set]]; d$w <- if (weighted) d$weight else 1
  d$state <- factor(d$cause, 0:2, c("censored", "egress", "failure"))
  groups <- lapply(split(d, d$group), function(g) {
    g$id <- seq_len(nrow(g))
    y <- if (set == "truncated") with(g, Surv(start, stop, state)) else with(g, Surv(stop, state))
    f <- suppressWarnings(survfit(y ~ 1, g, weights = w, id = id, influence = TRUE))
    u <- f$influence.pstate * g$w; u <- u[, dim(u)[2] - length(f$time) + seq_along(f$time), , drop = FALSE]  # without time 0
    stopifnot(max(abs(sqrt(apply(u^2, 2:3, sum)) - f$std.err)) < 1e-12)
    if (clustered) f$std.err <- apply(u, 2:3, function(v) sqrt(sum(rowsum(v, g$day)^2)))
    r <- list(time = f$time, pstate = f$pstate, std_err = f$std.err)
    if (!weighted) r <- c(r, list(n_risk = f$n.risk[, 1], n_censor = as.matrix(f$n.censor)[, 1], n_event = unname(f$n.event)))
    r })
  list(data = set, weighted = weighted, clustered = clustered, groups = groups)
}
cases <- list(untied = case("untied"), tied = case("tied"), truncated = case("truncated"), weighted = case("tied", TRUE),
              clustered = case("tied", FALSE, TRUE), weighted_clustered_truncated = case("truncated", TRUE, TRUE))
out <- list(versions = list(R = R.version.string, survival = as.character(packageVersion("survival"))), data = sets, cases = cases)
writeLines(toJSON(out, digits = I(15), auto_unbox = TRUE, dataframe = "columns", matrix = "rowmajor"), commandArgs(TRUE)[1])
