# Recomputes in R every deterministic cell of the H3 tables from the replay's per-trial table.
# Sourced by check_hypotheses.R, which says how it is called.

#' Total length over total time, in metres per minute.
rate <- function(length, time) if (sum(time) > 0) 60 * sum(length) / sum(time) else NA_real_

median_or_na <- function(x) {
  x <- x[!is.na(x)]
  if (length(x) > 0) median(x) else NA_real_
}

# One-sided exact bound; binom.test gives the same but refuses n = 0.
upper_bound <- function(k, n, level) if (k < n) qbeta(level, k + 1, n - k) else 1

# The intraclass correlation of 0/1 values by analysis of variance, between 0 and 1.
binary_icc <- function(y, cluster) {
  n <- length(y); sizes <- table(cluster); k <- length(sizes)
  if (k < 2 || n <= k) return(0)
  fit <- anova(lm(y ~ factor(cluster)))
  between <- fit[1, "Mean Sq"]; within <- fit[2, "Mean Sq"]
  size <- (n - sum(sizes^2) / n) / (k - 1)
  whole <- between + (size - 1) * within
  if (whole > 0) min(1, max(0, (between - within) / whole)) else 0
}

# Trials that are alike within a cluster count as fewer.
design_effect <- function(lost, failed, cluster) {
  sizes <- table(cluster)
  1 + (sum(sizes^2) / length(lost) - 1) * max(binary_icc(lost, cluster), binary_icc(failed, cluster))
}

wilson_of_shares <- function(k, n, level) {
  z <- qnorm((1 + level) / 2); p <- k / n
  (p + z^2 / (2 * n) + c(-1, 1) * z * sqrt(p * (1 - p) / n + z^2 / (4 * n^2))) / (1 + z^2 / n)
}

# Not beaten: no other is as good in both and better in one.
on_front <- function(gain, retained) {
  vapply(seq_along(gain), function(i) {
    known <- !is.na(gain[i]) && !is.na(retained[i])
    beats <- gain >= gain[i] & retained >= retained[i] & (gain > gain[i] | retained > retained[i])
    known && !any(beats, na.rm = TRUE)
  }, logical(1))
}

first_case <- function(rows) rows[!duplicated(rows$trial_id), ]

# The baseline's rate under each lighting, weighted by the metres that the gated algorithm drove there.
standardised_rate <- function(won, led) {
  metres <- tapply(won$length_m, won$lighting, sum)
  own <- sapply(names(metres), function(light) {
    there <- led[led$lighting == light, ]
    rate(there$length_m, there$logged_time_s)
  })
  sum(metres) / sum(metres / own)
}

too_few_clusters <- function(won, led, options) {
  clusters <- if (nzchar(options$cluster)) c(won[[options$cluster]], led[[options$cluster]])
              else c(won$trial_id, led$trial_id)
  length(unique(clusters)) < 10
}

check_baseline <- function(found, rows, options) {
  where <- found$lighting
  one <- first_case(rows)
  gated <- one[one$algorithm == options$gated, ]
  lead <- one[one$algorithm == options$baseline, ]
  won <- gated[gated$success == 1, ]
  led <- lead[lead$success == 1, ]
  ungated <- rate(won$length_m, won$logged_time_s)
  baseline <- rate(led$length_m, led$logged_time_s)
  clusters <- if (nzchar(options$cluster)) c(won[[options$cluster]], led[[options$cluster]])
              else c(won$trial_id, led$trial_id)
  check("h3: trials", where, found$trials, nrow(gated))
  check("h3: successes", where, found$successes, nrow(won))
  check("h3: baseline trials", where, found$baseline_trials, nrow(lead))
  check("h3: baseline successes", where, found$baseline_successes, nrow(led))
  check("h3: clusters", where, found$clusters, length(unique(clusters)))
  check("h3: rate ungated", where, found$ungated_m_per_min, ungated)
  check("h3: rate baseline", where, found$baseline_m_per_min, baseline)
  standardised <- standardised_rate(won, led)
  check("h3: rate baseline standardised", where, found$baseline_standardised_m_per_min, standardised)
  check("h3: gap", where, found$gap_m_per_min, standardised - ungated)
  check("h3: commanded", where, found$speed_cmd_mps, median_or_na(gated$speed_cmd_mps))
  check("h3: baseline commanded", where, found$baseline_speed_cmd_mps,
        median_or_na(lead$speed_cmd_mps))
  check("h3: latency", where, found$loop_latency_ms, median_or_na(gated$loop_latency_ms))
}

#' The numbers of one law and beta; the front needs all of them, so it is left to the caller.
check_case <- function(found, rows, gap, options) {
  where <- paste(found$lighting, found$speed_law, found$beta_per_m)
  gated <- rows[rows$algorithm == options$gated & rows$speed_law == found$speed_law &
                  rows$beta_per_m == found$beta_per_m, ]
  won <- gated[gated$success == 1, ]
  lead <- first_case(rows)
  led <- lead[lead$algorithm == options$baseline & lead$success == 1, ]
  ungated <- rate(won$length_m, won$logged_time_s)
  speed <- rate(won$length_m, won$gated_time_s)
  kept <- sum(won$kept == 1)
  lost <- nrow(won) - kept
  gap_known <- !is.na(gap$low) && (gap$low > 0 || gap$high < 0)
  check("h3: rate gated", where, found$gated_m_per_min, speed)
  check("h3: gain", where, found$gain_m_per_min, speed - ungated)
  check("h3: relative gain", where, found$gain_share, speed / ungated - 1)
  check("h3: share of gap", where, found$gap_recovered,
        if (gap_known) (speed - ungated) / gap$value else NA)
  check("h3: commanded gated", where, found$gated_speed_cmd_mps,
        median_or_na(gated$gated_speed_cmd_mps))
  check("h3: lost", where, found$lost, lost)
  check("h3: share lost", where, found$lost_share, lost / nrow(gated))
  few <- too_few_clusters(won, led, options)
  cluster <- if (nzchar(options$cluster)) gated[[options$cluster]] else gated$trial_id
  effect <- design_effect(as.numeric(gated$success == 1 & gated$kept != 1), as.numeric(gated$success != 1), cluster)
  if (!few) check("h3: design effect", where, found$design_effect, effect)
  bound <- if (few) NA else upper_bound(lost / effect, nrow(gated) / effect, options$level)
  check("h3: bound of loss", where, found$lost_upper, bound)
  check_text("h3: non-inferior", where, found$non_inferior,
             if (few) NA else if (bound < options$loss_margin) "yes" else "no")
  check("h3: retained", where, found$retained, kept / nrow(won))
  ends <- if (few) c(NA, NA) else wilson_of_shares(kept / effect, nrow(won) / effect, options$level)
  check("h3: retained low", where, found$retained_low, ends[1])
  check("h3: retained high", where, found$retained_high, ends[2])
  check("h3: stalls", where, found$stalls, sum(gated$stalls))
  check("h3: trials with stalls", where, found$stalled_trials, sum(gated$stalls > 0))
  data.frame(gain = speed / ungated - 1, retained = kept / nrow(won))
}

# One beta a law, chosen beforehand: what is not drawn at random. `rows` are of one lighting or all.
check_chosen <- function(found, rows, few, options) {
  where <- paste("chosen", found$lighting, found$speed_law)
  gated <- rows[rows$algorithm == options$gated & rows$speed_law == found$speed_law &
                  rows$beta_per_m == options$beta_per_m, ]
  won <- gated[gated$success == 1, ]
  gain_of <- function(part) rate(part$length_m, part$gated_time_s) - rate(part$length_m, part$logged_time_s)
  gain <- gain_of(won)
  cluster <- if (nzchar(options$cluster)) gated[[options$cluster]] else gated$trial_id
  lost <- as.numeric(gated$success == 1 & gated$kept != 1)
  effect <- design_effect(lost, as.numeric(gated$success != 1), cluster)
  n <- nrow(gated) / effect; k <- sum(lost) / effect
  won_cluster <- if (nzchar(options$cluster)) won[[options$cluster]] else won$trial_id
  days <- unique(won_cluster)
  without <- sapply(days, function(day) gain_of(won[won_cluster != day, ]))
  G <- length(days)
  t <- gain / sqrt((G - 1) / G * sum((without - gain)^2))
  check("h3: chosen gain", where, found$gain_m_per_min, gain)
  check("h3: chosen lost", where, found$lost, sum(lost))
  check("h3: chosen bound", where, found$lost_upper, if (few) NA else upper_bound(k, n, options$level))
  p <- if (few) c(NA, NA) else c(pt(t, G - 1, lower.tail = FALSE), pbeta(options$loss_margin, k + 1, n - k, lower.tail = FALSE))
  check("h3: p of gain", where, found$gain_p, p[1], 1e-8)
  check("h3: p of loss", where, found$loss_p, p[2])
  max(p)
}

#' `tcert hypotheses h3 --replays FILE` against R.
check_h3 <- function(tool, file, arguments) {
  answer <- run_json(tool, c("hypotheses", "h3", "--replays", file, arguments))
  options <- answer$summary
  replays <- read.csv(file, check.names = FALSE, comment.char = "#", stringsAsFactors = FALSE)
  replays <- replays[replays$algorithm %in% c(options$gated, options$baseline) &
                       !is.na(replays$success), ]
  for (i in seq_len(nrow(answer$h3_baseline))) {
    group <- answer$h3_baseline[i, ]
    rows <- if (group$lighting == "all") replays else replays[replays$lighting == group$lighting, ]
    check_baseline(group, rows, options)
    gap <- list(value = group$gap_m_per_min, low = group$gap_m_per_min_low,
                high = group$gap_m_per_min_high)
    cases <- answer$h3[answer$h3$lighting == group$lighting, ]
    seen <- unique(rows[rows$algorithm == options$gated, c("speed_law", "beta_per_m")])
    check("h3: laws and betas", group$lighting, nrow(cases), nrow(seen))
    points <- do.call(rbind, lapply(seq_len(nrow(cases)), function(k) {
      check_case(cases[k, ], rows, gap, options)
    }))
    check_text("h3: front", group$lighting, cases$on_front,
               ifelse(on_front(points$gain, points$retained), "yes", "no"))
  }
  if (!is.na(options$beta_per_m)) {
    chosen <- answer$h3_chosen
    p <- sapply(seq_len(nrow(chosen)), function(i) {
      one <- chosen[i, ]
      group <- answer$h3_baseline[answer$h3_baseline$lighting == one$lighting, ]
      rows <- if (one$lighting == "all") replays else replays[replays$lighting == one$lighting, ]
      check_chosen(one, rows, group$clusters < 10 || group$successes < 10, options)
    })
    for (together in c(TRUE, FALSE)) {
      family <- (chosen$lighting == "all") == together
      check("h3: Holm", if (together) "laws" else "laws and lightings", chosen$holm[family], p.adjust(p[family], "holm"), 1e-8)
    }
  }
  report()
}
