# Makes tests/golden/mixed.json: linear mixed models and pairwise contrasts, beside the calls of `tcert fit` that must say
# the same. Rscript scripts/golden/mixed.R > tests/golden/mixed.json   (lme4, lmerTest, survival, emmeans, clubSandwich, jsonlite)
#
# Linear mixed models: lme4::lmer at a tolerance far below its default, Satterthwaite's degrees of freedom by lmerTest, R2 by
# its formula (Nakagawa and Schielzeth 2013; slopes Johnson 2014), which no package of the registry has. Contrasts: emmeans
# with adjust = "holm"; of clusters the covariance is written out (jackknife of whole clusters) and given to it.
suppressPackageStartupMessages({ library(lme4); library(lmerTest); library(survival); library(emmeans); library(jsonlite) })
options(contrasts = c("contr.treatment", "contr.poly"))
invisible(Sys.setlocale("LC_COLLATE", "C"))

set.seed(62)
days <- 14
d <- data.frame(day = rep(sprintf("d%02d", seq_len(days)), times = rep(c(7, 9, 12, 8, 10, 6, 11), 2)))
n <- nrow(d)
d$run <- sprintf("r%d", sample(5, n, TRUE))
d$light <- sample(c("dark", "dim", "bright"), n, TRUE, c(0.5, 0.3, 0.2))
d$x <- round(rnorm(n), 2)
d$w <- sample(1:3, n, TRUE)
of_day <- function(sd) setNames(rnorm(days, 0, sd), unique(d$day))[d$day]
slope <- of_day(0.15)
d$time_s <- round(exp(3.4 - (0.2 + slope) * d$x + 0.15 * (d$light == "dark") + of_day(0.25) + rnorm(5, 0, 0.1)[factor(d$run)] + rnorm(n, 0, 0.3)), 2)
d$success <- rbinom(n, 1, plogis(1 + 0.8 * d$x - 0.6 * (d$light == "dark") + of_day(1.1)))
d$end_s <- pmin(d$time_s, 45)
d$done <- as.integer(d$time_s <= 45)

control <- lmerControl(optimizer = "bobyqa", optCtrl = list(maxfun = 1e6, rhobeg = 0.2, rhoend = 1e-12), calc.derivs = FALSE, check.conv.singular = "ignore")
rows <- function(m, names) lapply(seq_len(nrow(m)), function(i) as.list(setNames(as.numeric(m[i, ]), names)))
case <- function(arguments, expected, relative = 1e-8) list(arguments = arguments, relative = relative, expected = expected)

r2 <- function(f) {
  fixed <- var(drop(getME(f, "X") %*% fixef(f)))
  random <- sum(sapply(seq_along(VarCorr(f)), function(k) {
    v <- VarCorr(f)[[k]]
    z <- model.matrix(as.formula(paste("~", paste(setdiff(colnames(v), "(Intercept)"), collapse = "+"), if (ncol(v) == 1) "1")), f@frame)
    mean(rowSums((z %*% v) * z))
  }))
  whole <- fixed + random + sigma(f)^2
  c(ICC = random / (random + sigma(f)^2), R2_marginal = fixed / whole, R2_conditional = (fixed + random) / whole)
}
deviations <- function(f) {
  v <- as.data.frame(VarCorr(f))
  lapply(order(is.na(v$var1), match(v$grp, c(names(VarCorr(f)), "Residual")), !is.na(v$var2)), function(i) list(estimate = v$sdcor[i]))
}
pairs_of <- function(f, by, ratio, ...) {
  e <- emmeans(f, by, ...)
  one <- as.data.frame(summary(contrast(e, "pairwise"), infer = TRUE, adjust = "none"))
  all <- as.data.frame(summary(contrast(e, "pairwise"), infer = TRUE, adjust = "bonferroni"))
  low <- grep("LCL|lower", names(one)); high <- grep("UCL|upper", names(one))
  holm <- p.adjust(one$p.value, "holm")
  m <- cbind(one$estimate, one$SE, one$p.value, holm, one[[low]], one[[high]], all[[low]], all[[high]])
  names <- c("estimate", "std.error", "p.value", "adj.p.value", "conf.low", "conf.high", "simultaneous.low", "simultaneous.high")
  if (!is.null(ratio)) {
    m <- cbind(m, exp(one$estimate), exp(one[[low]]), exp(one[[high]]))
    names <- c(names, ratio, paste0(ratio, c(".low", ".high")))
  }
  if (all(is.finite(one$df))) { m <- cbind(m, one$df); names <- c(names, "df") }
  rows(m, names)
}

lmm_case <- function(formula, reml = TRUE, weights = NULL, contrasts = NULL, relative = 1e-6) {
  d$weight <- if (is.null(weights)) 1 else d[[weights]]
  f <- lmerTest::lmer(as.formula(formula), d, REML = reml, weights = weight, control = control)
  s <- summary(f, ddf = "Satterthwaite")$coefficients
  half <- qt(0.975, s[, "df"]) * s[, "Std. Error"]
  effects <- rows(cbind(s[, c("Estimate", "Std. Error", "df", "t value", "Pr(>|t|)")], s[, 1] - half, s[, 1] + half),
                  c("estimate", "std.error", "df", "statistic", "p.value", "conf.low", "conf.high"))
  expected <- list(coefficients = c(effects, deviations(f)),
                   summary = c(list(logLik = as.numeric(logLik(f)), AIC = AIC(f), BIC = BIC(f), sigma = sigma(f)), as.list(r2(f))))
  if (!is.null(contrasts)) {
    emm_options(lmer.df = "satterthwaite")
    expected$contrasts <- pairs_of(f, contrasts, "ratio")
  }
  case(c("lmm", "--formula", formula, if (!reml) "--ml", if (!is.null(weights)) c("--weights", weights),
         if (!is.null(contrasts)) c("--contrasts", contrasts)), expected, relative)
}

tight <- glm.control(epsilon = 1e-15, maxit = 60)
glm_case <- function(formula) {
  f <- glm(as.formula(formula), binomial, d, control = tight)
  f <- update(f, start = coef(f))
  case(c("glm", "--no-profile", "--formula", formula, "--contrasts", "light"), list(contrasts = pairs_of(f, "light", "odds.ratio")))
}
# By leaving out whole days; emmeans takes the covariance and the degrees of freedom.
clustered <- function(f, refit) {
  without <- sapply(unique(d$day), function(day) coef(refit(d[d$day != day, ])))
  V <- (days - 1) / days * tcrossprod(without - coef(f))
  pairs_of(f, "light", if (inherits(f, "coxph")) "hazard.ratio" else "odds.ratio", vcov. = V, df = days - 1)
}
glm_days <- function(formula) {
  refit <- function(data) glm(as.formula(formula), binomial, data, control = tight)
  case(c("glm", "--formula", formula, "--cluster", "day", "--contrasts", "light"), list(contrasts = clustered(refit(d), refit)))
}
cox_days <- function(formula) {
  refit <- function(data) coxph(as.formula(formula), data, control = suppressWarnings(coxph.control(eps = 1e-14, iter.max = 60)))
  case(c("cox", "--formula", formula, "--cluster", "day", "--contrasts", "light"), list(contrasts = clustered(refit(d), refit)))
}
# CR2 with the degrees of freedom of each contrast: clubSandwich of the weighted least squares that the fit ends with.
glm_cr2 <- function(formula) {
  f <- glm(as.formula(formula), binomial, d, control = tight)
  X <- model.matrix(f); root <- sqrt(fitted(f) * (1 - fitted(f)))
  equal <- as.data.frame(X * root); names(equal) <- paste0("c", seq_len(ncol(X)))
  equal$response <- root * drop(X %*% coef(f)) + (d$success - fitted(f)) / root
  w <- lm(response ~ . - 1, equal)
  L <- rbind(c(0, 0, -1, 0), c(0, 0, 0, -1), c(0, 0, 1, -1))   # bright is the reference: bright - dark, bright - dim, dark - dim
  t <- clubSandwich::linear_contrast(w, vcov = "CR2", cluster = d$day, contrasts = L, test = "Satterthwaite")
  p <- 2 * pt(-abs(t$Est / t$SE), t$df)
  case(c("glm", "--formula", formula, "--cluster", "day", "--inference", "cr2", "--contrasts", "light"),
       list(contrasts = rows(cbind(t$Est, t$SE, t$df, p, p.adjust(p, "holm")), c("estimate", "std.error", "df", "p.value", "adj.p.value"))), 1e-7)
}
# A factor in a product: the mean over the rows, were each of the level; written out.
glm_product <- function(formula) {
  f <- glm(as.formula(formula), binomial, d, control = tight)
  f <- update(f, start = coef(f))
  levels <- sort(unique(d$light))
  at <- t(sapply(levels, function(l) colMeans(model.matrix(delete.response(terms(f)), transform(d, light = factor(l, levels))))))
  L <- rbind(at[1, ] - at[2, ], at[1, ] - at[3, ], at[2, ] - at[3, ])
  estimate <- drop(L %*% coef(f)); se <- sqrt(diag(L %*% vcov(f) %*% t(L)))
  case(c("glm", "--no-profile", "--formula", formula, "--contrasts", "light"),
       list(contrasts = rows(cbind(estimate, se, p.adjust(2 * pnorm(-abs(estimate / se)), "holm")), c("estimate", "std.error", "adj.p.value"))))
}
glmm_case <- function(formula) {
  f <- glmer(as.formula(formula), d, binomial, nAGQ = 15,
             control = glmerControl(optimizer = "bobyqa", tolPwrss = 1e-13, optCtrl = list(maxfun = 1e5, rhobeg = 2e-2, rhoend = 1e-10)))
  expected <- pairs_of(f, "light", "odds.ratio")
  keep <- c("estimate", "std.error", "conf.low", "conf.high", "odds.ratio")
  case(c("glmm", "--formula", formula, "--contrasts", "light"), list(contrasts = lapply(expected, `[`, keep)), 1e-4)
}

out <- list(versions = as.list(sapply(c("lme4", "lmerTest", "emmeans", "clubSandwich", "survival"), function(p) as.character(packageVersion(p)))),
            csv = paste(capture.output(write.csv(d, row.names = FALSE, quote = FALSE)), collapse = "\n"),
            cases = list(lmm_case("log(time_s) ~ x + light + (1 | day)", contrasts = "light"),
                         lmm_case("log(time_s) ~ x + light + (1 | day)", reml = FALSE),
                         lmm_case("log(time_s) ~ x + (1 | day)", weights = "w"),
                         lmm_case("log(time_s) ~ x + (1 | day) + (1 | run)"),
                         lmm_case("log(time_s) ~ x + (1 + x | day)", relative = 1e-5),
                         lmm_case("time_s ~ light + (1 | day)", contrasts = NULL),
                         glm_case("success ~ x + light"), glm_days("success ~ x + light"), glm_cr2("success ~ x + light"),
                         glm_product("success ~ x * light"), cox_days("Surv(end_s, done) ~ x + light"),
                         glmm_case("success ~ x + light + (1 | day)")))
cat(toJSON(out, digits = I(15), auto_unbox = TRUE), "\n")
