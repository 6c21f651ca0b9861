#!/usr/bin/env Rscript
# How often tests of a nested model reject at a nominal 5 % where trials of a day are alike: the size of what
# H1 prints in the rows 'rivals + ...'.   Rscript scripts/nested_size.R [STUDIES=400]
#
# 22 days of 30 trials. Ability decides the outcome (77 of 660 fail) and the time; the rival sees a little of
# it; what is added is unrelated to it. All three are alike within a day.
suppressPackageStartupMessages(library(survival))

studies <- as.integer(c(commandArgs(trailingOnly = TRUE), 400)[1])
days <- 22
day <- rep(seq_len(days), each = 30)
critical <- qt(0.975, days - 1)

alike <- function(icc) sqrt(icc) * rnorm(days)[day] + sqrt(1 - icc) * rnorm(length(day))

# Sandwich and jackknife of whole days; the jackknife by one Newton step, which fits of their own confirm.
logistic_variances <- function(X, y, beta) {
  p <- plogis(drop(X %*% beta))
  information <- crossprod(X * sqrt(p * (1 - p)))
  score <- rowsum(X * (y - p), day)
  sandwich <- solve(information) %*% crossprod(score) %*% solve(information)
  change <- t(sapply(seq_len(days), function(g) {
    own <- day == g
    drop(solve(information - crossprod(X[own, ] * sqrt((p * (1 - p))[own])), score[g, ]))
  }))
  c(sandwich = sandwich[3, 3], jackknife = (days - 1) / days * sum(change[, 3]^2))
}

cox_variances <- function(outcome, X, fit) {
  sandwich <- coxph(outcome ~ X, cluster = day)$var[2, 2]
  without <- sapply(seq_len(days), function(g) {
    kept <- day != g
    coef(coxph(outcome[kept] ~ X[kept, ], init = coef(fit)))[2]
  })
  c(sandwich = sandwich, jackknife = (days - 1) / days * sum((without - coef(fit)[2])^2))
}

rejections <- function(name, ratio, estimate, variance) {
  z <- abs(estimate) / sqrt(variance)
  found <- c(ratio > qchisq(0.95, 1), z[["sandwich"]] > qnorm(0.975),
             z[["sandwich"]] * sqrt((days - 1) / days) > critical, z[["jackknife"]] > critical)
  setNames(found, paste(name, c("likelihood ratio", "sandwich, normal", "CR1, t", "CV3, t")))
}

study <- function(icc) {
  ability <- alike(icc)
  y <- as.integer(ability > qnorm(77 / 660))
  X <- cbind(1, 0.3 * ability + sqrt(1 - 0.09) * alike(icc), alike(icc))
  small <- glm.fit(X[, 1:2], y, family = binomial())
  large <- glm.fit(X, y, family = binomial())
  beta <- large$coefficients
  outcome <- Surv(ifelse(y == 1, 60 - 5 * ability, 120), y)
  cox_small <- coxph(outcome ~ X[, 2])
  cox_large <- coxph(outcome ~ X[, 2:3])
  c(rejections("logistic:", small$deviance - large$deviance, beta[3], logistic_variances(X, y, beta)),
    rejections("Cox:", 2 * (cox_large$loglik[2] - cox_small$loglik[2]), coef(cox_large)[2],
               cox_variances(outcome, X[, 2:3], cox_large)))
}

table <- sapply(c(0.2, 0.38, 0.5), function(icc) {
  set.seed(151)
  rowMeans(replicate(studies, study(icc)))
})
colnames(table) <- paste("icc", c(0.2, 0.38, 0.5))
print(round(100 * table, 1))
