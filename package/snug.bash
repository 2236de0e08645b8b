# Completes snug's arguments in bash. Commands, options and cars are those the command itself lists.
_snug() {
    local snug=${COMP_WORDS[0]} command=${COMP_WORDS[1]} before=${COMP_WORDS[COMP_CWORD - 1]} word=${COMP_WORDS[COMP_CWORD]}
    local option='^  ([^ ]+)( [^ ]+)?  ' line words= kind= below  # a line of help: "  -o,--output FILE   what it is"

    commands() { "$snug" $1 --help 2>/dev/null | sed -n '/^Commands:/,/^$/s/^  \([a-z-]*\) .*/\1/p'; }
    if ((COMP_CWORD > 1)) && below=$(commands "$command") && [[ $below ]]; then
        ((COMP_CWORD > 2)) && command+=" ${COMP_WORDS[2]}"
    else
        below=
    fi
    if ((COMP_CWORD == 1)); then
        words="--help --version $(commands)"
    elif ((COMP_CWORD == 2)) && [[ $below ]]; then
        words="--help $below"
    else
        while IFS= read -r line; do
            [[ $line =~ $option ]] || continue
            words+=" ${BASH_REMATCH[1]##*,}"
            [[ ,${BASH_REMATCH[1]}, == *,"$before",* ]] && kind=${BASH_REMATCH[2]# }
        done <<<"$("$snug" $command --help 2>/dev/null | grep '^  -')"
        [[ $command == cars && $before != -* && $word != -* ]] && kind='NAME|FILE'
    fi
    case $command:$kind in
        *:SIDE) words='right left' ;;
        *:HOW) words='backward forward' ;;
        *:WHEN) words='contact inside' ;;
        park:VIEW) words='maneuver map' ;;
        *:VIEW) words='maneuver entries' ;;
        *:CURB) words='high low' ;;
        *:STEER) words='standing' ;;
        *:LOOK) words='again once' ;;
        leave:FORMAT | 'atlas query:FORMAT') words='text json' ;;
        *:FORMAT) words='text json csv' ;;
        'atlas build:NAME') words='max-steer fewest' ;;
        min-slot:NAME) words='max-steer fewest stepping' ;;
        *:NAME) words='max-steer fewest stepping reversed-trials parallel-trials' ;;
        *:CARS) words="all $("$snug" cars --format csv | sed '1d;s/,.*//')" ;;
        *:NAME\|FILE) words=$("$snug" cars --format csv | sed '1d;s/,.*//') ;;
        *:) ;;
        *) words= ;;  # a file, or a number that nobody else can know
    esac
    COMPREPLY=($(compgen -W "$words" -- "$word"))
    case $kind in
        *FILE | CARS) compopt -o default ;;
        DIR) compopt -o dirnames ;;
    esac 2>/dev/null
}
complete -F _snug snug
