# Recomputes every deterministic cell of the H2 tables. Sourced by check_hypotheses.R, whose panels, AUC, C and
# Cox functions it uses.

# Numbers by value, names by byte.
levels_of <- function(group) {
  if (is.numeric(group)) as.character(sort(unique(group))) else sort(unique(group), method = "radix")
}

#' The panel's rows of one group.
part_of <- function(d, level) {
  rows <- as.character(d$group) == level
  e <- d
  e$y <- d$y[rows]
  e$cluster <- d$cluster[rows]
  e$x <- d$x[rows, 1]
  e$scaled <- d$scaled[rows, 1, drop = FALSE]
  e$strata <- d$strata[rows]
  e$within <- d$within[rows]
  e$n <- sum(rows)
  if (!is.null(d$censored)) {
    e$censored <- d$censored[rows]
    e$at_limit <- d$at_limit[rows]
  }
  e
}

both_classes <- function(e) length(unique(e$y)) == 2

# ---- Effects within a group --------------------------------------------------------------------

# Sandwich over clusters, at the optimum: glm's own covariance is of the step before the last.
glm_at_optimum <- function(x, y, cluster) {
  X <- cbind(1, x)
  start <- glm.fit(X, y, family = binomial(), control = exact_glm)$coefficients
  for (step in 1:3) {
    p <- plogis(drop(X %*% start))
    bread <- solve(crossprod(X * sqrt(p * (1 - p))))
    start <- start + drop(bread %*% crossprod(X, y - p))
  }
  p <- plogis(drop(X %*% start))
  bread <- solve(crossprod(X * sqrt(p * (1 - p))))
  meat <- crossprod(rowsum(X * (y - p), cluster))
  list(coef = start, var = bread %*% meat %*% bread)
}

# A group in which an effect runs to infinity has none: R says so by an error or by an absurd value.
or_na <- function(expected, size) {
  value <- tryCatch(suppressWarnings(expected), error = function(e) rep(NA_real_, size))
  if (anyNA(value) || any(!is.finite(value)) || (size == 4 && abs(log(value[1])) > 30)) {
    return(rep(NA_real_, size))
  }
  value
}

odds_ratio <- function(e) {
  by_clusters(e, function(rows) {
    glm_at_optimum(e$scaled[rows, , drop = FALSE], e$y[rows], e$cluster[rows])$coef[[2]]
  }, function() glm_at_optimum(e$scaled, e$y, e$cluster)$var[2, 2])
}

check_ratio <- function(column, p_column, where, h2, forms, expected) {
  found <- c(unlist(h2[paste0(column, c("", "_low", "_high"))]), forms[[p_column]])
  quantity <- paste("H2", column, c("", "CI", "CI", "p"))
  for (i in 1:4) check(quantity[i], where, found[i], expected[i], FITTED)
}

check_level_within <- function(d, e, where, found, forms) {
  own <- function(name, outcome, x) {
    fit <- tryCatch(c_within(x, outcome, e, e$cluster), error = function(error) NULL)
    value <- if (is.null(fit)) NA else fit$concordance
    se <- if (is.na(value)) NA else sqrt(fit$var)
    quantity <- paste("H2", toupper(name), "within")
    check(quantity, where, found[[paste0(name, "_within")]], value)
    check(paste(quantity, "SE"), where, forms[[paste0(name, "_within_std_error")]], se)
    check(paste(quantity, "CI"), where, unlist(forms[paste0(name, "_within", c("_low", "_high"))]),
          if (is.na(value)) c(NA, NA) else wald(value, se, d$level))
  }
  own("auc", e$y, e$x)
  if (!is.null(d$censored)) own("c", e$censored, -e$x)
}

check_level <- function(d, level, h2, forms, within) {
  e <- part_of(d, level)
  cells$withheld <- d$few || too_few(e$y, e$cluster)
  where <- paste(d$name, level)
  check("H2 n", where, h2$n, e$n)
  check("H2 events", where, h2$events, sum(e$y))
  check("H2 clusters", where, h2$clusters, length(unique(e$cluster)))
  if (!both_classes(e)) return(invisible(check("H2 AUC", where, h2$auc, NA)))
  auc <- auc_by_ranks(e$x, e$y)
  se <- sqrt(auc_variance(e$x, e))
  check("H2 AUC", where, h2$auc, auc)
  check("H2 AUC clustered SE", where, forms$auc_std_error, se)
  check("H2 AUC clustered CI", where, c(forms$auc_low, forms$auc_high), wald(auc, se, d$level))
  check_ratio("or", "or_p", where, h2, forms, or_na(odds_ratio(e), 4))
  if (!is.null(d$within)) check_level_within(d, e, where, within, forms)
  if (is.null(d$censored)) return(invisible())
  fit <- c_of(e$x, e$censored, e$cluster)
  check("H2 C", where, h2$c, fit$concordance)
  if (is.na(fit$concordance)) fit$var <- NA  # R says 0.
  check("H2 C clustered SE", where, forms$c_std_error, sqrt(fit$var))
  check("H2 C clustered CI", where, c(forms$c_low, forms$c_high),
        wald(fit$concordance, sqrt(fit$var), d$level))
  ratio <- function(...) or_na(hazard_ratio(e$scaled, ...), 4)
  check_ratio("hr_censored", "hr_censored_p", where, h2, forms, ratio(e$censored, e))
  check_ratio("hr_at_limit", "hr_at_limit_p", where, h2, forms, ratio(e$at_limit, e))
  check_ratio("hr_stratified", "hr_stratified_p", where, h2, forms,
              if (is.null(d$strata)) rep(NA, 4) else ratio(e$censored, e, TRUE))
}

# ---- Joint covariances -------------------------------------------------------------------------

#' `number(rows)` of each group, with their covariance by the jackknife of whole clusters.
groups_by_jackknife <- function(d, levels, number) {
  jackknife(d$cluster, function(rows) sapply(levels, function(level) {
    number(rows & as.character(d$group) == level)
  }))
}

auc_groups <- function(d, levels) {
  groups_by_jackknife(d, levels, function(rows) auc_by_ranks(d$x[rows, 1], d$y[rows]))
}

c_groups <- function(d, levels) {
  groups_by_jackknife(d, levels, function(rows) c_of(d$x[rows, 1], d$censored[rows])$concordance)
}

wald_statistic <- function(estimate, covariance) {
  drop(t(estimate) %*% solve(covariance, estimate))
}

# Hotelling's T^2 of as many estimates from so many clusters.
hotelling_p <- function(chi, k, clusters) {
  pf(chi * (clusters - k) / (k * (clusters - 1)), k, clusters - k, lower.tail = FALSE)
}

# ---- Equality ----------------------------------------------------------------------------------

check_pairs <- function(where, found, groups, pairs, margin) {
  df <- groups$clusters - 1
  z <- qt(0.95, df)
  d <- groups$values[pairs[1, ]] - groups$values[pairs[2, ]]
  V <- groups$covariance
  se <- sqrt(diag(V)[pairs[1, ]] + diag(V)[pairs[2, ]] - 2 * V[t(pairs)])
  check("H2 difference", where, found$difference, d)
  check("H2 difference SE", where, found$std_error, se)
  check("H2 difference 90 % CI", where, c(found$difference_low, found$difference_high),
        c(d - z * se, d + z * se))
  p <- pmax(pt((d + margin) / se, df, lower.tail = FALSE), pt((d - margin) / se, df))
  check("H2 TOST p", where, found$p_tost, p)
  check_text("H2 equivalent", where, found$equivalent,
             ifelse(d - z * se > -margin & d + z * se < margin, "yes", "no"))
  check("H2 smallest margin", where, found$smallest_margin, abs(d) + z * se)
  list(se = se, p = p, smallest = abs(d) + z * se)
}

check_equality <- function(d, quantity, levels, groups, result) {
  where <- paste(d$name, quantity)
  if (anyNA(groups$values) || anyNA(groups$covariance)) {
    rows <- sum(unlist(result$h2_equality["panel"]) == d$name & unlist(result$h2_equality["quantity"]) == quantity)
    check("H2 rows without a joint covariance", where, rows, 0)
    return(invisible())
  }
  pick <- function(table) table[table$panel == d$name & table$quantity == quantity, , drop = FALSE]
  pairs <- combn(length(levels), 2)
  margin <- result$summary$margin
  found <- pick(result$h2_equality)
  cells$withheld <- d$few_levels[pairs[1, ]] | d$few_levels[pairs[2, ]]
  own <- check_pairs(where, pick(result$h2_pairs), groups, pairs, margin)
  covariance <- pick(result$h2_covariance)
  cells$withheld <- d$few_levels[match(covariance$first, levels)] |
    d$few_levels[match(covariance$second, levels)]
  V <- groups$covariance
  scale <- sqrt(diag(V)[match(covariance$first, levels)] * diag(V)[match(covariance$second, levels)])
  expected <- V[cbind(match(covariance$first, levels), match(covariance$second, levels))]
  # A covariance near 0 is a sum that cancels: judged on the scale of the variances.
  check("H2 1 + correlation", where, 1 + covariance$covariance / scale, 1 + expected / scale)
  cells$withheld <- any(d$few_levels)
  check("H2 TOST p of all", where, found$p_tost, max(own$p))
  check_text("H2 all equivalent", where, found$equivalent, if (all(own$smallest < margin)) "yes" else "no")
  check("H2 smallest margin of all", where, found$smallest_margin, max(own$smallest))
  check("H2 margin with 80 % power", where, found$margin_80,
        max(own$se) * (qt(0.95, groups$clusters - 1) + qt(1 - 0.2 / ncol(pairs) / 2, groups$clusters - 1)))
  L <- cbind(1, -diag(length(levels) - 1))
  chi <- tryCatch(wald_statistic(L %*% groups$values, L %*% V %*% t(L)), error = function(e) NA)
  df <- length(levels) - 1
  check("H2 heterogeneity", where, found$statistic, chi)
  check("H2 heterogeneity df", where, found$df, if (is.na(chi)) NA else df)
  check("H2 heterogeneity p", where, found$p, hotelling_p(chi, df, groups$clusters))
  check("H2 max - min", where, found$range, diff(range(groups$values)))
  found
}

# Another permutation with other draws: close, never equal.
inform_of_permutation <- function(d, levels, found, permutations = 300) {
  set.seed(1)
  rows <- split(seq_len(d$n), d$cluster)
  group <- as.character(d$group)
  ranges <- replicate(permutations, {
    shuffled <- group
    for (own in rows) shuffled[own] <- group[own[sample.int(length(own))]]
    diff(range(sapply(levels, function(level) {
      in_group <- shuffled == level
      auc_by_ranks(d$x[in_group, 1], d$y[in_group])
    })))
  })
  ranges <- ranges[!is.na(ranges)]  # A small group may get one class.
  cat(sprintf("%s, max - min of AUC expected if equal: tool %.4f, R %.4f: %s (not counted)\n", d$name,
              found$range_expected, mean(ranges),
              if (abs(found$range_expected - mean(ranges)) < 4 * sd(ranges) / sqrt(length(ranges)))
                "within error" else "NOT within error"))
}

# ---- Interaction -------------------------------------------------------------------------------

interaction_design <- function(d, levels) {
  x <- d$scaled[, 1]
  dummies <- sapply(levels[-1], function(level) as.numeric(as.character(d$group) == level))
  cbind(x, dummies, dummies * x)
}

jackknife_wald <- function(d, last, coefficients) {
  j <- jackknife(d$cluster, function(rows) coefficients(rows)[last])
  wald_statistic(j$values, j$covariance)
}

cox_wald <- function(x, outcome, d, last, stratified) {
  jackknife_wald(d, last, function(rows) {
    y <- outcome[rows]
    x <- x[rows, , drop = FALSE]
    s <- d$strata[rows]
    part <- if (stratified) y ~ x + strata(s) else y ~ x
    coef(at_optimum(part, coxph(part, cluster = d$cluster[rows], ties = "efron", control = exact_cox),
                    d$cluster[rows]))
  })
}

check_interactions <- function(d, levels, found) {
  x <- interaction_design(d, levels)
  k <- length(levels) - 1
  last <- ncol(x) - (k - 1):0
  expected <- function(model) {
    switch(model,
           logistic = {
             jackknife_wald(d, last + 1, function(rows) {
               glm_at_optimum(x[rows, ], d$y[rows], d$cluster[rows])$coef
             })
           },
           Cox = cox_wald(x, d$censored, d, last, FALSE),
           "Cox, stratified" = cox_wald(x, d$censored, d, last, TRUE),
           "logistic, mixed" = mixed_ratio(x, d, last))
  }
  for (i in seq_len(nrow(found))) {
    where <- paste(d$name, found$model[i])
    if (found$model[i] == "logistic, mixed" && length(x) > 50000) {
      cat(where, ": left out, glmer would take hours on", nrow(x), "rows of", ncol(x), "columns\n")
      next
    }
    chi <- tryCatch(expected(found$model[i]), error = function(e) NA)
    mixed <- found$model[i] == "logistic, mixed"
    fitted <- if (mixed) 1e-5 else FITTED
    check("H2 interaction", where, found$statistic[i], chi, fitted)
    check("H2 interaction df", where, found$df[i], if (is.na(chi)) NA else k)
    # d log p is about half of d chi-squared.
    p <- if (mixed) pchisq(chi, k, lower.tail = FALSE)
         else hotelling_p(chi, k, length(unique(d$cluster)))
    check("H2 interaction p", where, found$p[i], p, fitted * (1 + if (is.na(chi)) 0 else chi))
  }
}

check_h2_panel <- function(d, result) {
  levels <- levels_of(d$group)
  h2 <- rows_of(result$h2, d$name)
  forms <- rows_of(result$h2_closed_form, d$name)
  check_text("H2 groups", d$name, h2$group, levels)
  within <- if (!is.null(result$h2_within)) rows_of(result$h2_within, d$name)
  d$few <- too_few(d$y, d$cluster)
  for (i in seq_along(levels)) check_level(d, levels[i], h2[i, ], forms[i, ], within[i, ])
  few <- sapply(levels, function(level) {
    e <- part_of(d, level)
    d$few || too_few(e$y, e$cluster)
  })
  d$few_levels <- few
  cells$withheld <- any(few)
  if (all(sapply(levels, function(level) both_classes(part_of(d, level))))) {
    found <- check_equality(d, "AUC", levels, auc_groups(d, levels), result)
    inform_of_permutation(d, levels, found)
  }
  if (!is.null(d$censored)) check_equality(d, "C", levels, c_groups(d, levels), result)
  check_interactions(d, levels, rows_of(result$h2_interaction, d$name))
}
