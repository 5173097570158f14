# SPDX-License-Identifier: GPL-3.0-or-later
# Completion for bash: the program itself says what may stand there (`surefoot complete WORD…`).

_surefoot() {
  local words=() word i glue=
  # Bash takes "key=value" and "3:key" apart where COMP_WORDBREAKS says; here they are one word again.
  for ((i = 1; i <= COMP_CWORD; i++)); do
    word=${COMP_WORDS[i]}
    if [[ ${#words[@]} -gt 0 && ($glue || $word == [=:]) ]]; then
      words[-1]+=$word
    else
      words+=("$word")
    fi
    [[ $word == [=:] ]] && glue=1 || glue=
  done
  local written=${words[-1]} line found=()
  written=${written#[\"\']}
  written=${written//\\/}
  words[-1]=$written
  local breaks=${written##*[=:]}
  local before=${written%"$breaks"}  # what Bash leaves in place
  [[ $COMP_WORDBREAKS == *=* && $COMP_WORDBREAKS == *:* ]] || before=

  COMPREPLY=()
  while IFS= read -r line; do
    case $line in
      :files*)
        compopt -o filenames 2>/dev/null
        while IFS= read -r word; do
          if [[ -d $word || $line == :files ]]; then
            found+=("$word")
          else
            for i in ${line#:files }; do [[ $word == *."$i" ]] && found+=("$word") && break; done
          fi
        done < <(compgen -f -- "$written")
        ;;
      :folders)
        compopt -o filenames 2>/dev/null
        while IFS= read -r word; do found+=("$word"); done < <(compgen -d -- "$written")
        ;;
      *)
        word=${line%%$'\t'*}
        [[ $word == *= ]] && compopt -o nospace 2>/dev/null
        found+=("${word#"$before"}")
        ;;
    esac
  done < <("${COMP_WORDS[0]}" complete "${words[@]}" 2>/dev/null)
  COMPREPLY=("${found[@]}")
}

complete -F _surefoot surefoot
