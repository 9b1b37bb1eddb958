using System.Text.RegularExpressions;

namespace ErrorMatching.EndToEnd.Tests;

/// <summary>
/// The commands of a page: the lines behind <c>$</c> in its console blocks, each with the output that the page shows below it.
/// A comment <c># exit 2</c> behind a command says that it ends so; a line <c>...</c> stands for output that the page leaves out.
/// </summary>
internal sealed partial record DocumentedCommand(string Line, int Exit, IReadOnlyList<string> Shown)
{
    private const string LeftOut = "...";

    /// <summary>What is typed where a page shows that a password is asked for:
    /// one for each name, the second time it is typed left out.</summary>
    public IReadOnlyList<string> Typed => [
        .. Shown.Select(l => Question().Match(l))
            .Where(m => m.Success && !m.Groups["again"].Success)
            .Select(m => m.Groups["pin"].Success ? "502817" : "a long password of " + m.Groups["name"].Value)];

    /// <summary>What the page shows besides those questions.</summary>
    public IReadOnlyList<string> Printed => [.. Shown.Where(l => !Question().IsMatch(l))];

    public static IReadOnlyList<DocumentedCommand> Of(string page)
    {
        var commands = new List<DocumentedCommand>();
        foreach (Match block in ConsoleBlock().Matches(page))
        {
            foreach (var line in block.Groups["lines"].Value.Split('\n'))
            {
                if (line.StartsWith("$ ", StringComparison.Ordinal))
                {
                    var exit = ExitComment().Match(line);
                    commands.Add(new(
                        (exit.Success ? line[2..exit.Index] : line[2..]).Trim(),
                        exit.Success ? int.Parse(exit.Groups["code"].Value, System.Globalization.CultureInfo.InvariantCulture) : 0,
                        []));
                }
                else if (line.Trim() is { Length: > 0 } shown && shown != LeftOut)
                {
                    commands[^1] = commands[^1] with { Shown = [.. commands[^1].Shown, shown] };
                }
            }
        }

        return commands;
    }

    [GeneratedRegex(
        "^((New p|P)assword|New (?<pin>PIN)|Badge) (of|at) (?<name>\\S+)(?<again> again)?:$", RegexOptions.ExplicitCapture, 1000)]
    private static partial Regex Question();

    [GeneratedRegex("```console\n(?<lines>.*?)```", RegexOptions.Singleline | RegexOptions.ExplicitCapture, 1000)]
    private static partial Regex ConsoleBlock();

    [GeneratedRegex(" # exit (?<code>[0-9]+)$", RegexOptions.ExplicitCapture, 1000)]
    private static partial Regex ExitComment();
}
