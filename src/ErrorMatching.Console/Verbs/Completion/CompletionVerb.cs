using System.CommandLine;
using System.Text.Json;

namespace ErrorMatching.Console;

/// <summary><c>errormatch completion</c>.</summary>
internal sealed class CompletionVerb : Verb
{
    private readonly Argument<string> _shell = new("SHELL") { Description = $"{string.Join(", ", CompletionScript.Shells)}." };

    public CompletionVerb()
        : base("completion", "Prints a script that completes commands and options in a shell.", "errormatch completion bash")
    {
        _shell.AcceptOnlyFromAmong([.. CompletionScript.Shells]);
        Arguments.Add(_shell);
    }

    public override VerbResult Run(ParseResult arguments, CancellationToken cancellation) =>
        new CompletionAnswer(arguments.GetRequiredValue(_shell));
}

/// <summary>The script of a shell.</summary>
internal sealed class CompletionAnswer(string shell) : DocumentAnswer
{
    public override string Schema => "errormatch/completion/1";

    public override void WriteJson(Utf8JsonWriter json)
    {
        json.WriteString("shell", shell);
        json.WriteString("script", CompletionScript.Of(shell));
    }

    public override void WriteText(Page page) => page.Text(CompletionScript.Of(shell));
}
