using System.CommandLine;

namespace ErrorMatching.Console.Tests;

/// <summary>Who types too little, or asks for help in another way, gets the help that was meant.</summary>
public sealed class HelpTests
{
    [Theory]
    [InlineData("")]
    [InlineData("nc")]
    [InlineData("surface")]
    [InlineData("cell")]
    public void What_is_only_begun_shows_its_help_and_tells_a_script_that_nothing_was_done(string words)
    {
        string[] line = words.Split(' ', StringSplitOptions.RemoveEmptyEntries);
        var help = Shell.Run([.. line, "--help"]);
        Assert.Equal((0, ""), (help.Exit, help.Error));
        var begun = Shell.Run(line);
        Assert.Equal((1, ""), (begun.Exit, begun.Output));
        Assert.StartsWith("errormatch: ", begun.Error, StringComparison.Ordinal);
        Assert.EndsWith("\n" + help.Output, begun.Error, StringComparison.Ordinal);
        Assert.Equal("command-line", Shell.Error(1, line).GetProperty("code").GetString());
    }

    [Theory]
    [InlineData("help", "")]
    [InlineData("help match", "match")]
    [InlineData("help nc", "nc")]
    [InlineData("help nc check", "nc check")]
    [InlineData("nc help check", "nc check")]
    [InlineData("nc help", "nc")]
    public void Help_of_a_command_is_what_its_option_prints(string words, string command)
    {
        var help = Shell.Run([.. command.Split(' ', StringSplitOptions.RemoveEmptyEntries), "--help"]);
        Assert.Contains("Usage:", help.Output, StringComparison.Ordinal);
        Assert.Equal((0, help.Output, ""), Shell.Run(words.Split(' ')));
    }

    [Theory]
    [InlineData("help mtch", "Did you mean match?")]
    [InlineData("help nc chek", "Did you mean check?")]
    [InlineData("match job.json --ouput o", "Did you mean --out?")]
    [InlineData("match job.json --output o", "Did you mean --out?")]
    [InlineData("match job.json --prog p", "Did you mean --program?")]
    [InlineData("match job.json --measured p", "'--measured'.")]
    [InlineData("nc check p --dialct fanuc", "Did you mean --dialect?")]
    [InlineData("fit polynomial p.csv --deg 3", "Did you mean --degree?")]
    public void A_slip_gets_its_suggestion(string words, string said)
    {
        var run = Shell.Run(words.Split(' '));
        Assert.Equal((1, ""), (run.Exit, run.Output));
        Assert.Contains(said, run.Error, StringComparison.Ordinal);
    }

    [Theory]
    [InlineData("nc check p.nc --dialect ", "fanuc heidenhain-klartext siemens-840d")]
    [InlineData("nc dialects ", "fanuc grbl")]
    [InlineData("nc diff a b --dialect si", "siemens-840d")]
    [InlineData("job new ", "cell freeform mating")]
    [InlineData("job schema ", "cell freeform mating")]
    [InlineData("user add c n --role ", "administrator operator setter")]
    [InlineData("cell history c --state ver", "verified")]
    [InlineData("surface fit p.csv --method ", "best tensor")]
    [InlineData("surface toolpath j --stage ", "roughing")]
    [InlineData("fit line p --method ", "ols tls")]
    [InlineData("fit polynomial p --degree ", "auto")]
    [InlineData("nc check p --block-skip ", "off on")]
    [InlineData("help ", "match nc")]
    [InlineData("help nc ", "check diff")]
    [InlineData("completion ", "bash zsh")]
    public void Values_are_completed(string line, string values)
    {
        var text = "errormatch " + line;
        var run = Shell.Run($"[suggest:{text.Length}]", text);
        Assert.Equal(0, run.Exit);
        Assert.Empty(values.Split(' ').Except(run.Output.Split('\n', StringSplitOptions.TrimEntries), StringComparer.Ordinal));
    }

    // Every option that takes one of a few words completes them.
    [Fact]
    public void Options_with_words_for_values_complete_them()
    {
        var without = new List<string>();
        Look(CommandTree.Build());
        Assert.Empty(without);

        void Look(Command command)
        {
            foreach (var option in command.Options.Where(o => o.HelpName is "NAME|FILE.json" or "ROLE" or "STATE" or "M" or "KIND"))
            {
                if (!option.GetCompletions(System.CommandLine.Completions.CompletionContext.Empty).Any())
                {
                    without.Add($"{command.Name} {option.Name}");
                }
            }

            foreach (var below in command.Subcommands)
            {
                Look(below);
            }
        }
    }
}
