# How far the one-step jackknife of a logistic model is from refits, by how few trials fail.
#
#     Rscript scripts/one_step_error.R [STUDIES] [SEED]
#
# Prints, of 600 trials in 120 and 600 units with three predictors, the least, median and largest
# ratio of the last coefficient's standard error by one Newton step to that by refits.
words <- as.numeric(commandArgs(TRUE))
studies <- if (length(words) > 0) words[1] else 100
set.seed(if (length(words) > 1) words[2] else 1)

ratio <- function(trials, failures, units) {
  unit <- rep(seq_len(units), length.out = trials)
  ability <- rnorm(trials) + 0.6 * rnorm(units)[unit]
  x <- 0.5 * ability + rnorm(trials)
  X <- cbind(1, 0.3 * ability + 0.3 * x + rnorm(trials), rexp(trials) - 0.2 * ability, x)
  y <- as.integer(rank(ability + 0.7 * rnorm(trials)) > failures)
  fit_of <- function(kept, start = NULL) suppressWarnings(glm.fit(X[kept, ], y[kept], family = binomial(), start = start))
  all <- fit_of(rep(TRUE, trials))
  p <- all$fitted.values
  root <- X * sqrt(p * (1 - p))
  score <- X * (y - p)
  information <- crossprod(root)
  changes <- sapply(seq_len(units), function(g) {
    own <- unit == g
    step <- -solve(information - crossprod(root[own, , drop = FALSE]), colSums(score[own, , drop = FALSE]))
    c(step[4], fit_of(!own, all$coefficients)$coefficients[4] - all$coefficients[4])
  })
  sqrt(sum(changes[1, ]^2) / sum(changes[2, ]^2))
}

for (failures in c(12, 20, 40, 80)) for (units in c(120, 600)) {
  found <- replicate(studies, ratio(600, failures, units))
  cat(sprintf("%d of 600 fail, %d units: %.3f, %.3f, %.3f\n", failures, units, min(found), median(found), max(found)))
}
