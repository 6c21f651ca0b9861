# Makes tests/golden/equivalence.json: proportions by binom.test and prop.test, two one-sided tests and Wald's test of equality by
# pnorm, qnorm and pchisq. Rscript scripts/golden/equivalence.R > tests/golden/equivalence.json   (jsonlite)
suppressPackageStartupMessages(library(jsonlite))

proportion <- function(k, n, level) {
  one <- function(alternative) binom.test(k, n, conf.level = level, alternative = alternative)$conf.int
  list(k = k, n = n, level = level, exact = one("two.sided"), upper = one("less")[2],
       wilson = suppressWarnings(prop.test(k, n, conf.level = level, correct = FALSE))$conf.int)
}
loss <- function(k, n, margin) {
  list(k = k, n = n, margin = margin, upper = binom.test(k, n, alternative = "less")$conf.int[2],
       p = binom.test(k, n, margin, alternative = "less")$p.value)
}

tost <- function(estimate, covariance, margin, alpha = 0.05, power = 0.8) {
  k <- length(estimate); pairs <- t(combn(k, 2)); m <- nrow(pairs)
  d <- estimate[pairs[, 1]] - estimate[pairs[, 2]]
  se <- apply(pairs, 1, function(ij) { l <- replace(replace(numeric(k), ij[1], 1), ij[2], -1); sqrt(drop(l %*% covariance %*% l)) })
  p <- pmax(pnorm((d + margin) / se, lower.tail = FALSE), pnorm((d - margin) / se))
  low <- d - qnorm(1 - alpha) * se; high <- d + qnorm(1 - alpha) * se
  L <- cbind(1, -diag(k - 1)); t <- L %*% estimate
  wald <- drop(t(t) %*% solve(L %*% covariance %*% t(L)) %*% t)
  list(estimate = estimate, covariance = covariance, margin = margin,
       pairs = data.frame(first = pairs[, 1] - 1, second = pairs[, 2] - 1, difference = d, se = se, low, high, p,
                          equivalent = low > -margin & high < margin),
       equivalent = all(low > -margin & high < margin), p = max(p), smallest_margin = max(abs(low), abs(high)),
       margin_with_power = max(se) * (qnorm(1 - alpha) + qnorm(1 - (1 - power) / m / 2)),
       range = diff(range(estimate)), wald = wald, df = k - 1, wald_p = pchisq(wald, k - 1, lower.tail = FALSE))
}

set.seed(31)
covariance <- function(k, scale) { a <- matrix(rnorm(k * (k + 2)), k); scale^2 * tcrossprod(a) / (k + 2) }
out <- list(versions = list(R = R.version.string),
            proportions = c(lapply(list(c(0, 10), c(3, 40), c(10, 10), c(37, 583), c(1, 1), c(250, 500)), function(x) proportion(x[1], x[2], 0.95)),
                            list(proportion(3, 40, 0.9), proportion(5, 7, 0.99))),
            losses = list(loss(0, 100, 0.05), loss(1, 100, 0.05), loss(20, 583, 0.05), loss(9, 90, 0.05), loss(5, 5, 0.05)),
            groups = list(tost(c(0.80, 0.79, 0.78), covariance(3, 0.01), 0.05), tost(c(0.80, 0.70, 0.78), covariance(3, 0.05), 0.05),
                          tost(c(0.6, 0.65), covariance(2, 0.02), 0.1), tost(runif(5, 0.6, 0.7), covariance(5, 0.03), 0.2)))
cat(toJSON(out, digits = I(15), auto_unbox = TRUE, matrix = "rowmajor"), "\n")
