namespace ErrorMatching.Console;

/// <summary>Scripts that ask the console itself which words may follow, so that they fit each version of it. Options are offered to whom
/// types a dash. Where the console knows no other word, the shell completes names of files as ever.</summary>
internal static class CompletionScript
{
    /// <summary>The shells, by the names of their programs.</summary>
    public static IReadOnlyList<string> Shells { get; } = ["bash", "zsh", "pwsh"];

    /// <summary>The script of a shell.</summary>
    /// <param name="shell">One of <see cref="Shells"/>.</param>
    public static string Of(string shell) => shell switch
    {
        "bash" => """
            _errormatch() {
                local words
                words=$("${COMP_WORDS[0]}" "[suggest:${COMP_POINT}]" "${COMP_LINE}" 2>/dev/null)
                case ${COMP_WORDS[COMP_CWORD]} in -*) ;; *) words=$(grep -v '^[-/]' <<<"$words") ;; esac
                mapfile -t COMPREPLY < <(compgen -W "$words" -- "${COMP_WORDS[COMP_CWORD]}")
            }
            complete -o default -F _errormatch errormatch

            """,
        "zsh" => """
            #compdef errormatch
            _errormatch() {
                local -a found
                found=("${(@f)$("${words[1]}" "[suggest:${CURSOR}]" "${BUFFER}" 2>/dev/null)}")
                [[ ${words[CURRENT]} == -* ]] || found=(${found:#[-/]*})
                compadd -- ${found:#} || _files
            }
            # Found in fpath, this file is the function's first call; evaluated, it only says whom the function completes.
            if [ "${funcstack[1]}" = _errormatch ]; then _errormatch "$@"; else compdef _errormatch errormatch; fi

            """,
        "pwsh" => """
            Register-ArgumentCompleter -Native -CommandName errormatch -ScriptBlock {
                param($word, $line, $position)
                errormatch "[suggest:$position]" "$line" 2>$null | Where-Object { $_ -like "$word*" -and ("$word" -like '-*' -or $_ -notmatch '^[-/]') } |
                    ForEach-Object { [System.Management.Automation.CompletionResult]::new($_, $_, 'ParameterValue', $_) }
            }

            """,
        _ => throw new ArgumentOutOfRangeException(nameof(shell), shell, "No such shell.")
    };
}
