using System.CommandLine;
using System.Globalization;
using System.Text.Json;

namespace ErrorMatching.Console;

/// <summary><c>errormatch help</c>: what <c>--help</c> of a command prints.</summary>
internal sealed class HelpVerb : Verb
{
    /// <summary>The word on the command line.</summary>
    public const string Word = "help";

    private readonly Argument<string[]> _words = new("VERB")
    {
        Description = "The words of a command, such as nc check. Without any, the help of all is shown.",
        Arity = ArgumentArity.ZeroOrMore,
        HelpName = "VERB",
    };

    public HelpVerb()
        : base(Word, "Shows the help of a command.", "errormatch help nc check")
    {
        _words.CompletionSources.Add(
            context => Below(context.ParseResult.GetValue(_words) ?? []).Select(c => new System.CommandLine.Completions.CompletionItem(c)));
        Arguments.Add(_words);
    }

    public override VerbResult Run(ParseResult arguments, CancellationToken cancellation)
    {
        var words = arguments.GetValue(_words) ?? [];
        var parsed = CommandTree.Parse(words);
        return words.Length > 0 && parsed.CommandResult.Command is not Verb && parsed.UnmatchedTokens.Count > 0
            ? FailureOfCommandLine.Of(parsed)!
            : new HelpAnswer(words);
    }

    // The commands that may follow; a word that is only begun is none yet.
    private static IEnumerable<string> Below(IReadOnlyList<string> words)
    {
        Command at = CommandTree.Build();
        foreach (var word in words)
        {
            at = at.Subcommands.FirstOrDefault(c => c.Name == word) ?? at;
        }

        return at.Subcommands.Select(c => c.Name);
    }
}

/// <summary>The help of a command.</summary>
/// <param name="words">The command's words.</param>
internal sealed class HelpAnswer(IReadOnlyList<string> words) : DocumentAnswer
{
    public override string Schema => "errormatch/help/1";

    public override void WriteJson(Utf8JsonWriter json) => json.WriteString("help", Text());

    public override void WriteText(Page page) => page.Text(Text());

    private string Text()
    {
        using var text = new StringWriter(CultureInfo.InvariantCulture) { NewLine = "\n" };
        CommandTree.WriteHelp(words, text);
        return text.ToString();
    }
}
