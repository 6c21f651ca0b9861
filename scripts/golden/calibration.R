# Makes tests/golden/calibration.json: what R's formulas give for the calibration of given and of out-of-fold probabilities.
# rms::val.prob is not needed: slope, intercepts and Brier score are written out by its definition (Harrell 2015, ch. 10).
# Rscript scripts/golden/calibration.R > tests/golden/calibration.json   (jsonlite)
suppressPackageStartupMessages(library(jsonlite))
exact <- glm.control(epsilon = 1e-15, maxit = 100)

# Once more from the optimum: the covariance that glm reports belongs to the step before the last.
fit <- function(formula, data) {
  call <- list(formula, family = binomial(), data = data, control = exact)
  first <- do.call(glm, call)
  do.call(glm, c(call, list(start = coef(first))))
}

# Sandwich over clusters without a small-sample factor.
robust_se <- function(f, cluster) {
  X <- model.matrix(f); bread <- summary(f)$cov.unscaled
  meat <- crossprod(rowsum(X * (f$y - fitted(f)), cluster))
  sqrt(diag(bread %*% meat %*% bread))
}

calibrate <- function(y, p, cluster = NULL, g = 10) {
  l <- qlogis(p); d <- data.frame(y, l)
  both <- fit(y ~ l, d); large <- fit(y ~ 1 + offset(l), d)
  se <- function(f) if (is.null(cluster)) sqrt(diag(vcov(f))) else robust_se(f, cluster)
  cuts <- unique(quantile(p, seq(0, 1, length.out = g + 1), type = 7, names = FALSE))
  bin <- droplevels(cut(p, cuts, include.lowest = TRUE))
  n <- as.vector(table(bin)); events <- as.vector(tapply(y, bin, sum))
  pk <- as.vector(tapply(p, bin, mean)); yk <- events / n
  wilson <- t(sapply(seq_along(n), function(k) suppressWarnings(prop.test(events[k], n[k], correct = FALSE))$conf.int))
  each_p <- pk[bin]; each_y <- yk[bin]; E <- as.vector(tapply(p, bin, sum))
  hl <- sum((events - E)^2 / E + ((n - events) - (n - E))^2 / (n - E))
  list(y = y, p = p, cluster = cluster, slope = coef(both)[[2]], intercept = coef(both)[[1]], in_the_large = coef(large)[[1]],
       slope_se = se(both)[[2]], intercept_se = se(both)[[1]], in_the_large_se = se(large)[[1]],
       brier = mean((p - y)^2), reliability = mean((each_p - each_y)^2), resolution = mean((each_y - mean(y))^2),
       uncertainty = mean(y) * (1 - mean(y)), within_variance = mean((p - each_p)^2),
       within_covariance = 2 * mean((p - each_p) * (y - each_y)), expected_to_observed = sum(p) / sum(y),
       hosmer_lemeshow = hl, hl_df = length(n) - 2, hl_p = pchisq(hl, length(n) - 2, lower.tail = FALSE),
       bins = data.frame(n = n, events = events, predicted = pk, observed = yk, low = wilson[, 1], high = wilson[, 2]))
}

set.seed(21)
n <- 240
day <- rep(sprintf("d%02d", 1:12), each = 20)
x <- round(rnorm(n), 3); z <- round(rgamma(n, 2), 2)
effect <- rnorm(12, 0, 0.5)[as.integer(factor(day))]
y <- rbinom(n, 1, plogis(0.7 + 1.1 * x - 0.4 * z + effect))
given <- round(plogis(0.2 + 1.6 * x - 0.5 * z), 6)
tied <- pmin(0.9, pmax(0.1, round(given, 1)))

# Out of fold by whole days, the folds given with the case.
fold <- (as.integer(factor(day)) - 1) %% 5
d <- data.frame(y, x, z)
p <- numeric(n)
for (k in 0:4) p[fold == k] <- predict(fit(y ~ x + z, d[fold != k, ]), d[fold == k, ], type = "response")

out <- list(versions = list(R = R.version.string),
            cases = list(given = calibrate(y, given), by_day = calibrate(y, given, day), ties = calibrate(y, tied),
                         out_of_fold = c(calibrate(y, p, day), list(x = x, z = z, fold = fold))))
cat(toJSON(out, digits = I(15), auto_unbox = TRUE, null = "null"), "\n")
