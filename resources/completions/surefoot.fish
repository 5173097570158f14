# SPDX-License-Identifier: GPL-3.0-or-later
# Completion for fish: the program itself says what may stand there (`surefoot complete WORD…`).

function __surefoot_complete
    set -l words (commandline -opc) (commandline -ct)
    for line in ($words[1] complete $words[2..-1] 2>/dev/null)
        switch $line
            case ':files'
                __fish_complete_path (commandline -ct)
            case ':files *'
                set -l endings (string join '|' (string split ' ' (string replace ':files ' '' -- $line)))
                __fish_complete_path (commandline -ct) | string match -r "^[^\t]*(?:/|\.(?:$endings))(?:\t.*)?\$"
            case ':folders'
                __fish_complete_directories (commandline -ct)
            case '*'
                echo $line
        end
    end
end

complete -c surefoot -f -a '(__surefoot_complete)'
