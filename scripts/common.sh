# shellcheck shell=bash
# What the scripts share; sourced by them, after which the working directory is the top of the repository.

cd "$(dirname "${BASH_SOURCE[0]}")/.."

say() {
  printf '\n== %s\n' "$*"
}

# print_usage SCRIPT: the comment at the top of a script.
print_usage() {
  sed -n '2,/^[^#]/ s/^# \{0,1\}//p' "$1"
}

# configure PRESET [CMAKE_ARGUMENT...]: PCL's many messages are shown only when something is wrong.
configure() {
  say "Configuring $1"
  local messages
  if ! messages=$(cmake --preset "$@" 2>&1); then
    echo "$messages" >&2
    return 1
  fi
}
