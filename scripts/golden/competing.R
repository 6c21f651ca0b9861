# Makes tests/golden/competing.json: Gray's test, the Fine-Gray model and restricted means of a small table.
# Rscript scripts/golden/competing.R > tests/golden/competing.json   (survival, cmprsk, jsonlite)
#
# Gray's test: cmprsk::cuminc. Fine-Gray: survival::finegray with coxph, clustered; its coefficients are those of
# cmprsk::crr with Breslow's ties (`crr`; its standard errors count the weights as estimated, coxph's as known).
# Restricted means: survfit, and a jackknife of whole days written out.
suppressPackageStartupMessages({ library(survival); library(cmprsk); library(jsonlite) })

set.seed(7)
n <- 120
d <- data.frame(day = rep(1:12, each = 10), x = round(rnorm(n), 2), z = round(rnorm(n), 2),
                group = sample(c("a", "b", "c"), n, TRUE), stratum = sample(c("p", "q"), n, TRUE))
d$day_effect <- rnorm(12, 0, 0.3)[d$day]
rate <- cbind(exp(-3 + 0.6 * d$x + d$day_effect), exp(-3.6 - 0.4 * d$x + 0.5 * (d$group == "b")))
end <- rexp(n, rowSums(rate))
censored <- runif(n, 5, 40)
d$time <- ceiling(pmin(end, censored))                 # Ties, also of events with censoring.
d$cause <- ifelse(end > censored, 0, 1 + rbinom(n, 1, rate[, 2] / rowSums(rate)))
d$day_effect <- NULL

gray <- function(strata, rho) {
  fit <- cuminc(d$time, d$cause, d$group, strata, rho = rho)
  list(strata = !missing(strata), rho = rho, statistic = unname(fit$Tests[, "stat"]), p = unname(fit$Tests[, "pv"]))
}
control <- suppressWarnings(coxph.control(eps = 1e-14, iter.max = 60))
fine_gray <- function(ties, strata = FALSE) {
  d$state <- factor(d$cause, 0:2, c("censored", "one", "two"))
  d$id <- seq_len(n)
  d$own <- d$stratum                                   # finegray() keeps no column of its strata.
  w <- if (strata) finegray(Surv(time, state) ~ x + z + day + id + own + strata(stratum), d, etype = "one")
       else finegray(Surv(time, state) ~ x + z + day + id, d, etype = "one")
  formula <- if (strata) Surv(fgstart, fgstop, fgstatus) ~ x + z + strata(own)
             else Surv(fgstart, fgstop, fgstatus) ~ x + z
  by_day <- coxph(formula, w, weights = fgwt, ties = ties, cluster = day, control = control)
  by_row <- coxph(formula, w, weights = fgwt, ties = ties, cluster = id, control = control)
  list(ties = ties, strata = strata, estimate = unname(coef(by_day)), by_day = sqrt(diag(by_day$var)),
       by_row = sqrt(diag(by_row$var)))
}
crr_fit <- crr(d$time, d$cause, as.matrix(d[c("x", "z")]), failcode = 1, gtol = 1e-12)

limit <- 18
rmst <- function(rows) {
  t <- summary(survfit(Surv(time, cause > 0) ~ group, d[rows, ]), rmean = limit)$table
  t[, c("rmean", "se(rmean)")]
}
all <- rmst(rep(TRUE, n))
without <- sapply(1:12, function(g) rmst(d$day != g)[, 1])
spread <- function(value, left_out) sqrt(11 / 12 * sum((left_out - value)^2))
pairs <- combn(3, 2)
out <- list(versions = list(R = R.version.string, survival = as.character(packageVersion("survival")), cmprsk = as.character(packageVersion("cmprsk"))),
            csv = paste(capture.output(write.csv(d, row.names = FALSE, quote = FALSE)), collapse = "\n"),
            gray = list(gray(rho = 0), gray(rho = 1), gray(d$stratum, 0)),
            fine_gray = list(fine_gray("efron"), fine_gray("breslow"), fine_gray("efron", TRUE)),
            crr = unname(crr_fit$coef), crr_se = sqrt(diag(crr_fit$var)),
            rmst = list(limit = limit, mean = unname(all[, 1]), se = unname(all[, 2]),
                        by_day = sapply(1:3, function(i) spread(all[i, 1], without[i, ])),
                        difference = apply(pairs, 2, function(p) unname(all[p[1], 1] - all[p[2], 1])),
                        difference_se = apply(pairs, 2, function(p) sqrt(sum(all[p, 2]^2))),
                        difference_by_day = apply(pairs, 2, function(p)
                          spread(all[p[1], 1] - all[p[2], 1], without[p[1], ] - without[p[2], ]))))
cat(toJSON(out, digits = I(15), auto_unbox = TRUE), "\n")
