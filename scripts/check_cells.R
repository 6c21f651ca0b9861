# What the checks against R share: run the tool, compare its cells, report. Sourced, not run.

# Closed forms have no excuse; an iterated fit stops a little before its optimum.
CLOSED <- 1e-8
FITTED <- 1e-7

cells <- new.env()
cells$table <- list()
cells$withheld <- FALSE  # One value, or one a cell that is checked next.

# Quantities that the tool withholds where clusters or outcomes are few.
INFERENCE <- "\\b(SE|CI|p)\\b|^Holm|TOST|equivalent|margin|correlation|heterogeneity|interaction"

#' The clusters and the outcomes of a class below which there is no inference.
too_few <- function(y, cluster) length(unique(cluster)) < 6 || min(sum(y == 1), sum(y == 0)) < 10

withheld_or <- function(quantity, expected) {
  if (grepl(INFERENCE, quantity)) expected[rep_len(cells$withheld, length(expected))] <- NA
  expected
}

#' The JSON that the tool prints with these arguments. Its exit status 0 or 65 both print a result.
run_json <- function(tool, arguments) {
  output <- tempfile(fileext = ".json")
  on.exit(unlink(output))
  status <- system2(tool, shQuote(c(arguments, "--format", "json", "--quiet", "--output", output)))
  if (!file.exists(output)) stop("the tool printed nothing, exit status ", status)
  jsonlite::fromJSON(output)
}

# Plain relative, so that a p-value of 1e-20 is checked as strictly as one of 0.5.
relative_error <- function(found, expected) {
  if (is.na(found) && is.na(expected)) return(0)
  if (is.na(found) || is.na(expected)) return(Inf)
  if (found == expected) return(0)
  abs(found - expected) / max(abs(expected), .Machine$double.xmin)
}

#' Compares one cell, or a vector of them. A missing value agrees with a missing value only.
check <- function(quantity, where, found, expected, tolerance = CLOSED) {
  if (is.null(found)) found <- NA  # A column that is null in every row.
  if (length(found) != length(expected)) {
    stop(quantity, " of ", where, ": ", length(found), " cells, R has ", length(expected))
  }
  record(quantity, where, as.numeric(found), as.numeric(withheld_or(quantity, expected)), tolerance)
}

record <- function(quantity, where, found, expected, tolerance) {
  error <- mapply(relative_error, found, expected)
  cells$table[[length(cells$table) + 1]] <- data.frame(
    quantity = rep(quantity, length(found)), where = rep_len(where, length(found)), found, expected,
    error, tolerance = rep(tolerance, length(found)))
}

#' As `check`, of words.
check_text <- function(quantity, where, found, expected) {
  expected <- withheld_or(quantity, expected)
  same <- (is.na(found) & is.na(expected)) | (!is.na(found) & !is.na(expected) & found == expected)
  record(quantity, paste0(where, " (", found, " / ", expected, ")"), as.numeric(same),
         rep(1, length(same)), CLOSED)
}

worst_per_quantity <- function(table) {
  quantity <- factor(table$quantity, unique(table$quantity))
  data.frame(quantity = levels(quantity),
             cells = as.vector(table(quantity)),
             tolerance = as.vector(tapply(table$tolerance, quantity, max)),
             worst = as.vector(tapply(table$error, quantity, max)),
             disagree = as.vector(tapply(table$error > table$tolerance, quantity, sum)))
}

#' Lists disagreements and the worst of each quantity; ends R with status 1 if there is any.
report <- function() {
  table <- do.call(rbind, cells$table)
  wrong <- table[table$error > table$tolerance, ]
  if (nrow(wrong) > 0) {
    cat("\nDisagreements:\n")
    cat(sprintf("  %s, %s: tool %.15g, R %.15g, relative %.2g\n",
                wrong$quantity, wrong$where, wrong$found, wrong$expected, wrong$error), sep = "")
  }
  cat(sprintf("\nWorst relative disagreement (allowed: closed forms %g, fits %g):\n", CLOSED, FITTED))
  worst <- worst_per_quantity(table)
  cat(sprintf("  %-34s %6d cells  %8.2g of %g%s\n", worst$quantity, worst$cells, worst$worst,
              worst$tolerance, ifelse(worst$disagree > 0, sprintf("  %d disagree", worst$disagree), "")),
      sep = "")
  cat(sprintf("%d cells checked, %d disagree; worst relative disagreement %.2g\n",
              nrow(table), nrow(wrong), max(table$error)))
  quit(status = as.integer(nrow(wrong) > 0))
}
