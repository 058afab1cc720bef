#!/bin/sh
# Power of a protocol by playing whole studies, in as many parts as the array has tasks, on a Slurm cluster:
#
#   mkdir -p parts
#   STUDIES=1000 SEED=1 sbatch --array=1-50 docs/slurm/power.sh protocols/kuroda2003.toml
#   palpate stats merge parts/*.json        # when all are done: the same bits as one run gives
#
# Part K of N depends on the seed and on K alone, so a part that failed is simply run again. Where palpate is: PALPATE,
# else ./palpate of the folder that sbatch was called in; build it once before, on a machine like the nodes.
#SBATCH --job-name=palpate-power
#SBATCH --output=parts/slurm-%A_%a.log
#SBATCH --cpus-per-task=1
set -eu

protocol=$1
parts=${PARTS:-parts}
part=$SLURM_ARRAY_TASK_ID
mkdir -p "$parts"

# Written aside and renamed: what has the name of a part is whole.
"${PALPATE:-./palpate}" plan "$protocol" --studies "${STUDIES:-1000}" --seed "${SEED:-1}" \
  --shard "$part/$SLURM_ARRAY_TASK_COUNT" --format json >"$parts/.$part.json"
mv "$parts/.$part.json" "$parts/part-$part.json"
