# Reads what `palpate export --as csv` wrote, as a script of a study would, and writes what the round trip needs:
#   Rscript read_export.R EXPORTED OUT
# OUT/cells.csv: cell, correct, trials; OUT/differences.csv: for each examinee, the proportion correct in the first
# cell less that in the last.
folders <- commandArgs(trailingOnly = TRUE)
table_of <- function(name) {
  codebook <- read.csv(file.path(folders[1], "codebook.csv"), na.strings = "n/a")
  codebook <- codebook[codebook$table == name, ]
  data <- read.csv(file.path(folders[1], paste0(name, ".csv")), na.strings = "n/a")
  stopifnot(names(data) == codebook$column)
  for (i in seq_len(nrow(codebook))) {
    column <- data[[codebook$column[i]]]
    if (grepl("number", codebook$kind[i])) stopifnot(is.numeric(column) || all(is.na(column)))
    if (codebook$may_be_missing[i] == 0) stopifnot(!anyNA(column))
    if (!is.na(codebook$minimum[i])) stopifnot(column[!is.na(column)] >= as.numeric(codebook$minimum[i]))
  }
  data
}
trials <- table_of("trials")
intervals <- table_of("intervals")
key <- c("participant_id", "session_id", "trial")
stopifnot(nrow(merge(trials, intervals, by = key)) == 2 * nrow(trials))

counted <- trials[trials$voided == 0, ]
cells <- aggregate(correct ~ contact_model, counted, sum)
cells$trials <- aggregate(correct ~ contact_model, counted, length)$correct
names(cells)[1] <- "cell"
write.csv(cells, file.path(folders[2], "cells.csv"), row.names = FALSE, quote = FALSE)
share <- tapply(counted$correct, counted[c("participant_id", "contact_model")], mean)
write.csv(data.frame(difference = share[, 1] - share[, ncol(share)]),
          file.path(folders[2], "differences.csv"), row.names = FALSE)
