# Makes tests/golden/isotonic.json: what R's isoreg gives; falling fits are those of -y.
# Rscript scripts/golden/isotonic.R > tests/golden/isotonic.json   (jsonlite)
suppressPackageStartupMessages(library(jsonlite))

# Fitted values in the order of the rows, not of x.
rising <- function(x, y) { f <- isoreg(x, y); v <- numeric(length(x)); v[if (is.null(f$ord)) seq_along(x) else f$ord] <- f$yf; v }
case <- function(x, y) list(x = x, y = y, rising = rising(x, y), falling = -rising(x, -y))

set.seed(5)
bend <- round(runif(120, 0, 1.2), 4)
curve <- approx(c(0, 0.15, 0.35, 0.6, 0.9, 1.2), c(0.45, 0.40, 0.32, 0.22, 0.10, 0), bend)$y
x <- rnorm(60)
out <- list(versions = list(R = R.version.string),
            cases = list(tentacle = case(bend, curve + rnorm(120, 0, 0.01)),
                         ties = case(round(2 * x) / 2, round(x + rnorm(60), 2)),
                         noise = case(x, rnorm(60)),
                         sorted = case(1:8, c(1, 1, 2, 3, 5, 8, 13, 21)),
                         one_x = case(rep(3, 5), c(2, 4, 4, 5, 1)),
                         two = case(c(2, 1), c(7, 9))))
cat(toJSON(out, digits = I(15), auto_unbox = TRUE), "\n")
