# Rscript glmm_bench.R FOLDER: fits with lme4 what glmm_bench fitted, from the answers and the times that it left in
# FOLDER, and prints both times and their ratio. Both go from the single answers to estimates and standard errors.
suppressMessages(library(lme4))
folder <- commandArgs(trailingOnly = TRUE)[1]
lines <- readLines(file.path(folder, "glmm_bench.csv"))
ours <- read.csv(text = lines[grep("^name,", lines):length(lines)])

fit <- function(data, link, random, nodes) {
  formula <- if (random == "slope") response ~ level + (1 + level | examinee) else response ~ level + (1 | examinee)
  glmer(formula, data, binomial(link), nAGQ = nodes)
}

cat(sprintf("lme4 %s; 30 examinees x 200 trials; median of 3 for lme4\n", packageVersion("lme4")))
cat(sprintf("%-28s %9s %9s %7s %9s %9s %9s %9s\n", "design/link/random/nodes", "ours ms", "lme4 ms", "ratio", "slope", "lme4", "error", "lme4"))
worst <- Inf
for (i in seq_len(nrow(ours))) {
  part <- strsplit(ours$name[i], "/")[[1]]
  data <- read.csv(file.path(folder, paste0(part[1], ".csv")))
  suppressWarnings(suppressMessages({
    times <- replicate(3, system.time(model <<- fit(data, part[2], part[3], as.integer(part[4])))[["elapsed"]])
  }))
  ratio <- 1000 * median(times) / ours$real_time[i]
  worst <- min(worst, ratio)
  cat(sprintf("%-28s %9.2f %9.0f %7.0f %9.5f %9.5f %9.5f %9.5f\n", ours$name[i], ours$real_time[i], 1000 * median(times),
              ratio, ours$slope[i], fixef(model)[2],
              ours$standard_error[i], sqrt(vcov(model)[2, 2])))
}
cat(sprintf("least ratio: %.0f (aim: 10)\n", worst))
