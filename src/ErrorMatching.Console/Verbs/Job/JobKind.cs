using System.CommandLine;

namespace ErrorMatching.Console;

/// <summary>The argument that says which kind of job is meant.</summary>
internal static class JobKind
{
    private const string Mating = "mating";
    private const string Freeform = "freeform";

    /// <summary>The argument of a verb. Free-form jobs are known by name, so that asking for one is answered and not misread.</summary>
    public static Argument<string> Argument()
    {
        var kind = new Argument<string>("KIND") { Description = "mating.", HelpName = "KIND" };
        kind.Validators.Add(result =>
        {
            if (result.Tokens is [{ Value: not Mating } token])
            {
                result.AddError(token.Value == Freeform
                    ? "Free-form jobs are not there yet; mating is."
                    : $"The kind of job is {token.Value}; expected {Mating}.");
            }
        });
        return kind;
    }
}
