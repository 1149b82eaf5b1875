# bash completion for sensobot. SPDX-License-Identifier: MIT
_sensobot() {
  local word=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD - 1]} command='' options='' each
  for each in "${COMP_WORDS[@]:1:COMP_CWORD-1}"; do
    case $each in calibrate | check | monitor | run | replay | show) command=$each && break ;; esac
  done
  case $before in
    --out) mapfile -t COMPREPLY < <(compgen -d -- "$word") && return ;;
    --devices | --journal) mapfile -t COMPREPLY < <(compgen -f -- "$word") && return ;;
    --rate | --turns | --tags | --wait | --patience | --seconds) return ;;
  esac
  case $command in
    '') mapfile -t COMPREPLY < <(compgen -W 'calibrate check monitor run replay show --help --version' -- "$word") && return ;;
    run) options='--devices --out --force --journal --no-journal --monitor --rate --wait --patience --json --quiet --help' ;;
    monitor) options='--at --help' ;;
    check) options='--devices --seconds --json --help' ;;
    calibrate) options='--devices --turns --tags --rate --json --help' ;;
    show) options='--devices --help' ;;
    replay) options='--json --help' ;;
  esac
  if [[ $word == -* ]]; then
    mapfile -t COMPREPLY < <(compgen -W "$options" -- "$word")
  else
    mapfile -t COMPREPLY < <(compgen -f -- "$word")
  fi
}
complete -o filenames -F _sensobot sensobot
