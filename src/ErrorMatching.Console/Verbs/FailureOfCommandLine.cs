using System.CommandLine;
using System.CommandLine.Parsing;
using ErrorMatching.Refusals;

namespace ErrorMatching.Console;

/// <summary>What is wrong with a command line, with the word that was probably meant.</summary>
internal static class FailureOfCommandLine
{
    // Two letters begin too many words.
    private const int Shortest = 3;

    /// <summary>Judges a parsed command line; null if nothing is wrong with it.</summary>
    public static Failure? Of(ParseResult parsed)
    {
        string[] messages = [.. Messages(parsed)];
        return messages.Length == 0
            ? null
            : new(
                ExitCode.WrongInput,
                [.. messages.Select(m => new Refusal("command-line", $"{OneLine(m)} See {CommandLineOf(parsed)} --help."))]);
    }

    /// <summary>The known word that was probably meant; null if none is near.</summary>
    /// <param name="word">The unknown word.</param>
    /// <param name="known">The known ones.</param>
    public static string? Nearest(string word, IEnumerable<string> known)
    {
        var most = Math.Max(1, word.Trim('-').Length / 3);
        string[] words = [.. known];
        return words.Select(k => (Word: k, Edits: Edits(word, k))).Where(k => k.Edits <= most).OrderBy(k => k.Edits).FirstOrDefault().Word
            ?? words.Where(k => BeginsAs(word, k)).OrderByDescending(k => k.Length).FirstOrDefault();
    }

    // --prog for --program, --output and --ouput for --out: one word is the beginning of the other, but for one letter.
    private static bool BeginsAs(string word, string known)
    {
        var (shorter, longer) = word.Length < known.Length ? (word, known) : (known, word);
        return shorter.Trim('-').Length >= Shortest && shorter.StartsWith("--", StringComparison.Ordinal)
            && Enumerable.Range(shorter.Length - 1, 3).Any(n => n <= longer.Length && Edits(shorter, longer[..n]) <= 1);
    }

    private static IEnumerable<string> Messages(ParseResult parsed)
    {
        var command = parsed.CommandResult.Command;
        if (command is not Verb && parsed.UnmatchedTokens is [var first, ..])
        {
            // A word that is no command makes all words after it unknown, too.
            string[] known = first.StartsWith('-') ? OptionsOf(parsed) : [.. command.Subcommands.Select(c => c.Name)];
            return [$"Unrecognized command or argument '{first}'.{Hint(first, known)}"];
        }

        if (DashesOf(parsed) > 1)
        {
            return [$"{StandardInput.Dash} names {StandardInput.Name} more than once, which can be read once. Name files for the others."];
        }

        // An option that does not exist passes for an argument, and the argument itself for one too many.
        return OptionTaken(parsed) is { } option
            ? [$"Unrecognized command or argument '{option}'.{Hint(option, OptionsOf(parsed))}"]
            : parsed.Errors.Select(e => e.Message);
    }

    // The first argument that looks like an option. After "--", a file may be named like one.
    private static string? OptionTaken(ParseResult parsed) => parsed.Tokens.Any(t => t.Type == TokenType.DoubleDash)
        ? null
        : parsed.CommandResult.Children.OfType<ArgumentResult>().SelectMany(a => a.Tokens).Select(t => t.Value)
            .Concat(parsed.UnmatchedTokens)
            .FirstOrDefault(t => t.StartsWith("--", StringComparison.Ordinal) && t.Length > 2);

    // How often standard input is named: by arguments and by options that name an input.
    private static int DashesOf(ParseResult parsed) => parsed.CommandResult.Children
        .Where(c => c is not OptionResult { Option.Name: "--out" })
        .SelectMany(c => c.Tokens)
        .Count(t => t.Value == StandardInput.Dash);

    private static string[] OptionsOf(ParseResult parsed)
    {
        var names = parsed.CommandResult.Command.Options.Select(o => o.Name).ToList();
        for (var at = parsed.CommandResult.Parent; at is CommandResult { Command: var above }; at = at.Parent)
        {
            names.AddRange(above.Options.Where(o => o.Recursive).Select(o => o.Name));
        }

        return [.. names];
    }

    private static string Hint(string word, IEnumerable<string> known) =>
        Nearest(word, known) is { } meant ? $" Did you mean {meant}?" : "";

    // Letters added, left out, replaced, or swapped with the next one (the distance of Damerau and Levenshtein, each place edited once).
    private static int Edits(string word, string other)
    {
        var edits = new int[word.Length + 1, other.Length + 1];
        for (var i = 0; i <= word.Length; i++)
        {
            for (var j = 0; j <= other.Length; j++)
            {
                if (i == 0 || j == 0)
                {
                    edits[i, j] = i + j;
                    continue;
                }

                var change = word[i - 1] == other[j - 1] ? 0 : 1;
                edits[i, j] = Math.Min(Math.Min(edits[i - 1, j], edits[i, j - 1]) + 1, edits[i - 1, j - 1] + change);
                if (i > 1 && j > 1 && word[i - 1] == other[j - 2] && word[i - 2] == other[j - 1])
                {
                    edits[i, j] = Math.Min(edits[i, j], edits[i - 2, j - 2] + 1);
                }
            }
        }

        return edits[word.Length, other.Length];
    }

    private static string OneLine(string message) =>
        string.Join(' ', message.Split(default(char[]), StringSplitOptions.RemoveEmptyEntries)) is var line && line.EndsWith('?')
            ? line
            : line.TrimEnd('.') + ".";

    private static string CommandLineOf(ParseResult parsed)
    {
        var words = new Stack<string>();
        for (Symbol symbol = parsed.CommandResult.Command; symbol is not RootCommand; symbol = symbol.Parents.First())
        {
            words.Push(symbol.Name);
        }

        return string.Join(' ', words.Prepend("errormatch"));
    }
}
