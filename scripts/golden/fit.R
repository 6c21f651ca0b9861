# Makes tests/golden/fit.json: what R says of a small table of trials, beside the calls of `tcert fit` that must say the
# same. Rscript scripts/golden/fit.R > tests/golden/fit.json   (survival, pROC, jsonlite)
suppressPackageStartupMessages({ library(survival); library(pROC); library(jsonlite) })
options(contrasts = c("contr.treatment", "contr.poly"))
invisible(Sys.setlocale("LC_COLLATE", "C"))

set.seed(11)
n <- 96
d <- data.frame(day = rep(sprintf("d%02d", 1:12), each = 8),
                light = rep(c("dim", "dark", "bright", "dim"), 24),
                x = round(rnorm(n), 1), z = round(rgamma(n, 2), 2))
d$success <- rbinom(n, 1, plogis(0.8 + 0.9 * d$x - 0.3 * (d$light == "dark")))
d$time_s <- pmax(1, round(ifelse(d$success == 1, rexp(n, exp(-3 + 0.4 * d$x)), 60)))

control <- suppressWarnings(coxph.control(eps = 1e-14, iter.max = 60))
rows <- function(m, names) lapply(seq_len(nrow(m)), function(i) as.list(setNames(as.numeric(m[i, ]), names)))
case <- function(arguments, expected) list(arguments = arguments, expected = expected)

glm_case <- function(formula) {
  f <- glm(as.formula(formula), binomial, d, control = glm.control(epsilon = 1e-15, maxit = 50))
  f <- update(f, start = coef(f))                     # its covariance belongs to the step before the last
  s <- summary(f)$coefficients
  case(c("glm", "--formula", formula),
       list(coefficients = rows(s, c("estimate", "std.error", "statistic", "p.value")),
            summary = list(logLik = as.numeric(logLik(f)), deviance = deviance(f), AIC = AIC(f), BIC = BIC(f))))
}
cox_case <- function(formula, ties, extra = NULL, cluster = NULL) {
  full <- if (is.null(cluster)) formula else paste0(formula, " + cluster(", cluster, ")")
  f <- coxph(as.formula(full), d, ties = ties, control = control)
  s <- summary(f)
  se <- if (is.null(cluster)) "std.error" else "robust.se"
  table <- cbind(coef(f), sqrt(diag(f$var)), s$coefficients[, "z"], s$coefficients[, ncol(s$coefficients)])
  z <- cox.zph(f)$table
  naive <- if (is.null(cluster)) "" else ".rows_independent"
  tests <- setNames(list(unname(s$logtest[1]), unname(s$sctest[1])), paste0(c("statistic.log", "statistic.sc"), naive))
  case(c("cox", "--formula", formula, "--ties", ties, extra),
       list(coefficients = rows(table, c("estimate", se, "statistic", "p.value")),
            zph = rows(z, c("statistic", "df", "p.value")),
            summary = c(list(logLik = f$loglik[2]), tests,
                        list(statistic.wald = as.numeric(f$wald.test), concordance = unname(s$concordance[1]),
                             std.error.concordance = unname(s$concordance[2])))))
}
km_case <- function() {
  test <- survdiff(Surv(time_s, success) ~ light, d)
  at <- summary(survfit(Surv(time_s, success) ~ light, d), times = 20)
  case(c("km", "--formula", "Surv(time_s, success) ~ light", "--times", "20"),
       list(logrank = rows(cbind(test$obs, test$exp), c("observed", "expected")),
            times = rows(cbind(at$surv, at$std.err, at$lower, at$upper), c("estimate", "std.error", "conf.low", "conf.high")),
            summary = list(statistic = test$chisq)))
}
roc_case <- function() {
  marker <- function(x) roc(d$success, x, levels = c(0, 1), direction = "<", quiet = TRUE)
  a <- marker(d$x); b <- marker(-d$z); t <- roc.test(a, b, method = "delong")
  one <- function(r) c(auc(r), sqrt(var(r)), ci.auc(r)[c(1, 3)])
  case(c("roc", "--formula", "success ~ x + I(-z)"),
       list(auc = rows(rbind(one(a), one(b)), c("estimate", "std.error", "conf.low", "conf.high")),
            differences = list(list(estimate = as.numeric(auc(a) - auc(b)), statistic = unname(t$statistic), p.value = t$p.value))))
}
concordance_case <- function() {
  a <- concordance(Surv(time_s, success) ~ x, d, reverse = TRUE, cluster = d$day)
  case(c("concordance", "--formula", "Surv(time_s, success) ~ x", "--reverse", "--cluster", "day"),
       list(concordance = list(list(estimate = unname(a$concordance), std.error = sqrt(a$var), tied.x = unname(a$count["tied.x"])))))
}

surv <- "Surv(time_s, success) ~ x + light"
out <- list(versions = list(R = R.version.string, survival = as.character(packageVersion("survival")), pROC = as.character(packageVersion("pROC"))),
            csv = paste(capture.output(write.csv(d, row.names = FALSE, quote = FALSE)), collapse = "\n"),
            cases = list(glm_case("success ~ x + light"), glm_case("success ~ x * light + log(z)"), glm_case("success ~ I(x^2) + scale(z) - 1"),
                         cox_case(surv, "efron"), cox_case(surv, "breslow"), cox_case("Surv(time_s, success) ~ x + z + strata(light)", "efron"),
                         cox_case(surv, "efron", c("--cluster", "day"), "day"),
                         km_case(), roc_case(), concordance_case()))
cat(toJSON(out, digits = I(15), auto_unbox = TRUE, pretty = 1), "\n")
