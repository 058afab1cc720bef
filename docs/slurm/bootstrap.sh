#!/bin/sh
# Bootstrap of a psychometric function in as many parts as the array has tasks, on a Slurm cluster:
#
#   mkdir -p parts
#   REPLICATES=100000 SEED=1 sbatch --array=1-20 docs/slurm/bootstrap.sh answers.csv --guess 1/2 --shape weibull
#   palpate stats merge parts/*.json
#
# What stands behind the file is handed on to palpate stats psychometric. See power.sh for the rest.
#SBATCH --job-name=palpate-bootstrap
#SBATCH --output=parts/slurm-%A_%a.log
#SBATCH --cpus-per-task=1
set -eu

parts=${PARTS:-parts}
part=$SLURM_ARRAY_TASK_ID
mkdir -p "$parts"
"${PALPATE:-./palpate}" stats psychometric "$@" --intervals bootstrap --replicates "${REPLICATES:-100000}" \
  --seed "${SEED:-1}" --shard "$part/$SLURM_ARRAY_TASK_COUNT" --format json >"$parts/.$part.json"
mv "$parts/.$part.json" "$parts/part-$part.json"
