using System.Text.RegularExpressions;

namespace ErrorMatching.EndToEnd.Tests;

/// <summary>
/// The commands of a page: the lines behind <c>$</c> in its console blocks, each with the output that the page shows below it. A comment <c># exit 2</c> behind a command says
/// that it ends so; a line <c>...</c> stands for output that the page leaves out.
/// </summary>
internal sealed partial record DocumentedCommand(string Line, int Exit, IReadOnlyList<string> Shown)
{
    private const string LeftOut = "...";

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

    [GeneratedRegex("```console\n(?<lines>.*?)```", RegexOptions.Singleline | RegexOptions.ExplicitCapture, 1000)]
    private static partial Regex ConsoleBlock();

    [GeneratedRegex(" # exit (?<code>[0-9]+)$", RegexOptions.ExplicitCapture, 1000)]
    private static partial Regex ExitComment();
}
