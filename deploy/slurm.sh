#!/bin/sh
# A campaign as a job array, without any server: `sbatch --array=0-99%20 deploy/slurm.sh campaign.toml 1000`.
# Each task runs as many scenarios as the second word says, and leaves its part of the result. At the end:
# `sieben campaign merge part-*.parquet -o result.parquet`.
set -eu
spec=$1
size=$2
first=$((SLURM_ARRAY_TASK_ID * size))
last=$((first + size - 1))
exec sieben campaign run "$spec" --only "$first..$last" --out "part-$SLURM_ARRAY_TASK_ID.parquet" --resume --quiet
