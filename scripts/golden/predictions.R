# Makes tests/golden/predictions.json: predicted risks of Cox and logistic models and their scores at times.
# Rscript scripts/golden/predictions.R > tests/golden/predictions.json   (survival, riskRegression, jsonlite)
suppressPackageStartupMessages({ library(survival); library(riskRegression); library(jsonlite) })

set.seed(4)
n <- 150
d <- data.frame(day = rep(1:15, each = 10), x = round(rnorm(n), 2), z = round(rnorm(n), 1), light = sample(c("dark", "dim"), n, TRUE))
t <- rexp(n, exp(-3 + 0.8 * d$x + 0.3 * (d$light == "dim"))); c <- runif(n, 5, 60)
d$time <- ceiling(2 * pmin(t, c)) / 2                  # Ties.
d$event <- as.integer(t <= c)
d$y <- rbinom(n, 1, plogis(0.5 + d$x - 0.4 * d$z))
new <- data.frame(x = c(-1, 0, 1.5), z = c(0.5, 0, -2), light = c("dark", "dim", "dark"))
times <- c(8, 20)

f <- coxph(Surv(time, event) ~ x + z + light, d, x = TRUE, control = suppressWarnings(coxph.control(eps = 1e-14, iter.max = 60)))
curve <- summary(survfit(f, newdata = new), times = times)
risk <- 1 - t(summary(survfit(f, newdata = d), times = times)$surv)
score <- Score(list(cox = f), formula = Surv(time, event) ~ 1, data = d, times = times, cens.model = "km",
               metrics = c("auc", "brier"), se.fit = FALSE, conf.int = FALSE)
pick <- function(metric, model) { s <- as.data.frame(score[[metric]]$score); s <- s[s$model == model, ]; as.numeric(s[[metric]]) }
bins <- lapply(seq_along(times), function(k) {
  order <- order(risk[, k]); g <- integer(n); g[order] <- rep(1:5, each = n / 5)
  s <- sapply(1:5, function(b) summary(survfit(Surv(time, event) ~ 1, d[g == b, ]), times = times[k], extend = TRUE)$surv)
  list(predicted = as.numeric(tapply(risk[, k], g, mean)), observed = 1 - s)
})
g <- glm(y ~ x + scale(z) + light, binomial, d, control = glm.control(epsilon = 1e-15, maxit = 60))
g <- update(g, start = coef(g))
p <- predict(g, new, se.fit = TRUE)
out <- list(versions = list(R = R.version.string, survival = as.character(packageVersion("survival")), riskRegression = as.character(packageVersion("riskRegression"))),
            csv = paste(capture.output(write.csv(d, row.names = FALSE, quote = FALSE)), collapse = "\n"),
            new = paste(capture.output(write.csv(new, row.names = FALSE, quote = FALSE)), collapse = "\n"),
            times = times, survival = t(curve$surv), survival_se = t(curve$std.err), lower = t(curve$lower), upper = t(curve$upper),
            risk = risk, auc = pick("AUC", "cox"), brier = pick("Brier", "cox"), brier_null = pick("Brier", "Null model"), bins = bins,
            glm = list(eta = unname(p$fit), se = unname(p$se.fit), probability = unname(plogis(p$fit)),
                       low = unname(plogis(p$fit - qnorm(0.975) * p$se.fit)), high = unname(plogis(p$fit + qnorm(0.975) * p$se.fit))))
cat(toJSON(out, digits = I(15), auto_unbox = TRUE), "\n")
