# R's side of scripts/compare_with_r, which calls it:
#
#     Rscript compare_with_r.R JOB FILE [REPLICATES]   prints one line of results, as the program does
#     Rscript compare_with_r.R table RESULTS           prints the tables of all results
#     Rscript compare_with_r.R real ROWS DATA FILE     draws so many of the real trials of DATA, with
#                                                      replacement, into a table with the same columns
#
# A job is warmed up on the first rows, collects garbage, and is timed by the wall clock and by the
# processor's time, once and again until half a second has passed; data are read before. The peak is
# the resident memory from after the reading on, the data included.
suppressPackageStartupMessages({ library(survival); library(lme4); library(boot); library(pROC) })

cox_formula <- Surv(time, success) ~ x1 + x2 + x3 + x4 + lighting
strata_formula <- Surv(time, success) ~ x1 + x2 + x3 + x4 + strata(lighting)

# Coefficient of x1 and its standard error, robust if there are clusters.
cox <- function(formula, ties) function(data, replicates) {
  fit <- coxph(formula, data, ties = ties)
  c(coef(fit)[["x1"]], sqrt(vcov(fit)["x1", "x1"]))
}
concordance_of_x1 <- function(data, replicates) {
  fit <- concordance(Surv(time, success) ~ x1, data, reverse = TRUE)
  c(coef(fit)[[1]], sqrt(vcov(fit))[[1]])
}
# The standard deviation between days and the standard error of x1. The tight control is the one of
# the reference values; at the default one PIRLS stops early, which the numbers show.
glmm_formula <- success ~ x1 + x2 + x3 + x4 + lighting + (1 | day)
tight <- glmerControl(optimizer = "bobyqa", optCtrl = list(maxfun = 1e5, rhobeg = 2e-2, rhoend = 1e-10), tolPwrss = 1e-13)
glmm <- function(points, control) function(data, replicates) {
  fit <- glmer(glmm_formula, data, binomial, nAGQ = points, control = control)
  c(getME(fit, "theta")[[1]], summary(fit)$coefficients["x1", 2])
}
glmm_profile <- function(data, replicates) {
  confint(glmer(glmm_formula, data, binomial, control = tight), method = "profile", quiet = TRUE)["x1", ]
}
# Survival in bright light just after 10 s and its standard error.
kaplan_meier <- function(data, replicates) {
  curve <- survfit(Surv(time, success) ~ lighting, data)[1]
  at <- max(which(curve$time <= 10 + 1e-9))
  c(curve$surv[at], curve$surv[at] * curve$std.err[at])
}
log_rank <- function(data, replicates) {
  test <- survdiff(Surv(time, success) ~ lighting, data)
  c(test$chisq, length(test$n) - 1)
}

auc_by_proc <- function(data, score) {
  as.numeric(auc(roc(data$success, data[[score]], levels = c(0, 1), direction = "<", quiet = TRUE)))
}
auc_by_ranks <- function(data, score) {
  one <- data$success == 1
  n1 <- as.numeric(sum(one))
  (sum(rank(data[[score]])[one]) - n1 * (n1 + 1) / 2) / (n1 * (length(one) - n1))
}
c_by_concordance <- function(data, score) {
  coef(concordance(reformulate(score, "Surv(time, success)"), data, reverse = TRUE))[[1]]
}
# The part of concordance() that counts, without its formula and its variance.
c_by_concordancefit <- function(data, score) {
  concordancefit(Surv(data$time, data$success), data[[score]], reverse = TRUE, std.err = FALSE)$concordance
}

jackknife <- function(data, statistic) {
  n <- nrow(data)
  left_out <- vapply(seq_len(n), function(i) statistic(data, seq_len(n)[-i]), 0)
  (n - 1) * (mean(left_out) - left_out)
}
# Ends of the BCa interval of the difference between x1 and x2. boot.ci takes its acceleration from
# a regression on the replicates unless it is given values of the jackknife, as ours has them.
bca <- function(measure, by_jackknife) function(data, replicates) {
  data <- data[c("x1", "x2", "success", "time")]
  difference <- function(d, i) { d <- d[i, ]; measure(d, "x1") - measure(d, "x2") }
  set.seed(1)
  result <- boot(data, difference, R = replicates)
  interval <- if (by_jackknife) boot.ci(result, type = "bca", L = jackknife(data, difference))
              else boot.ci(result, type = "bca")
  interval$bca[4:5]
}

jobs <- list(
  cox_efron = cox(cox_formula, "efron"),
  cox_efron_cluster = cox(update(cox_formula, . ~ . + cluster(day)), "efron"),
  cox_breslow = cox(cox_formula, "breslow"),
  cox_real = cox(strata_formula, "efron"),
  cox_real_cluster = cox(update(strata_formula, . ~ . + cluster(day)), "efron"),
  concordance = concordance_of_x1,
  kaplan_meier = kaplan_meier,
  log_rank = log_rank,
  glmm_laplace = glmm(1, glmerControl()),
  glmm_laplace_tight = glmm(1, tight),
  glmm_agq25 = glmm(25, glmerControl()),
  glmm_agq25_tight = glmm(25, tight),
  glmm_profile_tight = glmm_profile,
  auc_bca_proc = bca(auc_by_proc, FALSE),
  auc_bca_ranks = bca(auc_by_ranks, FALSE),
  auc_bca_ranks_jackknife = bca(auc_by_ranks, TRUE),
  c_bca_concordance = bca(c_by_concordance, FALSE),
  c_bca_concordancefit_jackknife = bca(c_by_concordancefit, TRUE))

reset_peak_memory <- function() try(cat("5", file = "/proc/self/clear_refs"), silent = TRUE)
peak_megabytes <- function() {
  line <- grep("^VmHWM:", readLines("/proc/self/status"), value = TRUE)
  as.numeric(gsub("[^0-9]", "", line)) / 1024
}
# Medians of wall and processor seconds.
timed <- function(work) {
  wall <- cpu <- numeric(0)
  while (sum(wall) < 0.5) {
    one <- system.time(work(), gcFirst = TRUE)
    wall <- c(wall, one[["elapsed"]])
    cpu <- c(cpu, one[["user.self"]] + one[["sys.self"]])
  }
  c(median(wall), median(cpu))
}
run_job <- function(name, path, replicates) {
  job <- jobs[[name]]
  if (is.null(job)) stop("no job ", name, "; there are: ", paste(names(jobs), collapse = " "))
  data <- read.csv(path, colClasses = c("integer", rep("character", 2), rep("numeric", 4), "integer", "numeric"))
  if (!grepl("bca|glmm", name)) invisible(job(head(data, 600), 0))
  invisible(gc())
  reset_peak_memory()
  seconds <- timed(function() numbers <<- job(data, replicates))
  cat(sprintf("R,%s,%d,1,%.6g,%.6g,%.1f,%.7g,%.7g\n", name, nrow(data), seconds[1], seconds[2], peak_megabytes(), numbers[1], numbers[2]))
}

medians <- function(results) {
  key <- with(results, paste(side, job, rows, threads))
  do.call(rbind, lapply(split(results, factor(key, unique(key))), function(runs) {
    runs$runs <- nrow(runs)
    measured <- c("seconds", "cpu_seconds", "peak_mb")
    runs[1, measured] <- vapply(runs[measured], median, 0)
    runs[1, ]
  }))
}
# Every R job beside the job of ours that it is a way to do, on the same number of rows; ours that R
# does not do, alone.
beside <- function(all) {
  of_r <- all[all$side == "R", ]
  of_r$ours <- sub("_(proc|ranks|concordance|tight)(fit)?(_jackknife)?$", "", of_r$job)
  rows <- merge(of_r, all[all$side == "ours", ], by.x = c("ours", "rows"), by.y = c("job", "rows"), suffixes = c("_r", ""), sort = FALSE)
  data.frame(
    job = rows$job, rows = rows$rows, threads = rows$threads,
    ours_s = signif(rows$seconds, 3), r_s = signif(rows$seconds_r, 3), ratio_s = signif(rows$seconds_r / rows$seconds, 3),
    ours_cpu = signif(rows$cpu_seconds, 3), r_cpu = signif(rows$cpu_seconds_r, 3), ratio_cpu = signif(rows$cpu_seconds_r / rows$cpu_seconds, 3),
    ours_mb = round(rows$peak_mb), r_mb = round(rows$peak_mb_r), ratio_mb = signif(rows$peak_mb_r / rows$peak_mb, 3),
    runs = paste(rows$runs, rows$runs_r, sep = "+"),
    ours_result = sprintf("%.6g %.6g", rows$first, rows$second), r_result = sprintf("%.6g %.6g", rows$first_r, rows$second_r))
}
# The same jobs by the program of another commit.
before_and_after <- function(all) {
  rows <- merge(all[all$side == "before", ], all[all$side == "ours", ], by = c("job", "rows", "threads"), suffixes = c("_before", ""), sort = FALSE)
  data.frame(job = rows$job, rows = rows$rows, threads = rows$threads,
             before_s = signif(rows$seconds_before, 3), after_s = signif(rows$seconds, 3),
             before_cpu = signif(rows$cpu_seconds_before, 3), after_cpu = signif(rows$cpu_seconds, 3),
             times = signif(rows$cpu_seconds_before / rows$cpu_seconds, 3),
             before_mb = round(rows$peak_mb_before), after_mb = round(rows$peak_mb), runs = rows$runs)
}
growth <- function(all) {
  own <- all[all$side == "ours" & all$threads == 1 & !grepl("bca|profile", all$job), ]
  own <- own[order(own$job, own$rows), ]
  before <- c(NA, seq_len(nrow(own) - 1))
  before[c(TRUE, own$job[-1] != own$job[-nrow(own)])] <- NA
  data.frame(job = own$job, rows = own$rows, seconds = signif(own$seconds, 3), cpu_s = signif(own$cpu_seconds, 3),
             us_per_row = signif(1e6 * own$cpu_seconds / own$rows, 3),
             exponent = round(log(own$cpu_seconds / own$cpu_seconds[before]) / log(own$rows / own$rows[before]), 2),
             peak_mb = round(own$peak_mb), runs = own$runs)
}
print_tables <- function(path) {
  options(width = 220)
  all <- medians(read.csv(path))
  cat("Seconds and peak memory, medians; ratios are R over ours. Threads are ours, R has one.\n")
  print(beside(all), row.names = FALSE)
  if (any(all$side == "before")) {
    cat("\nBefore and after.\n")
    print(before_and_after(all), row.names = FALSE)
  }
  cat("\nGrowth of ours, one thread.\n")
  print(growth(all), row.names = FALSE)
}

# Runs of planners in the worlds of BARN that stand still: planners as strata ('lighting'), worlds as
# clusters ('day'), their first four measures of difficulty as predictors.
draw_real <- function(rows, data, path) {
  trials <- read.csv(file.path(data, "barn-trials", "trials.csv"))
  metrics <- read.csv(file.path(data, "barn-worlds", "difficulty_metrics.csv"))
  trials <- trials[trials$world %in% metrics$world & trials$world < 300 & trials$time_s > 0, ]
  metrics <- metrics[match(trials$world, metrics$world), ]
  set.seed(1)
  drawn <- sample(nrow(trials), rows, replace = TRUE)
  write.csv(data.frame(trial = seq_len(rows), day = paste0("w", trials$world[drawn]), lighting = trials$planner[drawn],
                       x1 = metrics$m1[drawn], x2 = metrics$m2[drawn], x3 = metrics$m3[drawn], x4 = metrics$m4[drawn],
                       success = trials$success[drawn], time = trials$time_s[drawn]),
            path, row.names = FALSE, quote = FALSE)
  cat(nrow(trials), "real trials,", length(unique(trials$planner)), "planners,", length(unique(trials$time_s)), "times\n", file = stderr())
}

arguments <- commandArgs(TRUE)
if (length(arguments) == 4 && arguments[1] == "real") {
  draw_real(as.integer(arguments[2]), arguments[3], arguments[4])
} else if (length(arguments) == 2 && arguments[1] == "table") {
  print_tables(arguments[2])
} else if (length(arguments) %in% 2:3) {
  run_job(arguments[1], arguments[2], if (length(arguments) == 3) as.integer(arguments[3]) else 10000L)
} else stop("usage: Rscript compare_with_r.R JOB FILE [REPLICATES] | table RESULTS | real ROWS DATA FILE")
