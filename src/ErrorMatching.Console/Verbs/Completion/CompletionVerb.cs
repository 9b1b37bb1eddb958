using System.CommandLine;

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
