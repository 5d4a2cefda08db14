# SPDX-License-Identifier: MIT
# Completion for bash: verbs and options are read from the program's own help, so that they are never others.
_similitude() {
    local program=${COMP_WORDS[0]} word=${COMP_WORDS[COMP_CWORD]} path=() k
    COMPREPLY=()
    # The verb, and for `convert` what is converted.
    for ((k = 1; k < COMP_CWORD; ++k)); do
        [[ ${COMP_WORDS[k]} == -* || ${#path[@]} -ge 2 ]] && continue
        [[ ${#path[@]} -eq 1 && ${path[0]} != convert ]] && continue
        path+=("${COMP_WORDS[k]}")
    done
    local help
    help=$("$program" "${path[@]}" --help 2>/dev/null) || return
    if [[ $word == -* ]]; then
        mapfile -t COMPREPLY < <(compgen -W "$(grep -oE -- '--[a-z][a-z-]*' <<<"$help" | sort -u)" -- "$word")
    elif [[ ${#path[@]} -eq 0 || (${#path[@]} -eq 1 && ${path[0]} == convert) ]]; then
        mapfile -t COMPREPLY < <(compgen -W "$(sed -n '/^Subcommands:/,/^$/s/^  \([a-z]*\) .*/\1/p' <<<"$help")" -- "$word")
    else
        mapfile -t COMPREPLY < <(compgen -f -- "$word")
    fi
}
complete -o filenames -F _similitude similitude
