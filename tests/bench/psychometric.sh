#!/bin/sh
# psychometric.sh BENCHMARK: 10 000 refits by R's optim, by palpate, and the ratio, in one run.
set -eu
here=$(dirname "$0")
r=$(Rscript "$here/psychometric.R")
ours=$("$1" --benchmark_filter=refits/logistic --benchmark_repetitions=5 --benchmark_report_aggregates_only=true \
  --benchmark_format=csv 2>/dev/null | awk -F, '/_median/ { print $4 / 1000 }')
echo "Processor time of 10 000 refits, 6 levels, logistic; threshold, slope and lapse free"
printf 'palpate            %8.3f s\n' "$ours"
echo "$r" | while read -r method seconds; do
  awk -v method="$method" -v r="$seconds" -v ours="$ours" \
    'BEGIN { printf "R optim %-11s%8.3f s, %.0f times as long\n", method, r, r / ours }'
done
