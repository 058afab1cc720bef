# The refits of psychometric_bench.cpp by R's optim: 2AFC, six levels, 50 trials each, logistic function with
# threshold, slope and lapse rate free (0 to 0.05), replicates drawn from the fitted function.
# Rscript psychometric.R [replicates] prints the processor seconds for 10 000 refits by each of two methods.
arguments <- commandArgs(trailingOnly = TRUE)
replicates <- if (length(arguments) > 0) as.integer(arguments[1]) else 10000L
level <- c(0, 2, 4, 6, 8, 10)
trials <- rep(50, 6)
truth <- c(3.805934, log(1 / 1.093090), 0.009358)

psi <- function(p) 0.5 + (0.5 - p[3]) * plogis(exp(p[2]) * (level - p[1]))
loss <- function(p, correct) {
  if (p[3] < 0 || p[3] > 0.05) return(1e10)
  value <- -sum(dbinom(correct, trials, psi(p), log = TRUE))
  if (is.finite(value)) value else 1e10
}
refit <- list(
  "Nelder-Mead" = function(correct) optim(truth, loss, correct = correct),
  "L-BFGS-B" = function(correct) {
    optim(truth, loss, correct = correct, method = "L-BFGS-B", lower = c(-20, -6, 0), upper = c(30, 4, 0.05))
  }
)

set.seed(1)
answers <- matrix(rbinom(6 * replicates, trials, psi(truth)), nrow = 6)
for (method in names(refit)) {
  seconds <- system.time(for (i in seq_len(replicates)) refit[[method]](answers[, i]))[["user.self"]]
  cat(method, sprintf("%.4f\n", seconds * 10000 / replicates))
}
