#!/bin/bash
# Builds the fuzz targets in the layout of OSS-Fuzz: $OUT/fuzz_NAME, its dictionary, its seed corpus as a zip archive, and
# the shared libraries that the programs need, in $OUT/lib.
#   fuzz/oss-fuzz/build.sh [NAME...]     without names: all targets
# OSS-Fuzz sets SRC, WORK, OUT, CC, CXX, CFLAGS, CXXFLAGS and LIB_FUZZING_ENGINE. The defaults are those of the preset
# `fuzz`, so the script needs no network and no image: OUT=/tmp/out fuzz/oss-fuzz/build.sh
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
if [ -d "${SRC:-}/pardel" ]; then source=$SRC/pardel; else source=$(cd "$here/../.." && pwd); fi
: "${OUT:=$source/build/oss-fuzz/out}" "${WORK:=$source/build/oss-fuzz}"
: "${CC:=clang-14}" "${CXX:=clang++-14}" "${CFLAGS:=}" "${LIB_FUZZING_ENGINE:=-fsanitize=fuzzer}"
: "${CXXFLAGS:=-O1 -g1 -fsanitize=fuzzer-no-link,address,undefined -fno-sanitize-recover=all -fno-omit-frame-pointer}"
export CC CXX CFLAGS CXXFLAGS
mkdir -p "$OUT/lib" "$WORK"

# CXXFLAGS has all options of optimisation, so the build type adds none.
cmake -S "$source" -B "$WORK/build" -G Ninja -DCMAKE_BUILD_TYPE=None -DPARDEL_BUILD_PROGRAM=OFF \
  -DPARDEL_BUILD_TESTS=OFF -DPARDEL_BUILD_FUZZ=ON "-DPARDEL_FUZZ_ENGINE=$LIB_FUZZING_ENGINE" \
  "-DCMAKE_EXE_LINKER_FLAGS=-Wl,-rpath,'\$ORIGIN/lib'"

if [ $# -gt 0 ]; then names=$*; else names=$(cut -d' ' -f1 "$WORK/build/fuzz/targets"); fi
programs=()
for name in $names; do programs+=("fuzz_$name"); done
cmake --build "$WORK/build" --target "${programs[@]}"

for name in $names; do
  program=$WORK/build/fuzz/fuzz_$name
  cp "$program" "$OUT/"
  if [ -f "$source/fuzz/dictionaries/$name.dict" ]; then
    cp "$source/fuzz/dictionaries/$name.dict" "$OUT/fuzz_$name.dict"
  fi
  if [ -d "$source/fuzz/corpus/$name" ]; then
    python3 -m zipfile -c "$OUT/fuzz_${name}_seed_corpus.zip" "$source/fuzz/corpus/$name"/*
  fi
  # The image in which the programs run has only the C and C++ libraries.
  ldd "$program" | awk '$3 ~ /lib(omp|gmp|gmpxx|mpfr|fmt|z)[.-]/ { print $3 }' | xargs -r cp -L -t "$OUT/lib"
done
