# Makes tests/golden/formulas.json: what R's model.matrix says of right-hand sides, column by column with its names.
# Rscript scripts/golden/formulas.R > tests/golden/formulas.json   (splines, jsonlite)
suppressPackageStartupMessages({ library(splines); library(jsonlite) })
options(contrasts = c("contr.treatment", "contr.poly"))
invisible(Sys.setlocale("LC_COLLATE", "C"))

set.seed(5)
n <- 40
d <- data.frame(x = round(rnorm(n, 2), 2), z = round(runif(n, 0.5, 9), 2), k = sample(1:5, n, TRUE),
                light = sample(c("bright", "dark", "dim"), n, TRUE), `a b` = round(rnorm(n), 1), check.names = FALSE)
formulas <- c("ns(x, df = 3)", "ns(x, 4) + z", "ns(z, knots = c(2, 5))", "ns(x)", "poly(x, 2)", "poly(z, 3) + x", "poly(x, 1)",
              "poly(x, degree = 3, raw = TRUE)", "poly(x, 2):light", "ns(x, df = 2) * light",
              "sin(x) + cos(2 * x)", "pmin(x, 2) + pmax(x, z, 1.5)", "ifelse(x > 2, z, 0)", "ifelse(x > 2, \"hot\", \"cold\")",
              "cut(z, breaks = c(0, 2, 5, 9))", "cut(z, 3)", "cut(k, c(1, 3, 5), include.lowest = TRUE)", "cut(z, c(-Inf, 3, Inf), right = FALSE)",
              "cut(z, c(0, 4, 9), labels = c(\"low\", \"high\"))", "cut(z, c(0, 1.23456, 1.23457, 9))",
              "I(x > 1 & z < 5)", "I(x > 3 | z < 2)", "I(!(x > 2))", "x > 1 & !(z < 5)", "I(light %in% c(\"dim\", \"dark\"))", "I(k %in% c(1, 3))",
              "log(z, base = 2)", "log(z, 10)", "log(base = 3, x = z)", "`a b` + x", "`a b`:light", "I(`a b`^2)", "-1 + cut(z, c(0, 4, 9))")
case <- function(f) {
  f_ <- as.formula(paste("~", f))
  m <- model.matrix(f_, model.frame(f_, d, drop.unused.levels = TRUE))     # As glm and lm do.
  list(formula = f, columns = colnames(m), values = unname(lapply(seq_len(ncol(m)), function(j) as.numeric(m[, j]))))
}
new <- data.frame(x = c(-1, 2, 6), z = c(0.1, 3, 12), k = 1:3, light = c("dim", "dark", "bright"), `a b` = 0, check.names = FALSE)
d$y <- rbinom(n, 1, plogis(0.3 * d$x))
predicted <- function(f) {
  fit <- glm(as.formula(paste("y ~", f)), binomial, d, control = glm.control(epsilon = 1e-14, maxit = 60))
  list(formula = f, eta = unname(predict(fit, new)))
}
out <- list(versions = list(R = R.version.string),
            csv = paste(capture.output(write.csv(d, row.names = FALSE, quote = FALSE)), collapse = "\n"),
            new = paste(capture.output(write.csv(new, row.names = FALSE, quote = FALSE)), collapse = "\n"),
            cases = lapply(formulas, case), predictions = lapply(c("ns(x, df = 3)", "poly(z, 2)", "scale(x) + ns(z, 2)"), predicted))
cat(toJSON(out, digits = I(15), auto_unbox = TRUE), "\n")
