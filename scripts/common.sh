# shellcheck shell=bash
# What the scripts share; sourced by them, after which the working directory is the top of the repository.

cd "$(realpath "$(dirname "${BASH_SOURCE[0]}")")/.." || exit

say() {
  printf '\n== %s\n' "$*"
}

# print_usage: the comment at the top of the script that runs.
print_usage() {
  sed -n '2,/^[^#]/ s/^# \{0,1\}//p' "scripts/$(basename "$0")"
}

# help_if_asked ARGUMENT...: print the usage and end where the first argument is -h or --help.
help_if_asked() {
  if [[ ${1:-} == -h || ${1:-} == --help ]]; then
    print_usage
    exit 0
  fi
}

# configure PRESET [CMAKE_ARGUMENT...]: what PCL's package has to say is shown only when something is wrong.
configure() {
  say "Configuring $1"
  local messages
  if ! messages=$(cmake --preset "$@" 2>&1); then
    echo "$messages" >&2
    return 1
  fi
}
