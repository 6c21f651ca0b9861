# Makes tests/golden/clusters.json: variances, degrees of freedom and tests of clustered models with few clusters.
# Rscript scripts/golden/clusters.R > tests/golden/clusters.json   (survival, clubSandwich, jsonlite)
#
# Logistic regression: clubSandwich (CR0, CR1, CR2, Satterthwaite), CR2 of the weighted least squares that the fit ends
# with, in rows of equal variance: (I - H)^(-1/2) of these. For the `glm` itself vcovCR() takes another square root of
# the same matrix, which depends on the units of single rows and needs a decomposition of n_g rows; both make the
# variance unbiased where the model holds, and differ by half a percent here (`cr2_glm`). No package has CR2 of a Cox model nor a wild cluster
# bootstrap of scores: both are written out here row by row and event by event from the formulas of Bell and McCaffrey
# (2002), Pustejovsky and Tipton (2018) and MacKinnon, Nielsen and Webb (2025). The jackknife refits without each cluster.
suppressPackageStartupMessages({ library(survival); library(clubSandwich); library(jsonlite) })

set.seed(26)
groups <- 9
d <- data.frame(day = rep(seq_len(groups), times = c(6, 9, 14, 10, 8, 12, 11, 7, 13)))
n <- nrow(d)
alike <- function(icc) sqrt(icc) * rnorm(groups)[d$day] + sqrt(1 - icc) * rnorm(n)
d$x <- round(alike(0.3), 2); d$z <- round(alike(0.6), 2)
d$y <- rbinom(n, 1, plogis(0.4 + 0.6 * d$x + alike(0.4)))
d$time <- ceiling(20 * rexp(n, exp(0.4 * d$x - 0.3 * d$z + 0.4 * alike(0.5))))
d$event <- rbinom(n, 1, 0.8)

power <- function(m, e) { s <- eigen((m + t(m)) / 2); s$vectors %*% diag(s$values^e, length(s$values)) %*% t(s$vectors) }

weights <- rbind(rep(1, groups), matrix(sample(c(-1, 1), 4 * groups, TRUE), 4), matrix(sample(sqrt(c(0.5, 1, 1.5)), 2 * groups, TRUE), 2))
wild <- function(scores, infos, M, k) apply(weights, 1, function(w) {     # scores groups x p at the restricted fit
  estimate <- M %*% colSums(scores * w)
  left <- t(sapply(seq_len(groups), function(g) w[g] * scores[g, ] - drop(infos[[g]] %*% estimate)))
  estimate[k]^2 / sum((left %*% M[, k])^2)
})

logistic <- function() {
  f <- glm(y ~ x + z, binomial, d, control = glm.control(epsilon = 1e-15, maxit = 60))
  f <- update(f, start = coef(f))                     # its covariance belongs to the step before the last
  X <- model.matrix(f)
  without <- sapply(seq_len(groups), function(g) coef(glm(y ~ x + z, binomial, d[d$day != g, ], control = glm.control(epsilon = 1e-15, maxit = 60))))
  root <- sqrt(fitted(f) * (1 - fitted(f)))
  equal <- as.data.frame(cbind(X * root, response = root * drop(X %*% coef(f)) + (d$y - fitted(f)) / root))
  names(equal) <- c("one", "x", "z", "response")
  whitened <- lm(response ~ one + x + z - 1, equal)
  test <- coef_test(whitened, vcov = "CR2", cluster = d$day, test = "Satterthwaite")
  null <- glm(y ~ z, binomial, d, offset = 0.25 * d$x, control = glm.control(epsilon = 1e-15, maxit = 60))
  mu <- fitted(null); W <- mu * (1 - mu)
  scores <- rowsum(X * (d$y - mu), d$day)
  infos <- lapply(seq_len(groups), function(g) crossprod(X[d$day == g, ] * sqrt(W[d$day == g])))
  list(estimate = unname(coef(f)),
       cr0 = unname(diag(vcovCR(f, d$day, "CR0"))), cr1 = unname(diag(vcovCR(f, d$day, "CR1"))),
       cr2 = unname(diag(vcovCR(whitened, d$day, "CR2"))), cr2_glm = unname(diag(vcovCR(f, d$day, "CR2"))), df = test$df_Satt, p = test$p_Satt,
       left_out = unname(without), held = list(k = 1, value = 0.25), wild = wild(scores, infos, solve(Reduce(`+`, infos)), 2))
}

# Score residuals of the cluster's rows and the predictable variation, summed over events one by one (Breslow).
cox_pieces <- function(beta) {
  X <- cbind(d$x, d$z); r <- exp(drop(X %*% beta))
  u <- matrix(0, n, 2); info <- rep(list(matrix(0, 2, 2)), groups); rows <- list(); tag <- integer()
  for (i in which(d$event == 1)) {
    at <- d$time >= d$time[i]
    mean <- colSums(X[at, , drop = FALSE] * r[at]) / sum(r[at])
    step <- 1 / sum(r[at])
    u[i, ] <- u[i, ] + X[i, ] - mean
    for (j in which(at)) {
      v <- X[j, ] - mean
      u[j, ] <- u[j, ] - r[j] * step * v
      info[[d$day[j]]] <- info[[d$day[j]]] + r[j] * step * v %o% v
    }
  }
  list(u = rowsum(u, d$day), info = info)
}

# The adjustment in the coordinates of the coefficients: the cluster's rows of an equivalent Poisson model are many.
adjusted_cox <- function(pieces, M) {
  L <- t(chol(M)); p <- 2
  a <- lapply(pieces$info, function(A) L %*% power(diag(p) - t(L) %*% A %*% L, -0.5) %*% t(L))
  V <- Reduce(`+`, lapply(seq_len(groups), function(g) { w <- a[[g]] %*% pieces$u[g, ]; w %*% t(w) }))
  df <- sapply(seq_len(p), function(k) {
    O <- outer(seq_len(groups), seq_len(groups), Vectorize(function(g, h) {
      ag <- a[[g]][, k]; ah <- a[[h]][, k]
      (if (g == h) t(ag) %*% pieces$info[[g]] %*% ag else 0) - t(ag) %*% pieces$info[[g]] %*% M %*% pieces$info[[h]] %*% ah
    }))
    sum(diag(O))^2 / sum(O^2)
  })
  list(V = V, df = df)
}

cox <- function() {
  fit <- function(formula, data, ...) coxph(formula, data, ties = "breslow", control = coxph.control(eps = 1e-14, iter.max = 60), ...)
  f <- fit(Surv(time, event) ~ x + z + cluster(day), d)
  pieces <- cox_pieces(coef(f)); M <- solve(Reduce(`+`, pieces$info))
  stopifnot(max(abs(M - f$naive.var)) < 1e-10, max(abs(M %*% crossprod(pieces$u) %*% M - f$var)) < 1e-10)
  corrected <- adjusted_cox(pieces, M)
  without <- sapply(seq_len(groups), function(g) coef(fit(Surv(time, event) ~ x + z, d[d$day != g, ])))
  null <- fit(Surv(time, event) ~ z + offset(0.25 * x), d)
  held <- cox_pieces(c(0.25, coef(null)))
  efron <- coxph(Surv(time, event) ~ x + z + cluster(day), d, control = coxph.control(eps = 1e-14, iter.max = 60))
  list(estimate = unname(coef(f)), cr0 = diag(f$var), cr2 = diag(corrected$V), df = corrected$df,
       left_out = unname(without), held = list(k = 0, value = 0.25), wild = wild(held$u, held$info, solve(Reduce(`+`, held$info)), 1),
       efron_cr0 = diag(efron$var))
}

out <- list(versions = list(R = R.version.string, survival = as.character(packageVersion("survival")), clubSandwich = as.character(packageVersion("clubSandwich"))),
            csv = paste(capture.output(write.csv(d, row.names = FALSE, quote = FALSE)), collapse = "\n"),
            weights = weights, glm = logistic(), cox = cox())
cat(toJSON(out, digits = I(15), auto_unbox = TRUE), "\n")
