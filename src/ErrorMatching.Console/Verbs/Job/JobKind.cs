using System.CommandLine;

namespace ErrorMatching.Console;

/// <summary>The argument that selects the kind of job.</summary>
internal static class JobKind
{
    /// <summary>A job that makes a counterpart fit its part.</summary>
    public const string Mating = "mating";

    /// <summary>A job that mirrors the error of a free-form surface.</summary>
    public const string Freeform = "freeform";

    /// <summary>The configuration of a cell, which is created and described like a job.</summary>
    public const string Cell = "cell";

    /// <summary>The argument of a verb.</summary>
    public static Argument<string> Argument()
    {
        var kind = new Argument<string>("KIND") { Description = $"{Mating}, {Freeform} or {Cell}.", HelpName = "KIND" };
        kind.Validators.Add(result =>
        {
            if (result.Tokens is [{ Value: not (Mating or Freeform or Cell) } token])
            {
                result.AddError($"The kind of job is {token.Value}; expected {Mating}, {Freeform} or {Cell}.");
            }
        });
        kind.CompletionSources.Add(Mating, Freeform, Cell);
        return kind;
    }
}
